/*
This file contains MuJoCo, Copyright DeepMind Technologies Limited, licensed under the Apache License, Version 2.0
(https://www.apache.org/licenses/LICENSE-2.0), and three.js:

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var O0={en:"English",zh:"中文"},tc={en:{title:"MiniQuadruped: a robot that learned to walk",tagline:"It learned to walk by trial and error. Drive it, push it, change its world: everything runs in this file.",other_language:"中文",loading:"Loading the physics …",failed:"The page cannot run here: {}",steer:"Steer",steer_hint:"Arrow keys, the stick below, or a gamepad. Forward speed stays, turning springs back.",speed_limit:"Speed limit",stop:"Stop",disturb:"Push",disturb_hint:"Click on the robot: it is pushed away from you.",push_strength:"Strength",push:"Random push",ground:"Ground",terrain:"Terrain",slope:"Slope",friction:"Friction",robot:"Robot",payload:"Payload",amplitude:"Gait amplitude",frequency:"Gait frequency",gait_hint:"They change the scripted gait to which the policy adds.",compare:"Scripted gait next to it",compare_hint:"The orange robot repeats a fixed motion and feels nothing.",follow:"Camera follows",standard:"Reset all settings",pause:"Pause",resume:"Resume",reset:"Reset",slow:"Slow motion",settings:"Settings",speed:"Speed",commanded:"commanded",turning:"Turning",distance:"Distance",feet:"Feet on the ground",fell:"It fell. It stands up again in a moment.",keys:"↑ ↓ speed · ← → turn · 0 stop · space pause · P push · R reset · C scripted gait · M slow motion",engine:"MuJoCo {} (WebAssembly)",checking:"comparing with Python …",check:"{} s at {} m/s: {} m here, {} m in Python with MuJoCo {}. They differ by {} cm.",about:"Policy “{}”, MiniQuadruped {}. Physics: MuJoCo (Google DeepMind, Apache-2.0). Drawing: three.js (MIT).",other:"Scripted gait: {} m/s, {} m; falls {}, policy {}",terrains:{flat:"flat",rough:"rough",hills:"hills",slope:"slopes",steps:"blocks",stairs:"stairs",gaps:"trenches",wave:"waves"}},zh:{title:"MiniQuadruped：学会走路的机器人",tagline:"它通过反复试错学会了走路。驾驶它，推它，改变它的世界：一切都在这个文件里运行。",other_language:"English",loading:"正在加载物理引擎……",failed:"页面无法在此运行：{}",steer:"驾驶",steer_hint:"方向键、下面的摇杆或手柄。前进速度保持不变，松手后停止转向。",speed_limit:"限速",stop:"停止",disturb:"推",disturb_hint:"点击机器人，把它朝远离你的方向推。",push_strength:"力度",push:"随机推一下",ground:"地面",terrain:"地形",slope:"坡度",friction:"摩擦系数",robot:"机器人",payload:"负载",amplitude:"步态幅度",frequency:"步态频率",gait_hint:"它们改变脚本步态，策略在此基础上修正。",compare:"旁边显示脚本步态",compare_hint:"橙色机器人只重复固定的动作，没有任何感知。",follow:"镜头跟随",standard:"恢复全部设置",pause:"暂停",resume:"继续",reset:"重置",slow:"慢动作",settings:"设置",speed:"速度",commanded:"指令",turning:"转向",distance:"距离",feet:"着地的脚",fell:"它摔倒了，马上会重新站起来。",keys:"↑ ↓ 速度 · ← → 转向 · 0 停止 · 空格 暂停 · P 推 · R 重置 · C 脚本步态 · M 慢动作",engine:"MuJoCo {}（WebAssembly）",checking:"正在与 Python 比较……",check:"以 {1} m/s 走 {0} 秒：这里 {2} m，Python（MuJoCo {4}）{3} m，相差 {5} cm。",about:"策略“{}”，MiniQuadruped {}。物理：MuJoCo（Google DeepMind，Apache-2.0）。绘图：three.js（MIT）。",other:"脚本步态：{} m/s，{} m；摔倒 {} 次，策略 {} 次",terrains:{flat:"平地",rough:"崎岖",hills:"丘陵",slope:"斜坡",steps:"方块",stairs:"台阶",gaps:"沟壑",wave:"波浪"}}};function La(i=navigator.languages){return i.map(e=>e.slice(0,2)).find(e=>e in O0)??"en"}function Xn(i,e,...t){let n=0;return tc[i][e].replace(/\{(\d?)\}/g,(s,o)=>t[o===""?n++:Number(o)])}var tt=i=>document.getElementById(i),B0=Math.PI/180,nc=.15,Fa=class{constructor(e){Object.assign(this,{page:e,held:new Set,stick:null,gamepad:!1});let{control:t,robot:n,gait:s,policy:o}=e.walk.content,[l,h]=t.forward,{walk:f}=e;this.sliders={limit:[t.key_steps[0],h,h,d=>`${d.toFixed(2)} m/s`,d=>{e.limit=d,this.steer()}],strength:[.1,1.5,.6,d=>`${(d*Math.sqrt(f.scale)).toFixed(2)} m/s`,d=>{e.strength=d*Math.sqrt(f.scale)}],slope:[-12,12,0,d=>`${d.toFixed(0)}°`,d=>e.set({slope:d*B0})],friction:[.1,1.5,n.friction,d=>d.toFixed(2),d=>e.set({friction:d})],payload:[0,n.mass/2,0,d=>`${d.toFixed(n.mass<2?2:1)} kg`,d=>e.set({payload:d})],amplitude:[0,2,1,d=>`${d.toFixed(2)}×`,d=>e.set({amplitude:d})],frequency:[.5,1.5,1,d=>`${d.toFixed(2)}×`,d=>e.set({frequency:d})]};for(let[d,[m,y,g,x,E]]of Object.entries(this.sliders)){let C=tt(d),S=C.closest("label").querySelector("output");Object.assign(C,{min:m,max:y,step:d==="slope"?1:.01,value:g}),C.addEventListener("input",()=>{S.textContent=x(C.valueAsNumber),E(C.valueAsNumber)}),S.textContent=x(g)}e.limit=h,e.strength=this.sliders.strength[2]*Math.sqrt(f.scale),this.low=l,tt("frequency").closest("label").hidden=!("gait_phase"in o.inputs),tt("amplitude").closest("label").hidden=!o.nodes.some(([,,d])=>d==="gait_swing"),tt("gait").hidden=tt("frequency").closest("label").hidden&&tt("amplitude").closest("label").hidden,tt("beside").hidden=tt("beside_hint").hidden=!s;for(let{name:d}of f.terrains)tt("terrain").append(new Option(d,d,!1,d===f.settings.terrain));tt("terrain").addEventListener("change",()=>e.setTerrain(tt("terrain").value));for(let[d,m]of Object.entries({pause:()=>e.setPaused(!e.paused),slow:()=>e.setSlow(!e.slow),reset:()=>e.reset(),stop:()=>this.stop(),push:()=>e.pushSomewhere(),language:()=>e.setLanguage(e.language==="en"?"zh":"en"),standard:()=>this.standard(),open:()=>this.toggle()}))tt(d).addEventListener("click",m);tt("compare").addEventListener("change",()=>e.setCompare(tt("compare").checked)),tt("follow").addEventListener("change",()=>{e.view.follow=tt("follow").checked}),this.addKeys(),this.addStick(),this.addClicks()}addKeys(){let e={ArrowUp:.2,ArrowDown:-.2},t={ArrowLeft:1,ArrowRight:-1},n={" ":()=>this.page.setPaused(!this.page.paused),r:()=>this.page.reset(),p:()=>this.page.pushSomewhere(),m:()=>this.page.setSlow(!this.page.slow),0:()=>this.stop(),c:()=>{tt("beside").hidden||(tt("compare").checked=!tt("compare").checked,this.page.setCompare(tt("compare").checked))}};addEventListener("keydown",s=>{let{key:o,target:l}=s;if(!(s.ctrlKey||s.metaKey||s.altKey||l.matches("select, input[type=range]"))&&!(o===" "&&l.matches("button, input"))){if(o in e)this.steer(Math.round(5*(this.page.throttle+e[o]))/5);else if(o in t)this.held.add(o),this.steer(void 0,this.heldTurn(t));else if(o.toLowerCase()in n)n[o.toLowerCase()]();else return;s.preventDefault()}}),addEventListener("keyup",({key:s})=>{this.held.delete(s)&&this.steer(void 0,this.heldTurn(t))}),addEventListener("blur",()=>{this.held.size&&(this.held.clear(),this.steer(void 0,0))})}heldTurn(e){return[...this.held].reduce((t,n)=>t+e[n],0)}addStick(){let e=tt("stick"),t=n=>{let{left:s,top:o,width:l,height:h}=e.getBoundingClientRect(),f=.36,d=((n.clientX-s)/l-.5)/f,m=(.5-(n.clientY-o)/h)/f;this.steer(Math.abs(m)<nc?0:m,Math.abs(d)<nc?0:-d)};e.addEventListener("pointerdown",n=>{e.setPointerCapture(n.pointerId),t(n)}),e.addEventListener("pointermove",n=>{e.hasPointerCapture(n.pointerId)&&t(n)});for(let n of["pointerup","pointercancel"])e.addEventListener(n,()=>this.steer(void 0,0))}pollGamepad(){let e=navigator.getGamepads?.().find(o=>o?.connected);if(!e)return;let[t,n]=e.axes.map(o=>Math.abs(o)<nc?0:o);(t||n||this.gamepad)&&this.steer(-n,-t),this.gamepad=!!(t||n);let s=e.buttons[0]?.pressed;s&&!this.pressed&&this.page.pushSomewhere(),this.pressed=s}steer(e=this.page.throttle,t=this.page.turn){let{page:n}=this,s=l=>Math.min(1,Math.max(-1,l));Object.assign(n,{throttle:s(e),turn:s(t)});let o=n.throttle<0?Math.max(n.throttle*n.limit,this.low):n.throttle*n.limit;n.walk.request=[o,n.turn*n.walk.content.control.turn[1]],tt("knob").style.transform=`translate(${-36*n.turn}%, ${-36*n.throttle}%) translate(${-n.turn*30}px, ${-n.throttle*30}px)`}stop(){this.steer(0,0)}addClicks(){let e=tt("view"),t=s=>{let{left:o,top:l}=e.getBoundingClientRect();return[s.clientX-o,s.clientY-l]},n=null;e.addEventListener("pointerdown",s=>{n=t(s)}),e.addEventListener("pointerup",s=>{let[o,l]=t(s);if(n&&Math.hypot(o-n[0],l-n[1])<6){let h=this.page.view.pick(o,l);h&&this.page.push(h.direction,[h.index])}n=null}),e.addEventListener("pointermove",s=>{s.buttons||e.classList.toggle("aim",this.page.view.pick(...t(s))!==null)})}standard(){for(let[e,[,,t,n,s]]of Object.entries(this.sliders))tt(e).value=t,tt(e).closest("label").querySelector("output").textContent=n(t),s(t);this.page.set({friction:null}),tt("terrain").value=this.page.walk.content.terrain,this.page.setTerrain(tt("terrain").value)}toggle(e=!tt("panel").classList.contains("open")){tt("panel").classList.toggle("open",e),document.body.classList.toggle("sheet",e),tt("open").setAttribute("aria-expanded",e),tt("open").textContent=e?"✕":"⚙",this.page.view.resize()}translate(){let{language:e,walk:t,paused:n}=this.page,s=(h,...f)=>Xn(e,h,...f);document.documentElement.lang=e==="zh"?"zh-CN":"en",document.title=s("title");for(let h of document.querySelectorAll("[data-text]"))h.textContent=s(h.dataset.text);for(let h of document.querySelectorAll("[data-label]"))h.ariaLabel=h.title=s(h.dataset.label);for(let h of tt("terrain").options)h.textContent=tc[e].terrains[h.value]??h.value;let{name:o,versions:l}=t.content;tt("engine").textContent=s("engine",t.mujoco.mj_versionString()),tt("about").textContent=s("about",o,l.mini_quadruped),this.showPaused(n),this.showCheck()}showPaused(e){tt("pause").textContent=e?"▶":"❚❚",tt("pause").title=tt("pause").ariaLabel=Xn(this.page.language,e?"resume":"pause")}showSlow(e){tt("slow").setAttribute("aria-pressed",e)}showCheck(){let{page:e}=this,{language:t,checked:n}=e;tt("check").textContent=n?Xn(t,"check",n.seconds,n.speed,n.here.toFixed(2),n.there.toFixed(2),e.walk.content.versions.mujoco,(100*Math.abs(n.here-n.there)).toFixed(1)):Xn(t,"checking")}tell(e,...t){tt("message").hidden=!e,e&&(tt("message").textContent=Xn(this.page.language,e,...t))}show(){let{walk:e,language:t}=this.page,[n]=e.walkers,s=h=>h.toFixed(2).replace(/^-(?=0\.00$)/,""),o=h=>`${Xn(t,"commanded")} ${s(h)}`;tt("speed").textContent=`${s(n.speed)} m/s`,tt("wanted").textContent=o(n.command[0]),tt("rate").textContent=`${s(n.rate)} rad/s`,tt("wanted_rate").textContent=o(n.command[1]),tt("distance").textContent=`${n.travelled.toFixed(1)} m`,tt("time").textContent=`${e.time.toFixed(1)} s`;let[,l]=e.walkers;tt("other").hidden=!l,l&&(tt("other").textContent=Xn(t,"other",s(l.speed),l.travelled.toFixed(1),l.falls,n.falls)),n.downFor>.1?this.tell("fell"):this.tell(null)}};var k0="#57616d",z0="#e3e8ee",Na=class{constructor(e,t,n){Object.assign(this,{canvas:e,legs:t,length:Math.round(2.5/n),history:[]})}clear(){this.history=[]}record(e){this.history.push(e),this.history.length>this.length&&this.history.shift()}draw(){let{canvas:e,legs:t,history:n,length:s}=this,o=devicePixelRatio||1,l=e.clientWidth,h=e.clientHeight;if(!l)return;let f=[l*o,h*o].map(Math.round);(e.width!==f[0]||e.height!==f[1])&&([e.width,e.height]=f);let d=e.getContext("2d"),m=26,y=h/t.length,g=(l-m)/s;d.setTransform(o,0,0,o,0,0),d.clearRect(0,0,l,h),d.font="11px system-ui, sans-serif",d.textBaseline="middle",t.forEach(({name:x,colour:E},C)=>{let S=C*y+.18*y,v=.64*y,P=s-n.length;d.fillStyle=k0,d.fillText(x.slice(0,3),0,C*y+y/2),d.fillStyle=z0,d.fillRect(m,S,l-m,v),d.fillStyle=E;for(let U=0;U<n.length;U++){if(!n[U][C])continue;let I=U;for(;I+1<n.length&&n[I+1][C];)I++;d.fillRect(m+(P+U)*g,S,(I-U+1)*g,v),U=I}})}};var Li=i=>(e,t)=>{let n=new Float32Array(Math.max(e.length,t.length)),[s,o]=[e.length>1?1:0,t.length>1?1:0];return[n,()=>{for(let l=0;l<n.length;l++)n[l]=i(e[s*l],t[o*l])}]},xn=i=>e=>{let t=new Float32Array(e.length);return[t,()=>{for(let n=0;n<t.length;n++)t[n]=i(e[n])}]},mu=(i,e,t)=>{let n=i.length,s=e.length/n,o=new Float32Array(s),l=new Float64Array(s);return[o,()=>{t?l.set(t):l.fill(0);for(let h=0,f=0;h<n;h++){let d=i[h];for(let m=0;m<s;m++,f++)l[m]+=d*e[f]}o.set(l)}]},G0=i=>1/(1+Math.exp(-i)),V0=i=>Math.max(i,0)+Math.log1p(Math.exp(-Math.abs(i))),H0=i=>{let e=1/(1+.3275911*Math.abs(i)),t=e*(.254829592+e*(-.284496736+e*(1.421413741+e*(-1.453152027+e*1.061405429))));return Math.sign(i)*(1-t*Math.exp(-i*i))},gu={Add:Li((i,e)=>i+e),Sub:Li((i,e)=>i-e),Mul:Li((i,e)=>i*e),Div:Li((i,e)=>i/e),Max:Li(Math.max),Min:Li(Math.min),Mod:Li((i,e)=>i%e),Greater:Li((i,e)=>+(i>e)),Abs:xn(Math.abs),Sign:xn(Math.sign),Sqrt:xn(Math.sqrt),Sin:xn(Math.sin),Cos:xn(Math.cos),Tanh:xn(Math.tanh),Erf:xn(H0),Sigmoid:xn(G0),Softplus:xn(V0),Relu:xn(i=>Math.max(i,0)),LeakyRelu:xn(i=>i<0?.01*i:i),Elu:xn(i=>i<0?Math.expm1(i):i),Selu:xn(i=>1.0507009873554805*(i<0?1.6732632423543772*Math.expm1(i):i)),Cast:xn(i=>i),IsNaN:xn(i=>Number(Number.isNaN(i))),MatMul:mu,Gemm:mu,Concat:(...i)=>{let e=new Float32Array(i.reduce((t,n)=>t+n.length,0));return[e,()=>{let t=0;for(let n of i)e.set(n,t),t+=n.length}]},Where:(i,e,t)=>{let n=new Float32Array(i.length);return[n,()=>{for(let s=0;s<n.length;s++)n[s]=i[s]?e[s]:t[s]}]},Slice:(i,[e],[t])=>{let n=new Float32Array(t-e);return[n,()=>n.set(i.subarray(e,t))]}},xw=Object.keys(gu);function W0(i){return new Float32Array(Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer)}var sr=class{constructor({nodes:e,constants:t,inputs:n,outputs:s}){this.inputs=Object.fromEntries(Object.entries(n).map(([o,l])=>[o,new Float32Array(l)])),this.outputs=s,this.values={...this.inputs};for(let[o,l]of Object.entries(t))this.values[o]=W0(l);this.steps=e.map(([o,l,h])=>{let[f,d]=gu[o](...l.map(m=>this.values[m]));return this.values[h]=f,[d,h,f]})}run(e,t={}){for(let[n,s]of Object.entries(this.inputs))s.set(e[n]);for(let[n,s,o]of this.steps)if(n(),t[s]!==void 0)for(let l=0;l<o.length;l++)o[l]*=t[s];return Object.fromEntries(this.outputs.map(n=>[n,this.values[n]]))}};var X0=(async function(i={}){var e,t=i,n=typeof window=="object",s=typeof WorkerGlobalScope<"u",o=typeof process=="object"&&process.versions?.node&&process.type!="renderer",l=!n&&!o&&!s;if(o){let{createRequire:r}=await import("module");var h=r(import.meta.url)}var f=[],d="./this.program",m=(r,a)=>{throw a},y=import.meta.url,g="";function x(r){return t.locateFile?t.locateFile(r,g):g+r}var E,C;if(o){if(!(typeof process=="object"&&process.versions?.node&&process.type!="renderer"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");var S=process.versions.node,v=S.split(".").slice(0,3);if(v=v[0]*1e4+v[1]*100+v[2].split("-")[0]*1,v<16e4)throw new Error("This emscripten-generated code requires node v16.0.0 (detected v"+S+")");var P=h("fs");y.startsWith("file:")&&(g=h("path").dirname(h("url").fileURLToPath(y))+"/"),C=a=>{a=ne(a)?new URL(a):a;var c=P.readFileSync(a);return G(Buffer.isBuffer(c)),c},E=async(a,c=!0)=>{a=ne(a)?new URL(a):a;var u=P.readFileSync(a,c?void 0:"utf8");return G(c?Buffer.isBuffer(u):typeof u=="string"),u},process.argv.length>1&&(d=process.argv[1].replace(/\\/g,"/")),f=process.argv.slice(2),m=(a,c)=>{throw process.exitCode=a,c}}else if(l){if(typeof process=="object"&&process.versions?.node&&process.type!="renderer"||typeof window=="object"||typeof WorkerGlobalScope<"u")throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)")}else if(n||s){try{g=new URL(".",y).href}catch{}if(!(typeof window=="object"||typeof WorkerGlobalScope<"u"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");s&&(C=r=>{var a=new XMLHttpRequest;return a.open("GET",r,!1),a.responseType="arraybuffer",a.send(null),new Uint8Array(a.response)}),E=async r=>{if(ne(r))return new Promise((c,u)=>{var p=new XMLHttpRequest;p.open("GET",r,!0),p.responseType="arraybuffer",p.onload=()=>{if(p.status==200||p.status==0&&p.response){c(p.response);return}u(p.status)},p.onerror=u,p.send(null)});var a=await fetch(r,{credentials:"same-origin"});if(a.ok)return a.arrayBuffer();throw new Error(a.status+" : "+a.url)}}else throw new Error("environment detection error");var U=console.log.bind(console),I=console.error.bind(console),O="IDBFS is no longer included by default; build with -lidbfs.js",N="PROXYFS is no longer included by default; build with -lproxyfs.js",b="WORKERFS is no longer included by default; build with -lworkerfs.js",D="FETCHFS is no longer included by default; build with -lfetchfs.js",q="ICASEFS is no longer included by default; build with -licasefs.js",k="JSFILEFS is no longer included by default; build with -ljsfilefs.js",Y="OPFS is no longer included by default; build with -lopfs.js",J="NODEFS is no longer included by default; build with -lnodefs.js";G(!l,"shell environment detected but not enabled at build time.  Add `shell` to `-sENVIRONMENT` to enable.");var ee;typeof WebAssembly!="object"&&I("no native wasm support detected");var z=!1,ie;function G(r,a){r||pe("Assertion failed"+(a?": "+a:""))}var ne=r=>r.startsWith("file://");function Se(){var r=Kl();G((r&3)==0),r==0&&(r+=4),$e[r>>2]=34821223,$e[r+4>>2]=2310721022,$e[0]=1668509029}function re(){if(!z){var r=Kl();r==0&&(r+=4);var a=$e[r>>2],c=$e[r+4>>2];(a!=34821223||c!=2310721022)&&pe(`Stack overflow! Stack cookie has been overwritten at ${Bt(r)}, expected hex dwords 0x89BACDFE and 0x2135467, but received ${Bt(c)} ${Bt(a)}`),$e[0]!=1668509029&&pe("Runtime error: The application has corrupted its heap memory area (address zero)!")}}class H extends Error{}class ge extends H{}class We extends H{constructor(a){super(a),this.excPtr=a;let c=eu(a);this.name=c[0],this.message=c[1]}}var rt=!0;function ue(...r){!rt&&typeof rt<"u"||console.warn(...r)}(()=>{var r=new Int16Array(1),a=new Int8Array(r.buffer);if(r[0]=25459,a[0]!==115||a[1]!==99)throw"Runtime error: expected the system to be little-endian! (Run with -sSUPPORT_BIG_ENDIAN to bypass)"})();function Fe(r){Object.getOwnPropertyDescriptor(t,r)||Object.defineProperty(t,r,{configurable:!0,set(){pe(`Attempt to set \`Module.${r}\` after it has already been processed.  This can happen, for example, when code is injected via '--post-js' rather than '--pre-js'`)}})}function Pe(r){return()=>G(!1,`call to '${r}' via reference taken before Wasm module initialization`)}function je(r){Object.getOwnPropertyDescriptor(t,r)&&pe(`\`Module.${r}\` was supplied but \`${r}\` not included in INCOMING_MODULE_JS_API`)}function Ue(r){return r==="FS_createPath"||r==="FS_createDataFile"||r==="FS_createPreloadedFile"||r==="FS_unlink"||r==="addRunDependency"||r==="FS_createLazyFile"||r==="FS_createDevice"||r==="removeRunDependency"}function ot(r,a){typeof globalThis<"u"&&!Object.getOwnPropertyDescriptor(globalThis,r)&&Object.defineProperty(globalThis,r,{configurable:!0,get(){a()}})}function Vt(r,a){ot(r,()=>{Qn(`\`${r}\` is not longer defined by emscripten. ${a}`)})}Vt("buffer","Please use HEAP8.buffer or wasmMemory.buffer"),Vt("asm","Please use wasmExports instead");function Ke(r){ot(r,()=>{var a=`\`${r}\` is a library symbol and not included by default; add it to your library.js __deps or to DEFAULT_LIBRARY_FUNCS_TO_INCLUDE on the command line`,c=r;c.startsWith("_")||(c="$"+r),a+=` (e.g. -sDEFAULT_LIBRARY_FUNCS_TO_INCLUDE='${c}')`,Ue(r)&&(a+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),Qn(a)}),Et(r)}function Et(r){Object.getOwnPropertyDescriptor(t,r)||Object.defineProperty(t,r,{configurable:!0,get(){var a=`'${r}' was not exported. add it to EXPORTED_RUNTIME_METHODS (see the Emscripten FAQ)`;Ue(r)&&(a+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),pe(a)}})}var Rt,mt,Ht,pt,It,Mt,rn,De,$e,hn,sn,W,vn,Ct=!1;function Ut(){var r=Ht.buffer;pt=new Int8Array(r),Mt=new Int16Array(r),It=new Uint8Array(r),rn=new Uint16Array(r),De=new Int32Array(r),$e=new Uint32Array(r),hn=new Float32Array(r),sn=new Float64Array(r),W=new BigInt64Array(r),vn=new BigUint64Array(r)}G(typeof Int32Array<"u"&&typeof Float64Array<"u"&&Int32Array.prototype.subarray!=null&&Int32Array.prototype.set!=null,"JS engine does not provide full typed array support");function Le(){if(t.preRun)for(typeof t.preRun=="function"&&(t.preRun=[t.preRun]);t.preRun.length;)dt(t.preRun.shift());Fe("preRun"),Xe(qe)}function $t(){G(!Ct),Ct=!0,re(),!t.noFSInit&&!M.initialized&&M.init(),lt.init(),ir.__wasm_call_ctors(),M.ignorePermissions=!1}function Ze(){if(re(),t.postRun)for(typeof t.postRun=="function"&&(t.postRun=[t.postRun]);t.postRun.length;)we(t.postRun.shift());Fe("postRun"),Xe(ut)}var Je=0,L=null,T={},Z=null;function ve(r){Je++,t.monitorRunDependencies?.(Je),r?(G(!T[r]),T[r]=1,Z===null&&typeof setInterval<"u"&&(Z=setInterval(()=>{if(z){clearInterval(Z),Z=null;return}var a=!1;for(var c in T)a||(a=!0,I("still waiting on run dependencies:")),I(`dependency: ${c}`);a&&I("(end of list)")},1e4))):I("warning: run dependency added without ID")}function de(r){if(Je--,t.monitorRunDependencies?.(Je),r?(G(T[r]),delete T[r]):I("warning: run dependency removed without ID"),Je==0&&(Z!==null&&(clearInterval(Z),Z=null),L)){var a=L;L=null,a()}}function pe(r){t.onAbort?.(r),r="Aborted("+r+")",I(r),z=!0;var a=new WebAssembly.RuntimeError(r);throw mt?.(a),a}function Me(r,a){return(...c)=>{G(Ct,`native function \`${r}\` called before runtime initialization`);var u=ir[r];return G(u,`exported native function \`${r}\` not found`),G(c.length<=a,`native function \`${r}\` called with ${c.length} args but expects ${a}`),u(...c)}}var ae;function le(){return t.locateFile?x("mujoco.wasm"):new URL("mujoco.wasm",import.meta.url).href}function Re(r){if(r==ae&&ee)return new Uint8Array(ee);if(C)return C(r);throw"both async and sync fetching of the wasm failed"}async function B(r){if(!ee)try{var a=await E(r);return new Uint8Array(a)}catch{}return Re(r)}async function he(r,a){try{var c=await B(r),u=await WebAssembly.instantiate(c,a);return u}catch(p){I(`failed to asynchronously prepare wasm: ${p}`),ne(ae)&&I(`warning: Loading from a file URI (${ae}) is not supported in most browsers. See https://emscripten.org/docs/getting_started/FAQ.html#how-do-i-run-a-local-webserver-for-testing-why-does-my-program-stall-in-downloading-or-preparing`),pe(p)}}async function se(r,a,c){if(!r&&typeof WebAssembly.instantiateStreaming=="function"&&!ne(a)&&!o)try{var u=fetch(a,{credentials:"same-origin"}),p=await WebAssembly.instantiateStreaming(u,c);return p}catch(_){I(`wasm streaming compile failed: ${_}`),I("falling back to ArrayBuffer instantiation")}return he(a,c)}function Ce(){return{env:du,wasi_snapshot_preview1:du}}async function Ee(){function r(w,A){return ir=w.exports,Ht=ir.memory,G(Ht,"memory not found in wasm exports"),Ut(),wa=ir.__indirect_function_table,G(wa,"table not found in wasm exports"),km(ir),de("wasm-instantiate"),ir}ve("wasm-instantiate");var a=t;function c(w){return G(t===a,"the Module object should not be replaced during async compilation - perhaps the order of HTML elements is wrong?"),a=null,r(w.instance)}var u=Ce();if(t.instantiateWasm)return new Promise((w,A)=>{try{t.instantiateWasm(u,(F,X)=>{w(r(F,X))})}catch(F){I(`Module.instantiateWasm callback failed with error: ${F}`),A(F)}});ae??=le();var p=await se(ee,ae,u),_=c(p);return _}class Ae{name="ExitStatus";constructor(a){this.message=`Program terminated with exit(${a})`,this.status=a}}var Xe=r=>{for(;r.length>0;)r.shift()(t)},ut=[],we=r=>ut.push(r),qe=[],dt=r=>qe.push(r);function Oe(r,a="i8"){switch(a.endsWith("*")&&(a="*"),a){case"i1":return pt[r];case"i8":return pt[r];case"i16":return Mt[r>>1];case"i32":return De[r>>2];case"i64":return W[r>>3];case"float":return hn[r>>2];case"double":return sn[r>>3];case"*":return $e[r>>2];default:pe(`invalid type for getValue: ${a}`)}}var Tt=!0,Bt=r=>(G(typeof r=="number"),r>>>=0,"0x"+r.toString(16).padStart(8,"0"));function _i(r,a,c="i8"){switch(c.endsWith("*")&&(c="*"),c){case"i1":pt[r]=a;break;case"i8":pt[r]=a;break;case"i16":Mt[r>>1]=a;break;case"i32":De[r>>2]=a;break;case"i64":W[r>>3]=BigInt(a);break;case"float":hn[r>>2]=a;break;case"double":sn[r>>3]=a;break;case"*":$e[r>>2]=a;break;default:pe(`invalid type for setValue: ${c}`)}}var ye=r=>au(r),_e=()=>lu(),Qn=r=>{Qn.shown||={},Qn.shown[r]||(Qn.shown[r]=1,o&&(r="warning: "+r),I(r))},rs=typeof TextDecoder<"u"?new TextDecoder:void 0,vi=(r,a=0,c=NaN)=>{for(var u=a+c,p=a;r[p]&&!(p>=u);)++p;if(p-a>16&&r.buffer&&rs)return rs.decode(r.subarray(a,p));for(var _="";a<p;){var w=r[a++];if(!(w&128)){_+=String.fromCharCode(w);continue}var A=r[a++]&63;if((w&224)==192){_+=String.fromCharCode((w&31)<<6|A);continue}var F=r[a++]&63;if((w&240)==224?w=(w&15)<<12|A<<6|F:((w&248)!=240&&Qn("Invalid UTF-8 leading byte "+Bt(w)+" encountered when deserializing a UTF-8 string in wasm memory to a JS string!"),w=(w&7)<<18|A<<12|F<<6|r[a++]&63),w<65536)_+=String.fromCharCode(w);else{var X=w-65536;_+=String.fromCharCode(55296|X>>10,56320|X&1023)}}return _},un=(r,a)=>(G(typeof r=="number",`UTF8ToString expects a number (got ${typeof r})`),r?vi(It,r,a):""),ss=(r,a,c,u)=>pe(`Assertion failed: ${un(r)}, at: `+[a?un(a):"unknown filename",c,u?un(u):"unknown function"]),Fn=[],Zi=0,yr=r=>{var a=new xr(r);return a.get_caught()||(a.set_caught(!0),Zi--),a.set_rethrown(!1),Fn.push(a),Da(r),uu(r)},fa=()=>{if(!Fn.length)return 0;var r=Fn[Fn.length-1];return Da(r.excPtr),r.excPtr},Nn=0,Ji=()=>{xe(0,0),G(Fn.length>0);var r=Fn.pop();Ql(r.excPtr),Nn=0};class xr{constructor(a){this.excPtr=a,this.ptr=a-24}set_type(a){$e[this.ptr+4>>2]=a}get_type(){return $e[this.ptr+4>>2]}set_destructor(a){$e[this.ptr+8>>2]=a}get_destructor(){return $e[this.ptr+8>>2]}set_caught(a){a=a?1:0,pt[this.ptr+12]=a}get_caught(){return pt[this.ptr+12]!=0}set_rethrown(a){a=a?1:0,pt[this.ptr+13]=a}get_rethrown(){return pt[this.ptr+13]!=0}init(a,c){this.set_adjusted_ptr(0),this.set_type(a),this.set_destructor(c)}set_adjusted_ptr(a){$e[this.ptr+16>>2]=a}get_adjusted_ptr(){return $e[this.ptr+16>>2]}}var Ki=r=>ru(r),Sr=r=>{var a=Nn?.excPtr;if(!a)return Ki(0),0;var c=new xr(a);c.set_adjusted_ptr(a);var u=c.get_type();if(!u)return Ki(0),a;for(var p of r){if(p===0||p===u)break;var _=c.ptr+16;if(hu(p,u,_))return Ki(p),a}return Ki(u),a},Ol=()=>Sr([]),Bl=r=>Sr([r]),kl=(r,a)=>Sr([r,a]),as=()=>{var r=Fn.pop();r||pe("no exception to throw");var a=r.excPtr;throw r.get_rethrown()||(Fn.push(r),r.set_rethrown(!0),r.set_caught(!1),Zi++),Nn=new We(a),Nn},R=r=>{if(r){var a=new xr(r);Fn.push(a),a.set_rethrown(!0),as()}},V=(r,a,c)=>{var u=new xr(r);throw u.init(a,c),Nn=new We(r),Zi++,Nn},te=()=>Zi,K=r=>{throw Nn||(Nn=new We(r)),Nn},$={isAbs:r=>r.charAt(0)==="/",splitPath:r=>{var a=/^(\/?|)([\s\S]*?)((?:\.{1,2}|[^\/]+?|)(\.[^.\/]*|))(?:[\/]*)$/;return a.exec(r).slice(1)},normalizeArray:(r,a)=>{for(var c=0,u=r.length-1;u>=0;u--){var p=r[u];p==="."?r.splice(u,1):p===".."?(r.splice(u,1),c++):c&&(r.splice(u,1),c--)}if(a)for(;c;c--)r.unshift("..");return r},normalize:r=>{var a=$.isAbs(r),c=r.slice(-1)==="/";return r=$.normalizeArray(r.split("/").filter(u=>!!u),!a).join("/"),!r&&!a&&(r="."),r&&c&&(r+="/"),(a?"/":"")+r},dirname:r=>{var a=$.splitPath(r),c=a[0],u=a[1];return!c&&!u?".":(u&&(u=u.slice(0,-1)),c+u)},basename:r=>r&&r.match(/([^\/]+|\/)\/*$/)[1],join:(...r)=>$.normalize(r.join("/")),join2:(r,a)=>$.normalize(r+"/"+a)},Ie=()=>{if(o){var r=h("crypto");return a=>r.randomFillSync(a)}return a=>crypto.getRandomValues(a)},ze=r=>{(ze=Ie())(r)},Te={resolve:(...r)=>{for(var a="",c=!1,u=r.length-1;u>=-1&&!c;u--){var p=u>=0?r[u]:M.cwd();if(typeof p!="string")throw new TypeError("Arguments to path.resolve must be strings");if(!p)return"";a=p+"/"+a,c=$.isAbs(p)}return a=$.normalizeArray(a.split("/").filter(_=>!!_),!c).join("/"),(c?"/":"")+a||"."},relative:(r,a)=>{r=Te.resolve(r).slice(1),a=Te.resolve(a).slice(1);function c(X){for(var Q=0;Q<X.length&&X[Q]==="";Q++);for(var oe=X.length-1;oe>=0&&X[oe]==="";oe--);return Q>oe?[]:X.slice(Q,oe-Q+1)}for(var u=c(r.split("/")),p=c(a.split("/")),_=Math.min(u.length,p.length),w=_,A=0;A<_;A++)if(u[A]!==p[A]){w=A;break}for(var F=[],A=w;A<u.length;A++)F.push("..");return F=F.concat(p.slice(w)),F.join("/")}},Ne=[],Ge=r=>{for(var a=0,c=0;c<r.length;++c){var u=r.charCodeAt(c);u<=127?a++:u<=2047?a+=2:u>=55296&&u<=57343?(a+=4,++c):a+=3}return a},st=(r,a,c,u)=>{if(G(typeof r=="string",`stringToUTF8Array expects a string (got ${typeof r})`),!(u>0))return 0;for(var p=c,_=c+u-1,w=0;w<r.length;++w){var A=r.codePointAt(w);if(A<=127){if(c>=_)break;a[c++]=A}else if(A<=2047){if(c+1>=_)break;a[c++]=192|A>>6,a[c++]=128|A&63}else if(A<=65535){if(c+2>=_)break;a[c++]=224|A>>12,a[c++]=128|A>>6&63,a[c++]=128|A&63}else{if(c+3>=_)break;A>1114111&&Qn("Invalid Unicode code point "+Bt(A)+" encountered when serializing a JS string to a UTF-8 string in wasm memory! (Valid unicode code points should be in range 0-0x10FFFF)."),a[c++]=240|A>>18,a[c++]=128|A>>12&63,a[c++]=128|A>>6&63,a[c++]=128|A&63,w++}}return a[c]=0,c-p},gt=(r,a,c)=>{var u=c>0?c:Ge(r)+1,p=new Array(u),_=st(r,p,0,p.length);return a&&(p.length=_),p},Ve=()=>{if(!Ne.length){var r=null;if(o){var a=256,c=Buffer.alloc(a),u=0,p=process.stdin.fd;try{u=P.readSync(p,c,0,a)}catch(_){if(_.toString().includes("EOF"))u=0;else throw _}u>0&&(r=c.slice(0,u).toString("utf-8"))}else typeof window<"u"&&typeof window.prompt=="function"&&(r=window.prompt("Input: "),r!==null&&(r+=`
`));if(!r)return null;Ne=gt(r,!0)}return Ne.shift()},lt={ttys:[],init(){},shutdown(){},register(r,a){lt.ttys[r]={input:[],output:[],ops:a},M.registerDevice(r,lt.stream_ops)},stream_ops:{open(r){var a=lt.ttys[r.node.rdev];if(!a)throw new M.ErrnoError(43);r.tty=a,r.seekable=!1},close(r){r.tty.ops.fsync(r.tty)},fsync(r){r.tty.ops.fsync(r.tty)},read(r,a,c,u,p){if(!r.tty||!r.tty.ops.get_char)throw new M.ErrnoError(60);for(var _=0,w=0;w<u;w++){var A;try{A=r.tty.ops.get_char(r.tty)}catch{throw new M.ErrnoError(29)}if(A===void 0&&_===0)throw new M.ErrnoError(6);if(A==null)break;_++,a[c+w]=A}return _&&(r.node.atime=Date.now()),_},write(r,a,c,u,p){if(!r.tty||!r.tty.ops.put_char)throw new M.ErrnoError(60);try{for(var _=0;_<u;_++)r.tty.ops.put_char(r.tty,a[c+_])}catch{throw new M.ErrnoError(29)}return u&&(r.node.mtime=r.node.ctime=Date.now()),_}},default_tty_ops:{get_char(r){return Ve()},put_char(r,a){a===null||a===10?(U(vi(r.output)),r.output=[]):a!=0&&r.output.push(a)},fsync(r){r.output?.length>0&&(U(vi(r.output)),r.output=[])},ioctl_tcgets(r){return{c_iflag:25856,c_oflag:5,c_cflag:191,c_lflag:35387,c_cc:[3,28,127,21,4,0,1,0,17,19,26,0,18,15,23,22,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}},ioctl_tcsets(r,a,c){return 0},ioctl_tiocgwinsz(r){return[24,80]}},default_tty1_ops:{put_char(r,a){a===null||a===10?(I(vi(r.output)),r.output=[]):a!=0&&r.output.push(a)},fsync(r){r.output?.length>0&&(I(vi(r.output)),r.output=[])}}},Wt=r=>{pe("internal error: mmapAlloc called but `emscripten_builtin_memalign` native symbol not exported")},ke={ops_table:null,mount(r){return ke.createNode(null,"/",16895,0)},createNode(r,a,c,u){if(M.isBlkdev(c)||M.isFIFO(c))throw new M.ErrnoError(63);ke.ops_table||={dir:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,lookup:ke.node_ops.lookup,mknod:ke.node_ops.mknod,rename:ke.node_ops.rename,unlink:ke.node_ops.unlink,rmdir:ke.node_ops.rmdir,readdir:ke.node_ops.readdir,symlink:ke.node_ops.symlink},stream:{llseek:ke.stream_ops.llseek}},file:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:{llseek:ke.stream_ops.llseek,read:ke.stream_ops.read,write:ke.stream_ops.write,mmap:ke.stream_ops.mmap,msync:ke.stream_ops.msync}},link:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,readlink:ke.node_ops.readlink},stream:{}},chrdev:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:M.chrdev_stream_ops}};var p=M.createNode(r,a,c,u);return M.isDir(p.mode)?(p.node_ops=ke.ops_table.dir.node,p.stream_ops=ke.ops_table.dir.stream,p.contents={}):M.isFile(p.mode)?(p.node_ops=ke.ops_table.file.node,p.stream_ops=ke.ops_table.file.stream,p.usedBytes=0,p.contents=null):M.isLink(p.mode)?(p.node_ops=ke.ops_table.link.node,p.stream_ops=ke.ops_table.link.stream):M.isChrdev(p.mode)&&(p.node_ops=ke.ops_table.chrdev.node,p.stream_ops=ke.ops_table.chrdev.stream),p.atime=p.mtime=p.ctime=Date.now(),r&&(r.contents[a]=p,r.atime=r.mtime=r.ctime=p.atime),p},getFileDataAsTypedArray(r){return r.contents?r.contents.subarray?r.contents.subarray(0,r.usedBytes):new Uint8Array(r.contents):new Uint8Array(0)},expandFileStorage(r,a){var c=r.contents?r.contents.length:0;if(!(c>=a)){var u=1024*1024;a=Math.max(a,c*(c<u?2:1.125)>>>0),c!=0&&(a=Math.max(a,256));var p=r.contents;r.contents=new Uint8Array(a),r.usedBytes>0&&r.contents.set(p.subarray(0,r.usedBytes),0)}},resizeFileStorage(r,a){if(r.usedBytes!=a)if(a==0)r.contents=null,r.usedBytes=0;else{var c=r.contents;r.contents=new Uint8Array(a),c&&r.contents.set(c.subarray(0,Math.min(a,r.usedBytes))),r.usedBytes=a}},node_ops:{getattr(r){var a={};return a.dev=M.isChrdev(r.mode)?r.id:1,a.ino=r.id,a.mode=r.mode,a.nlink=1,a.uid=0,a.gid=0,a.rdev=r.rdev,M.isDir(r.mode)?a.size=4096:M.isFile(r.mode)?a.size=r.usedBytes:M.isLink(r.mode)?a.size=r.link.length:a.size=0,a.atime=new Date(r.atime),a.mtime=new Date(r.mtime),a.ctime=new Date(r.ctime),a.blksize=4096,a.blocks=Math.ceil(a.size/a.blksize),a},setattr(r,a){for(let c of["mode","atime","mtime","ctime"])a[c]!=null&&(r[c]=a[c]);a.size!==void 0&&ke.resizeFileStorage(r,a.size)},lookup(r,a){throw new M.ErrnoError(44)},mknod(r,a,c,u){return ke.createNode(r,a,c,u)},rename(r,a,c){var u;try{u=M.lookupNode(a,c)}catch{}if(u){if(M.isDir(r.mode))for(var p in u.contents)throw new M.ErrnoError(55);M.hashRemoveNode(u)}delete r.parent.contents[r.name],a.contents[c]=r,r.name=c,a.ctime=a.mtime=r.parent.ctime=r.parent.mtime=Date.now()},unlink(r,a){delete r.contents[a],r.ctime=r.mtime=Date.now()},rmdir(r,a){var c=M.lookupNode(r,a);for(var u in c.contents)throw new M.ErrnoError(55);delete r.contents[a],r.ctime=r.mtime=Date.now()},readdir(r){return[".","..",...Object.keys(r.contents)]},symlink(r,a,c){var u=ke.createNode(r,a,41471,0);return u.link=c,u},readlink(r){if(!M.isLink(r.mode))throw new M.ErrnoError(28);return r.link}},stream_ops:{read(r,a,c,u,p){var _=r.node.contents;if(p>=r.node.usedBytes)return 0;var w=Math.min(r.node.usedBytes-p,u);if(G(w>=0),w>8&&_.subarray)a.set(_.subarray(p,p+w),c);else for(var A=0;A<w;A++)a[c+A]=_[p+A];return w},write(r,a,c,u,p,_){if(G(!(a instanceof ArrayBuffer)),a.buffer===pt.buffer&&(_=!1),!u)return 0;var w=r.node;if(w.mtime=w.ctime=Date.now(),a.subarray&&(!w.contents||w.contents.subarray)){if(_)return G(p===0,"canOwn must imply no weird position inside the file"),w.contents=a.subarray(c,c+u),w.usedBytes=u,u;if(w.usedBytes===0&&p===0)return w.contents=a.slice(c,c+u),w.usedBytes=u,u;if(p+u<=w.usedBytes)return w.contents.set(a.subarray(c,c+u),p),u}if(ke.expandFileStorage(w,p+u),w.contents.subarray&&a.subarray)w.contents.set(a.subarray(c,c+u),p);else for(var A=0;A<u;A++)w.contents[p+A]=a[c+A];return w.usedBytes=Math.max(w.usedBytes,p+u),u},llseek(r,a,c){var u=a;if(c===1?u+=r.position:c===2&&M.isFile(r.node.mode)&&(u+=r.node.usedBytes),u<0)throw new M.ErrnoError(28);return u},mmap(r,a,c,u,p){if(!M.isFile(r.node.mode))throw new M.ErrnoError(43);var _,w,A=r.node.contents;if(!(p&2)&&A&&A.buffer===pt.buffer)w=!1,_=A.byteOffset;else{if(w=!0,_=Wt(a),!_)throw new M.ErrnoError(48);A&&((c>0||c+a<A.length)&&(A.subarray?A=A.subarray(c,c+a):A=Array.prototype.slice.call(A,c,c+a)),pt.set(A,_))}return{ptr:_,allocated:w}},msync(r,a,c,u,p){return ke.stream_ops.write(r,a,0,u,c,!1),0}}},Dt=async r=>{var a=await E(r);return G(a,`Loading data file "${r}" failed (no arrayBuffer).`),new Uint8Array(a)},jt=(...r)=>M.createDataFile(...r),He=r=>{for(var a=r;;){if(!T[r])return r;r=a+Math.random()}},an=[],wt=(r,a,c,u)=>{typeof Browser<"u"&&Browser.init();var p=!1;return an.forEach(_=>{p||_.canHandle(a)&&(_.handle(r,a,c,u),p=!0)}),p},ei=(r,a,c,u,p,_,w,A,F,X)=>{var Q=a?Te.resolve($.join2(r,a)):r,oe=He(`cp ${Q}`);function fe(ce){function me(Ye){X?.(),A||jt(r,a,Ye,u,p,F),_?.(),de(oe)}wt(ce,Q,me,()=>{w?.(),de(oe)})||me(ce)}ve(oe),typeof c=="string"?Dt(c).then(fe,w):fe(c)},on=r=>{var a={r:0,"r+":2,w:577,"w+":578,a:1089,"a+":1090},c=a[r];if(typeof c>"u")throw new Error(`Unknown file open mode: ${r}`);return c},Di=(r,a)=>{var c=0;return r&&(c|=365),a&&(c|=146),c},ti=r=>un(iu(r)),ni={EPERM:63,ENOENT:44,ESRCH:71,EINTR:27,EIO:29,ENXIO:60,E2BIG:1,ENOEXEC:45,EBADF:8,ECHILD:12,EAGAIN:6,EWOULDBLOCK:6,ENOMEM:48,EACCES:2,EFAULT:21,ENOTBLK:105,EBUSY:10,EEXIST:20,EXDEV:75,ENODEV:43,ENOTDIR:54,EISDIR:31,EINVAL:28,ENFILE:41,EMFILE:33,ENOTTY:59,ETXTBSY:74,EFBIG:22,ENOSPC:51,ESPIPE:70,EROFS:69,EMLINK:34,EPIPE:64,EDOM:18,ERANGE:68,ENOMSG:49,EIDRM:24,ECHRNG:106,EL2NSYNC:156,EL3HLT:107,EL3RST:108,ELNRNG:109,EUNATCH:110,ENOCSI:111,EL2HLT:112,EDEADLK:16,ENOLCK:46,EBADE:113,EBADR:114,EXFULL:115,ENOANO:104,EBADRQC:103,EBADSLT:102,EDEADLOCK:16,EBFONT:101,ENOSTR:100,ENODATA:116,ETIME:117,ENOSR:118,ENONET:119,ENOPKG:120,EREMOTE:121,ENOLINK:47,EADV:122,ESRMNT:123,ECOMM:124,EPROTO:65,EMULTIHOP:36,EDOTDOT:125,EBADMSG:9,ENOTUNIQ:126,EBADFD:127,EREMCHG:128,ELIBACC:129,ELIBBAD:130,ELIBSCN:131,ELIBMAX:132,ELIBEXEC:133,ENOSYS:52,ENOTEMPTY:55,ENAMETOOLONG:37,ELOOP:32,EOPNOTSUPP:138,EPFNOSUPPORT:139,ECONNRESET:15,ENOBUFS:42,EAFNOSUPPORT:5,EPROTOTYPE:67,ENOTSOCK:57,ENOPROTOOPT:50,ESHUTDOWN:140,ECONNREFUSED:14,EADDRINUSE:3,ECONNABORTED:13,ENETUNREACH:40,ENETDOWN:38,ETIMEDOUT:73,EHOSTDOWN:142,EHOSTUNREACH:23,EINPROGRESS:26,EALREADY:7,EDESTADDRREQ:17,EMSGSIZE:35,EPROTONOSUPPORT:66,ESOCKTNOSUPPORT:137,EADDRNOTAVAIL:4,ENETRESET:39,EISCONN:30,ENOTCONN:53,ETOOMANYREFS:141,EUSERS:136,EDQUOT:19,ESTALE:72,ENOTSUP:138,ENOMEDIUM:148,EILSEQ:25,EOVERFLOW:61,ECANCELED:11,ENOTRECOVERABLE:56,EOWNERDEAD:62,ESTRPIPE:135},M={root:null,mounts:[],devices:{},streams:[],nextInode:1,nameTable:null,currentPath:"/",initialized:!1,ignorePermissions:!0,filesystems:null,syncFSRequests:0,readFiles:{},ErrnoError:class extends Error{name="ErrnoError";constructor(r){super(Ct?ti(r):""),this.errno=r;for(var a in ni)if(ni[a]===r){this.code=a;break}}},FSStream:class{shared={};get object(){return this.node}set object(r){this.node=r}get isRead(){return(this.flags&2097155)!==1}get isWrite(){return(this.flags&2097155)!==0}get isAppend(){return this.flags&1024}get flags(){return this.shared.flags}set flags(r){this.shared.flags=r}get position(){return this.shared.position}set position(r){this.shared.position=r}},FSNode:class{node_ops={};stream_ops={};readMode=365;writeMode=146;mounted=null;constructor(r,a,c,u){r||(r=this),this.parent=r,this.mount=r.mount,this.id=M.nextInode++,this.name=a,this.mode=c,this.rdev=u,this.atime=this.mtime=this.ctime=Date.now()}get read(){return(this.mode&this.readMode)===this.readMode}set read(r){r?this.mode|=this.readMode:this.mode&=~this.readMode}get write(){return(this.mode&this.writeMode)===this.writeMode}set write(r){r?this.mode|=this.writeMode:this.mode&=~this.writeMode}get isFolder(){return M.isDir(this.mode)}get isDevice(){return M.isChrdev(this.mode)}},lookupPath(r,a={}){if(!r)throw new M.ErrnoError(44);a.follow_mount??=!0,$.isAbs(r)||(r=M.cwd()+"/"+r);e:for(var c=0;c<40;c++){for(var u=r.split("/").filter(X=>!!X),p=M.root,_="/",w=0;w<u.length;w++){var A=w===u.length-1;if(A&&a.parent)break;if(u[w]!=="."){if(u[w]===".."){if(_=$.dirname(_),M.isRoot(p)){r=_+"/"+u.slice(w+1).join("/");continue e}else p=p.parent;continue}_=$.join2(_,u[w]);try{p=M.lookupNode(p,u[w])}catch(X){if(X?.errno===44&&A&&a.noent_okay)return{path:_};throw X}if(M.isMountpoint(p)&&(!A||a.follow_mount)&&(p=p.mounted.root),M.isLink(p.mode)&&(!A||a.follow)){if(!p.node_ops.readlink)throw new M.ErrnoError(52);var F=p.node_ops.readlink(p);$.isAbs(F)||(F=$.dirname(_)+"/"+F),r=F+"/"+u.slice(w+1).join("/");continue e}}}return{path:_,node:p}}throw new M.ErrnoError(32)},getPath(r){for(var a;;){if(M.isRoot(r)){var c=r.mount.mountpoint;return a?c[c.length-1]!=="/"?`${c}/${a}`:c+a:c}a=a?`${r.name}/${a}`:r.name,r=r.parent}},hashName(r,a){for(var c=0,u=0;u<a.length;u++)c=(c<<5)-c+a.charCodeAt(u)|0;return(r+c>>>0)%M.nameTable.length},hashAddNode(r){var a=M.hashName(r.parent.id,r.name);r.name_next=M.nameTable[a],M.nameTable[a]=r},hashRemoveNode(r){var a=M.hashName(r.parent.id,r.name);if(M.nameTable[a]===r)M.nameTable[a]=r.name_next;else for(var c=M.nameTable[a];c;){if(c.name_next===r){c.name_next=r.name_next;break}c=c.name_next}},lookupNode(r,a){var c=M.mayLookup(r);if(c)throw new M.ErrnoError(c);for(var u=M.hashName(r.id,a),p=M.nameTable[u];p;p=p.name_next){var _=p.name;if(p.parent.id===r.id&&_===a)return p}return M.lookup(r,a)},createNode(r,a,c,u){G(typeof r=="object");var p=new M.FSNode(r,a,c,u);return M.hashAddNode(p),p},destroyNode(r){M.hashRemoveNode(r)},isRoot(r){return r===r.parent},isMountpoint(r){return!!r.mounted},isFile(r){return(r&61440)===32768},isDir(r){return(r&61440)===16384},isLink(r){return(r&61440)===40960},isChrdev(r){return(r&61440)===8192},isBlkdev(r){return(r&61440)===24576},isFIFO(r){return(r&61440)===4096},isSocket(r){return(r&49152)===49152},flagsToPermissionString(r){var a=["r","w","rw"][r&3];return r&512&&(a+="w"),a},nodePermissions(r,a){return M.ignorePermissions?0:a.includes("r")&&!(r.mode&292)||a.includes("w")&&!(r.mode&146)||a.includes("x")&&!(r.mode&73)?2:0},mayLookup(r){if(!M.isDir(r.mode))return 54;var a=M.nodePermissions(r,"x");return a||(r.node_ops.lookup?0:2)},mayCreate(r,a){if(!M.isDir(r.mode))return 54;try{var c=M.lookupNode(r,a);return 20}catch{}return M.nodePermissions(r,"wx")},mayDelete(r,a,c){var u;try{u=M.lookupNode(r,a)}catch(_){return _.errno}var p=M.nodePermissions(r,"wx");if(p)return p;if(c){if(!M.isDir(u.mode))return 54;if(M.isRoot(u)||M.getPath(u)===M.cwd())return 10}else if(M.isDir(u.mode))return 31;return 0},mayOpen(r,a){return r?M.isLink(r.mode)?32:M.isDir(r.mode)&&(M.flagsToPermissionString(a)!=="r"||a&576)?31:M.nodePermissions(r,M.flagsToPermissionString(a)):44},checkOpExists(r,a){if(!r)throw new M.ErrnoError(a);return r},MAX_OPEN_FDS:4096,nextfd(){for(var r=0;r<=M.MAX_OPEN_FDS;r++)if(!M.streams[r])return r;throw new M.ErrnoError(33)},getStreamChecked(r){var a=M.getStream(r);if(!a)throw new M.ErrnoError(8);return a},getStream:r=>M.streams[r],createStream(r,a=-1){return G(a>=-1),r=Object.assign(new M.FSStream,r),a==-1&&(a=M.nextfd()),r.fd=a,M.streams[a]=r,r},closeStream(r){M.streams[r]=null},dupStream(r,a=-1){var c=M.createStream(r,a);return c.stream_ops?.dup?.(c),c},doSetAttr(r,a,c){var u=r?.stream_ops.setattr,p=u?r:a;u??=a.node_ops.setattr,M.checkOpExists(u,63),u(p,c)},chrdev_stream_ops:{open(r){var a=M.getDevice(r.node.rdev);r.stream_ops=a.stream_ops,r.stream_ops.open?.(r)},llseek(){throw new M.ErrnoError(70)}},major:r=>r>>8,minor:r=>r&255,makedev:(r,a)=>r<<8|a,registerDevice(r,a){M.devices[r]={stream_ops:a}},getDevice:r=>M.devices[r],getMounts(r){for(var a=[],c=[r];c.length;){var u=c.pop();a.push(u),c.push(...u.mounts)}return a},syncfs(r,a){typeof r=="function"&&(a=r,r=!1),M.syncFSRequests++,M.syncFSRequests>1&&I(`warning: ${M.syncFSRequests} FS.syncfs operations in flight at once, probably just doing extra work`);var c=M.getMounts(M.root.mount),u=0;function p(w){return G(M.syncFSRequests>0),M.syncFSRequests--,a(w)}function _(w){if(w)return _.errored?void 0:(_.errored=!0,p(w));++u>=c.length&&p(null)}c.forEach(w=>{if(!w.type.syncfs)return _(null);w.type.syncfs(w,r,_)})},mount(r,a,c){if(typeof r=="string")throw r;var u=c==="/",p=!c,_;if(u&&M.root)throw new M.ErrnoError(10);if(!u&&!p){var w=M.lookupPath(c,{follow_mount:!1});if(c=w.path,_=w.node,M.isMountpoint(_))throw new M.ErrnoError(10);if(!M.isDir(_.mode))throw new M.ErrnoError(54)}var A={type:r,opts:a,mountpoint:c,mounts:[]},F=r.mount(A);return F.mount=A,A.root=F,u?M.root=F:_&&(_.mounted=A,_.mount&&_.mount.mounts.push(A)),F},unmount(r){var a=M.lookupPath(r,{follow_mount:!1});if(!M.isMountpoint(a.node))throw new M.ErrnoError(28);var c=a.node,u=c.mounted,p=M.getMounts(u);Object.keys(M.nameTable).forEach(w=>{for(var A=M.nameTable[w];A;){var F=A.name_next;p.includes(A.mount)&&M.destroyNode(A),A=F}}),c.mounted=null;var _=c.mount.mounts.indexOf(u);G(_!==-1),c.mount.mounts.splice(_,1)},lookup(r,a){return r.node_ops.lookup(r,a)},mknod(r,a,c){var u=M.lookupPath(r,{parent:!0}),p=u.node,_=$.basename(r);if(!_)throw new M.ErrnoError(28);if(_==="."||_==="..")throw new M.ErrnoError(20);var w=M.mayCreate(p,_);if(w)throw new M.ErrnoError(w);if(!p.node_ops.mknod)throw new M.ErrnoError(63);return p.node_ops.mknod(p,_,a,c)},statfs(r){return M.statfsNode(M.lookupPath(r,{follow:!0}).node)},statfsStream(r){return M.statfsNode(r.node)},statfsNode(r){var a={bsize:4096,frsize:4096,blocks:1e6,bfree:5e5,bavail:5e5,files:M.nextInode,ffree:M.nextInode-1,fsid:42,flags:2,namelen:255};return r.node_ops.statfs&&Object.assign(a,r.node_ops.statfs(r.mount.opts.root)),a},create(r,a=438){return a&=4095,a|=32768,M.mknod(r,a,0)},mkdir(r,a=511){return a&=1023,a|=16384,M.mknod(r,a,0)},mkdirTree(r,a){var c=r.split("/"),u="";for(var p of c)if(p){(u||$.isAbs(r))&&(u+="/"),u+=p;try{M.mkdir(u,a)}catch(_){if(_.errno!=20)throw _}}},mkdev(r,a,c){return typeof c>"u"&&(c=a,a=438),a|=8192,M.mknod(r,a,c)},symlink(r,a){if(!Te.resolve(r))throw new M.ErrnoError(44);var c=M.lookupPath(a,{parent:!0}),u=c.node;if(!u)throw new M.ErrnoError(44);var p=$.basename(a),_=M.mayCreate(u,p);if(_)throw new M.ErrnoError(_);if(!u.node_ops.symlink)throw new M.ErrnoError(63);return u.node_ops.symlink(u,p,r)},rename(r,a){var c=$.dirname(r),u=$.dirname(a),p=$.basename(r),_=$.basename(a),w,A,F;if(w=M.lookupPath(r,{parent:!0}),A=w.node,w=M.lookupPath(a,{parent:!0}),F=w.node,!A||!F)throw new M.ErrnoError(44);if(A.mount!==F.mount)throw new M.ErrnoError(75);var X=M.lookupNode(A,p),Q=Te.relative(r,u);if(Q.charAt(0)!==".")throw new M.ErrnoError(28);if(Q=Te.relative(a,c),Q.charAt(0)!==".")throw new M.ErrnoError(55);var oe;try{oe=M.lookupNode(F,_)}catch{}if(X!==oe){var fe=M.isDir(X.mode),ce=M.mayDelete(A,p,fe);if(ce)throw new M.ErrnoError(ce);if(ce=oe?M.mayDelete(F,_,fe):M.mayCreate(F,_),ce)throw new M.ErrnoError(ce);if(!A.node_ops.rename)throw new M.ErrnoError(63);if(M.isMountpoint(X)||oe&&M.isMountpoint(oe))throw new M.ErrnoError(10);if(F!==A&&(ce=M.nodePermissions(A,"w"),ce))throw new M.ErrnoError(ce);M.hashRemoveNode(X);try{A.node_ops.rename(X,F,_),X.parent=F}catch(me){throw me}finally{M.hashAddNode(X)}}},rmdir(r){var a=M.lookupPath(r,{parent:!0}),c=a.node,u=$.basename(r),p=M.lookupNode(c,u),_=M.mayDelete(c,u,!0);if(_)throw new M.ErrnoError(_);if(!c.node_ops.rmdir)throw new M.ErrnoError(63);if(M.isMountpoint(p))throw new M.ErrnoError(10);c.node_ops.rmdir(c,u),M.destroyNode(p)},readdir(r){var a=M.lookupPath(r,{follow:!0}),c=a.node,u=M.checkOpExists(c.node_ops.readdir,54);return u(c)},unlink(r){var a=M.lookupPath(r,{parent:!0}),c=a.node;if(!c)throw new M.ErrnoError(44);var u=$.basename(r),p=M.lookupNode(c,u),_=M.mayDelete(c,u,!1);if(_)throw new M.ErrnoError(_);if(!c.node_ops.unlink)throw new M.ErrnoError(63);if(M.isMountpoint(p))throw new M.ErrnoError(10);c.node_ops.unlink(c,u),M.destroyNode(p)},readlink(r){var a=M.lookupPath(r),c=a.node;if(!c)throw new M.ErrnoError(44);if(!c.node_ops.readlink)throw new M.ErrnoError(28);return c.node_ops.readlink(c)},stat(r,a){var c=M.lookupPath(r,{follow:!a}),u=c.node,p=M.checkOpExists(u.node_ops.getattr,63);return p(u)},fstat(r){var a=M.getStreamChecked(r),c=a.node,u=a.stream_ops.getattr,p=u?a:c;return u??=c.node_ops.getattr,M.checkOpExists(u,63),u(p)},lstat(r){return M.stat(r,!0)},doChmod(r,a,c,u){M.doSetAttr(r,a,{mode:c&4095|a.mode&-4096,ctime:Date.now(),dontFollow:u})},chmod(r,a,c){var u;if(typeof r=="string"){var p=M.lookupPath(r,{follow:!c});u=p.node}else u=r;M.doChmod(null,u,a,c)},lchmod(r,a){M.chmod(r,a,!0)},fchmod(r,a){var c=M.getStreamChecked(r);M.doChmod(c,c.node,a,!1)},doChown(r,a,c){M.doSetAttr(r,a,{timestamp:Date.now(),dontFollow:c})},chown(r,a,c,u){var p;if(typeof r=="string"){var _=M.lookupPath(r,{follow:!u});p=_.node}else p=r;M.doChown(null,p,u)},lchown(r,a,c){M.chown(r,a,c,!0)},fchown(r,a,c){var u=M.getStreamChecked(r);M.doChown(u,u.node,!1)},doTruncate(r,a,c){if(M.isDir(a.mode))throw new M.ErrnoError(31);if(!M.isFile(a.mode))throw new M.ErrnoError(28);var u=M.nodePermissions(a,"w");if(u)throw new M.ErrnoError(u);M.doSetAttr(r,a,{size:c,timestamp:Date.now()})},truncate(r,a){if(a<0)throw new M.ErrnoError(28);var c;if(typeof r=="string"){var u=M.lookupPath(r,{follow:!0});c=u.node}else c=r;M.doTruncate(null,c,a)},ftruncate(r,a){var c=M.getStreamChecked(r);if(a<0||(c.flags&2097155)===0)throw new M.ErrnoError(28);M.doTruncate(c,c.node,a)},utime(r,a,c){var u=M.lookupPath(r,{follow:!0}),p=u.node,_=M.checkOpExists(p.node_ops.setattr,63);_(p,{atime:a,mtime:c})},open(r,a,c=438){if(r==="")throw new M.ErrnoError(44);a=typeof a=="string"?on(a):a,a&64?c=c&4095|32768:c=0;var u,p;if(typeof r=="object")u=r;else{p=r.endsWith("/");var _=M.lookupPath(r,{follow:!(a&131072),noent_okay:!0});u=_.node,r=_.path}var w=!1;if(a&64)if(u){if(a&128)throw new M.ErrnoError(20)}else{if(p)throw new M.ErrnoError(31);u=M.mknod(r,c|511,0),w=!0}if(!u)throw new M.ErrnoError(44);if(M.isChrdev(u.mode)&&(a&=-513),a&65536&&!M.isDir(u.mode))throw new M.ErrnoError(54);if(!w){var A=M.mayOpen(u,a);if(A)throw new M.ErrnoError(A)}a&512&&!w&&M.truncate(u,0),a&=-131713;var F=M.createStream({node:u,path:M.getPath(u),flags:a,seekable:!0,position:0,stream_ops:u.stream_ops,ungotten:[],error:!1});return F.stream_ops.open&&F.stream_ops.open(F),w&&M.chmod(u,c&511),t.logReadFiles&&!(a&1)&&(r in M.readFiles||(M.readFiles[r]=1)),F},close(r){if(M.isClosed(r))throw new M.ErrnoError(8);r.getdents&&(r.getdents=null);try{r.stream_ops.close&&r.stream_ops.close(r)}catch(a){throw a}finally{M.closeStream(r.fd)}r.fd=null},isClosed(r){return r.fd===null},llseek(r,a,c){if(M.isClosed(r))throw new M.ErrnoError(8);if(!r.seekable||!r.stream_ops.llseek)throw new M.ErrnoError(70);if(c!=0&&c!=1&&c!=2)throw new M.ErrnoError(28);return r.position=r.stream_ops.llseek(r,a,c),r.ungotten=[],r.position},read(r,a,c,u,p){if(G(c>=0),u<0||p<0)throw new M.ErrnoError(28);if(M.isClosed(r))throw new M.ErrnoError(8);if((r.flags&2097155)===1)throw new M.ErrnoError(8);if(M.isDir(r.node.mode))throw new M.ErrnoError(31);if(!r.stream_ops.read)throw new M.ErrnoError(28);var _=typeof p<"u";if(!_)p=r.position;else if(!r.seekable)throw new M.ErrnoError(70);var w=r.stream_ops.read(r,a,c,u,p);return _||(r.position+=w),w},write(r,a,c,u,p,_){if(G(c>=0),u<0||p<0)throw new M.ErrnoError(28);if(M.isClosed(r))throw new M.ErrnoError(8);if((r.flags&2097155)===0)throw new M.ErrnoError(8);if(M.isDir(r.node.mode))throw new M.ErrnoError(31);if(!r.stream_ops.write)throw new M.ErrnoError(28);r.seekable&&r.flags&1024&&M.llseek(r,0,2);var w=typeof p<"u";if(!w)p=r.position;else if(!r.seekable)throw new M.ErrnoError(70);var A=r.stream_ops.write(r,a,c,u,p,_);return w||(r.position+=A),A},mmap(r,a,c,u,p){if((u&2)!==0&&(p&2)===0&&(r.flags&2097155)!==2)throw new M.ErrnoError(2);if((r.flags&2097155)===1)throw new M.ErrnoError(2);if(!r.stream_ops.mmap)throw new M.ErrnoError(43);if(!a)throw new M.ErrnoError(28);return r.stream_ops.mmap(r,a,c,u,p)},msync(r,a,c,u,p){return G(c>=0),r.stream_ops.msync?r.stream_ops.msync(r,a,c,u,p):0},ioctl(r,a,c){if(!r.stream_ops.ioctl)throw new M.ErrnoError(59);return r.stream_ops.ioctl(r,a,c)},readFile(r,a={}){if(a.flags=a.flags||0,a.encoding=a.encoding||"binary",a.encoding!=="utf8"&&a.encoding!=="binary")throw new Error(`Invalid encoding type "${a.encoding}"`);var c=M.open(r,a.flags),u=M.stat(r),p=u.size,_=new Uint8Array(p);return M.read(c,_,0,p,0),a.encoding==="utf8"&&(_=vi(_)),M.close(c),_},writeFile(r,a,c={}){c.flags=c.flags||577;var u=M.open(r,c.flags,c.mode);if(typeof a=="string"&&(a=new Uint8Array(gt(a,!0))),ArrayBuffer.isView(a))M.write(u,a,0,a.byteLength,void 0,c.canOwn);else throw new Error("Unsupported data type");M.close(u)},cwd:()=>M.currentPath,chdir(r){var a=M.lookupPath(r,{follow:!0});if(a.node===null)throw new M.ErrnoError(44);if(!M.isDir(a.node.mode))throw new M.ErrnoError(54);var c=M.nodePermissions(a.node,"x");if(c)throw new M.ErrnoError(c);M.currentPath=a.path},createDefaultDirectories(){M.mkdir("/tmp"),M.mkdir("/home"),M.mkdir("/home/web_user")},createDefaultDevices(){M.mkdir("/dev"),M.registerDevice(M.makedev(1,3),{read:()=>0,write:(u,p,_,w,A)=>w,llseek:()=>0}),M.mkdev("/dev/null",M.makedev(1,3)),lt.register(M.makedev(5,0),lt.default_tty_ops),lt.register(M.makedev(6,0),lt.default_tty1_ops),M.mkdev("/dev/tty",M.makedev(5,0)),M.mkdev("/dev/tty1",M.makedev(6,0));var r=new Uint8Array(1024),a=0,c=()=>(a===0&&(ze(r),a=r.byteLength),r[--a]);M.createDevice("/dev","random",c),M.createDevice("/dev","urandom",c),M.mkdir("/dev/shm"),M.mkdir("/dev/shm/tmp")},createSpecialDirectories(){M.mkdir("/proc");var r=M.mkdir("/proc/self");M.mkdir("/proc/self/fd"),M.mount({mount(){var a=M.createNode(r,"fd",16895,73);return a.stream_ops={llseek:ke.stream_ops.llseek},a.node_ops={lookup(c,u){var p=+u,_=M.getStreamChecked(p),w={parent:null,mount:{mountpoint:"fake"},node_ops:{readlink:()=>_.path},id:p+1};return w.parent=w,w},readdir(){return Array.from(M.streams.entries()).filter(([c,u])=>u).map(([c,u])=>c.toString())}},a}},{},"/proc/self/fd")},createStandardStreams(r,a,c){r?M.createDevice("/dev","stdin",r):M.symlink("/dev/tty","/dev/stdin"),a?M.createDevice("/dev","stdout",null,a):M.symlink("/dev/tty","/dev/stdout"),c?M.createDevice("/dev","stderr",null,c):M.symlink("/dev/tty1","/dev/stderr");var u=M.open("/dev/stdin",0),p=M.open("/dev/stdout",1),_=M.open("/dev/stderr",1);G(u.fd===0,`invalid handle for stdin (${u.fd})`),G(p.fd===1,`invalid handle for stdout (${p.fd})`),G(_.fd===2,`invalid handle for stderr (${_.fd})`)},staticInit(){M.nameTable=new Array(4096),M.mount(ke,{},"/"),M.createDefaultDirectories(),M.createDefaultDevices(),M.createSpecialDirectories(),M.filesystems={MEMFS:ke}},init(r,a,c){G(!M.initialized,"FS.init was previously called. If you want to initialize later with custom parameters, remove any earlier calls (note that one is automatically added to the generated code)"),M.initialized=!0,r??=t.stdin,a??=t.stdout,c??=t.stderr,M.createStandardStreams(r,a,c)},quit(){M.initialized=!1,Jl(0);for(var r of M.streams)r&&M.close(r)},findObject(r,a){var c=M.analyzePath(r,a);return c.exists?c.object:null},analyzePath(r,a){try{var c=M.lookupPath(r,{follow:!a});r=c.path}catch{}var u={isRoot:!1,exists:!1,error:0,name:null,path:null,object:null,parentExists:!1,parentPath:null,parentObject:null};try{var c=M.lookupPath(r,{parent:!0});u.parentExists=!0,u.parentPath=c.path,u.parentObject=c.node,u.name=$.basename(r),c=M.lookupPath(r,{follow:!a}),u.exists=!0,u.path=c.path,u.object=c.node,u.name=c.node.name,u.isRoot=c.path==="/"}catch(p){u.error=p.errno}return u},createPath(r,a,c,u){r=typeof r=="string"?r:M.getPath(r);for(var p=a.split("/").reverse();p.length;){var _=p.pop();if(_){var w=$.join2(r,_);try{M.mkdir(w)}catch(A){if(A.errno!=20)throw A}r=w}}return w},createFile(r,a,c,u,p){var _=$.join2(typeof r=="string"?r:M.getPath(r),a),w=Di(u,p);return M.create(_,w)},createDataFile(r,a,c,u,p,_){var w=a;r&&(r=typeof r=="string"?r:M.getPath(r),w=a?$.join2(r,a):r);var A=Di(u,p),F=M.create(w,A);if(c){if(typeof c=="string"){for(var X=new Array(c.length),Q=0,oe=c.length;Q<oe;++Q)X[Q]=c.charCodeAt(Q);c=X}M.chmod(F,A|146);var fe=M.open(F,577);M.write(fe,c,0,c.length,0,_),M.close(fe),M.chmod(F,A)}},createDevice(r,a,c,u){var p=$.join2(typeof r=="string"?r:M.getPath(r),a),_=Di(!!c,!!u);M.createDevice.major??=64;var w=M.makedev(M.createDevice.major++,0);return M.registerDevice(w,{open(A){A.seekable=!1},close(A){u?.buffer?.length&&u(10)},read(A,F,X,Q,oe){for(var fe=0,ce=0;ce<Q;ce++){var me;try{me=c()}catch{throw new M.ErrnoError(29)}if(me===void 0&&fe===0)throw new M.ErrnoError(6);if(me==null)break;fe++,F[X+ce]=me}return fe&&(A.node.atime=Date.now()),fe},write(A,F,X,Q,oe){for(var fe=0;fe<Q;fe++)try{u(F[X+fe])}catch{throw new M.ErrnoError(29)}return Q&&(A.node.mtime=A.node.ctime=Date.now()),fe}}),M.mkdev(p,_,w)},forceLoadFile(r){if(r.isDevice||r.isFolder||r.link||r.contents)return!0;if(typeof XMLHttpRequest<"u")throw new Error("Lazy loading should have been performed (contents set) in createLazyFile, but it was not. Lazy loading only works in web workers. Use --embed-file or --preload-file in emcc on the main thread.");try{r.contents=C(r.url),r.usedBytes=r.contents.length}catch{throw new M.ErrnoError(29)}},createLazyFile(r,a,c,u,p){class _{lengthKnown=!1;chunks=[];get(ce){if(!(ce>this.length-1||ce<0)){var me=ce%this.chunkSize,Ye=ce/this.chunkSize|0;return this.getter(Ye)[me]}}setDataGetter(ce){this.getter=ce}cacheLength(){var ce=new XMLHttpRequest;if(ce.open("HEAD",c,!1),ce.send(null),!(ce.status>=200&&ce.status<300||ce.status===304))throw new Error("Couldn't load "+c+". Status: "+ce.status);var me=Number(ce.getResponseHeader("Content-length")),Ye,vt=(Ye=ce.getResponseHeader("Accept-Ranges"))&&Ye==="bytes",at=(Ye=ce.getResponseHeader("Content-Encoding"))&&Ye==="gzip",bt=1024*1024;vt||(bt=me);var nt=(Kt,yn)=>{if(Kt>yn)throw new Error("invalid range ("+Kt+", "+yn+") or no bytes requested!");if(yn>me-1)throw new Error("only "+me+" bytes available! programmer error!");var Nt=new XMLHttpRequest;if(Nt.open("GET",c,!1),me!==bt&&Nt.setRequestHeader("Range","bytes="+Kt+"-"+yn),Nt.responseType="arraybuffer",Nt.overrideMimeType&&Nt.overrideMimeType("text/plain; charset=x-user-defined"),Nt.send(null),!(Nt.status>=200&&Nt.status<300||Nt.status===304))throw new Error("Couldn't load "+c+". Status: "+Nt.status);return Nt.response!==void 0?new Uint8Array(Nt.response||[]):gt(Nt.responseText||"",!0)},qt=this;qt.setDataGetter(Kt=>{var yn=Kt*bt,Nt=(Kt+1)*bt-1;if(Nt=Math.min(Nt,me-1),typeof qt.chunks[Kt]>"u"&&(qt.chunks[Kt]=nt(yn,Nt)),typeof qt.chunks[Kt]>"u")throw new Error("doXHR failed!");return qt.chunks[Kt]}),(at||!me)&&(bt=me=1,me=this.getter(0).length,bt=me,U("LazyFiles on gzip forces download of the whole file when length is accessed")),this._length=me,this._chunkSize=bt,this.lengthKnown=!0}get length(){return this.lengthKnown||this.cacheLength(),this._length}get chunkSize(){return this.lengthKnown||this.cacheLength(),this._chunkSize}}if(typeof XMLHttpRequest<"u"){if(!s)throw"Cannot do synchronous binary XHRs outside webworkers in modern browsers. Use --embed-file or --preload-file in emcc";var w=new _,A={isDevice:!1,contents:w}}else var A={isDevice:!1,url:c};var F=M.createFile(r,a,A,u,p);A.contents?F.contents=A.contents:A.url&&(F.contents=null,F.url=A.url),Object.defineProperties(F,{usedBytes:{get:function(){return this.contents.length}}});var X={},Q=Object.keys(F.stream_ops);Q.forEach(fe=>{var ce=F.stream_ops[fe];X[fe]=(...me)=>(M.forceLoadFile(F),ce(...me))});function oe(fe,ce,me,Ye,vt){var at=fe.node.contents;if(vt>=at.length)return 0;var bt=Math.min(at.length-vt,Ye);if(G(bt>=0),at.slice)for(var nt=0;nt<bt;nt++)ce[me+nt]=at[vt+nt];else for(var nt=0;nt<bt;nt++)ce[me+nt]=at.get(vt+nt);return bt}return X.read=(fe,ce,me,Ye,vt)=>(M.forceLoadFile(F),oe(fe,ce,me,Ye,vt)),X.mmap=(fe,ce,me,Ye,vt)=>{M.forceLoadFile(F);var at=Wt(ce);if(!at)throw new M.ErrnoError(48);return oe(fe,pt,at,ce,me),{ptr:at,allocated:!0}},F.stream_ops=X,F},absolutePath(){pe("FS.absolutePath has been removed; use PATH_FS.resolve instead")},createFolder(){pe("FS.createFolder has been removed; use FS.mkdir instead")},createLink(){pe("FS.createLink has been removed; use FS.symlink instead")},joinPath(){pe("FS.joinPath has been removed; use PATH.join instead")},mmapAlloc(){pe("FS.mmapAlloc has been replaced by the top level function mmapAlloc")},standardizePath(){pe("FS.standardizePath has been removed; use PATH.normalize instead")}},ft={DEFAULT_POLLMASK:5,calculateAt(r,a,c){if($.isAbs(a))return a;var u;if(r===-100)u=M.cwd();else{var p=ft.getStreamFromFD(r);u=p.path}if(a.length==0){if(!c)throw new M.ErrnoError(44);return u}return u+"/"+a},writeStat(r,a){De[r>>2]=a.dev,De[r+4>>2]=a.mode,$e[r+8>>2]=a.nlink,De[r+12>>2]=a.uid,De[r+16>>2]=a.gid,De[r+20>>2]=a.rdev,W[r+24>>3]=BigInt(a.size),De[r+32>>2]=4096,De[r+36>>2]=a.blocks;var c=a.atime.getTime(),u=a.mtime.getTime(),p=a.ctime.getTime();return W[r+40>>3]=BigInt(Math.floor(c/1e3)),$e[r+48>>2]=c%1e3*1e3*1e3,W[r+56>>3]=BigInt(Math.floor(u/1e3)),$e[r+64>>2]=u%1e3*1e3*1e3,W[r+72>>3]=BigInt(Math.floor(p/1e3)),$e[r+80>>2]=p%1e3*1e3*1e3,W[r+88>>3]=BigInt(a.ino),0},writeStatFs(r,a){De[r+4>>2]=a.bsize,De[r+40>>2]=a.bsize,De[r+8>>2]=a.blocks,De[r+12>>2]=a.bfree,De[r+16>>2]=a.bavail,De[r+20>>2]=a.files,De[r+24>>2]=a.ffree,De[r+28>>2]=a.fsid,De[r+44>>2]=a.flags,De[r+36>>2]=a.namelen},doMsync(r,a,c,u,p){if(!M.isFile(a.node.mode))throw new M.ErrnoError(43);if(u&2)return 0;var _=It.slice(r,r+c);M.msync(a,_,p,c,u)},getStreamFromFD(r){var a=M.getStreamChecked(r);return a},varargs:void 0,getStr(r){var a=un(r);return a}};function Rn(r,a,c){try{var u=ft.getStreamFromFD(r);if(G(!c),u.fd===a)return-28;if(a<0||a>=M.MAX_OPEN_FDS)return-8;var p=M.getStream(a);return p&&M.close(p),M.dupStream(u,a).fd}catch(_){if(typeof M>"u"||_.name!=="ErrnoError")throw _;return-_.errno}}var Ft=()=>{G(ft.varargs!=null);var r=De[+ft.varargs>>2];return ft.varargs+=4,r},kt=Ft;function Vn(r,a,c){ft.varargs=c;try{var u=ft.getStreamFromFD(r);switch(a){case 0:{var p=Ft();if(p<0)return-28;for(;M.streams[p];)p++;var _;return _=M.dupStream(u,p),_.fd}case 1:case 2:return 0;case 3:return u.flags;case 4:{var p=Ft();return u.flags|=p,0}case 12:{var p=kt(),w=0;return Mt[p+w>>1]=2,0}case 13:case 14:return 0}return-28}catch(A){if(typeof M>"u"||A.name!=="ErrnoError")throw A;return-A.errno}}function pa(r,a){try{return ft.writeStat(a,M.fstat(r))}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}function Rf(r,a,c){ft.varargs=c;try{var u=ft.getStreamFromFD(r);switch(a){case 21509:return u.tty?0:-59;case 21505:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tcgets){var p=u.tty.ops.ioctl_tcgets(u),_=kt();De[_>>2]=p.c_iflag||0,De[_+4>>2]=p.c_oflag||0,De[_+8>>2]=p.c_cflag||0,De[_+12>>2]=p.c_lflag||0;for(var w=0;w<32;w++)pt[_+w+17]=p.c_cc[w]||0;return 0}return 0}case 21510:case 21511:case 21512:return u.tty?0:-59;case 21506:case 21507:case 21508:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tcsets){for(var _=kt(),A=De[_>>2],F=De[_+4>>2],X=De[_+8>>2],Q=De[_+12>>2],oe=[],w=0;w<32;w++)oe.push(pt[_+w+17]);return u.tty.ops.ioctl_tcsets(u.tty,a,{c_iflag:A,c_oflag:F,c_cflag:X,c_lflag:Q,c_cc:oe})}return 0}case 21519:{if(!u.tty)return-59;var _=kt();return De[_>>2]=0,0}case 21520:return u.tty?-28:-59;case 21531:{var _=kt();return M.ioctl(u,a,_)}case 21523:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tiocgwinsz){var fe=u.tty.ops.ioctl_tiocgwinsz(u.tty),_=kt();Mt[_>>1]=fe[0],Mt[_+2>>1]=fe[1]}return 0}case 21524:return u.tty?0:-59;case 21515:return u.tty?0:-59;default:return-28}}catch(ce){if(typeof M>"u"||ce.name!=="ErrnoError")throw ce;return-ce.errno}}function Cf(r,a){try{return r=ft.getStr(r),ft.writeStat(a,M.lstat(r))}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}function Pf(r,a,c,u){try{a=ft.getStr(a);var p=u&256,_=u&4096;return u=u&-6401,G(!u,`unknown flags in __syscall_newfstatat: ${u}`),a=ft.calculateAt(r,a,_),ft.writeStat(c,p?M.lstat(a):M.stat(a))}catch(w){if(typeof M>"u"||w.name!=="ErrnoError")throw w;return-w.errno}}function If(r,a,c,u){ft.varargs=u;try{a=ft.getStr(a),a=ft.calculateAt(r,a);var p=u?Ft():0;return M.open(a,c,p).fd}catch(_){if(typeof M>"u"||_.name!=="ErrnoError")throw _;return-_.errno}}function Df(r,a){try{return r=ft.getStr(r),ft.writeStat(a,M.stat(r))}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}var Lf=()=>pe("native code called abort()"),Zt=r=>{for(var a="";;){var c=It[r++];if(!c)return a;a+=String.fromCharCode(c)}},Mr={},Qi={},ma={},os=class extends Error{constructor(a){super(a),this.name="BindingError"}},xt=r=>{throw new os(r)};function Ff(r,a,c={}){var u=a.name;if(r||xt(`type "${u}" must have a positive integer typeid pointer`),Qi.hasOwnProperty(r)){if(c.ignoreDuplicateRegistrations)return;xt(`Cannot register type '${u}' twice`)}if(Qi[r]=a,delete ma[r],Mr.hasOwnProperty(r)){var p=Mr[r];delete Mr[r],p.forEach(_=>_())}}function Un(r,a,c={}){if(a.argPackAdvance===void 0)throw new TypeError("registerType registeredInstance requires argPackAdvance");return Ff(r,a,c)}var Rh=(r,a,c)=>{switch(a){case 1:return c?u=>pt[u]:u=>It[u];case 2:return c?u=>Mt[u>>1]:u=>rn[u>>1];case 4:return c?u=>De[u>>2]:u=>$e[u>>2];case 8:return c?u=>W[u>>3]:u=>vn[u>>3];default:throw new TypeError(`invalid integer width (${a}): ${r}`)}},er=r=>{if(r===null)return"null";var a=typeof r;return a==="object"||a==="array"||a==="function"?r.toString():""+r},Ch=(r,a,c,u)=>{if(a<c||a>u)throw new TypeError(`Passing a number "${er(a)}" from JS side to C/C++ side to an argument of type "${r}", which is outside the valid range [${c}, ${u}]!`)},Nf=(r,a,c,u,p)=>{a=Zt(a);let _=u===0n,w=A=>A;if(_){let A=c*8;w=F=>BigInt.asUintN(A,F),p=w(p)}Un(r,{name:a,fromWireType:w,toWireType:(A,F)=>{if(typeof F=="number")F=BigInt(F);else if(typeof F!="bigint")throw new TypeError(`Cannot convert "${er(F)}" to ${this.name}`);return Ch(a,F,u,p),F},argPackAdvance:ii,readValueFromPointer:Rh(a,c,!_),destructorFunction:null})},ii=8,Uf=(r,a,c,u)=>{a=Zt(a),Un(r,{name:a,fromWireType:function(p){return!!p},toWireType:function(p,_){return _?c:u},argPackAdvance:ii,readValueFromPointer:function(p){return this.fromWireType(It[p])},destructorFunction:null})},Of=r=>({count:r.count,deleteScheduled:r.deleteScheduled,preservePointerOnDelete:r.preservePointerOnDelete,ptr:r.ptr,ptrType:r.ptrType,smartPtr:r.smartPtr,smartPtrType:r.smartPtrType}),zl=r=>{function a(c){return c.$$.ptrType.registeredClass.name}xt(a(r)+" instance already deleted")},Gl=!1,Ph=r=>{},Bf=r=>{r.smartPtr?r.smartPtrType.rawDestructor(r.smartPtr):r.ptrType.registeredClass.rawDestructor(r.ptr)},Ih=r=>{r.count.value-=1;var a=r.count.value===0;a&&Bf(r)},Dh=(r,a,c)=>{if(a===c)return r;if(c.baseClass===void 0)return null;var u=Dh(r,a,c.baseClass);return u===null?null:c.downcast(u)},Lh={},kf={},zf=(r,a)=>{for(a===void 0&&xt("ptr should not be undefined");r.baseClass;)a=r.upcast(a),r=r.baseClass;return a},Gf=(r,a)=>(a=zf(r,a),kf[a]),Vf=class extends Error{constructor(a){super(a),this.name="InternalError"}},ga=r=>{throw new Vf(r)},_a=(r,a)=>{(!a.ptrType||!a.ptr)&&ga("makeClassHandle requires ptr and ptrType");var c=!!a.smartPtrType,u=!!a.smartPtr;return c!==u&&ga("Both smartPtrType and smartPtr must be specified"),a.count={value:1},ls(Object.create(r,{$$:{value:a,writable:!0}}))};function Fh(r){var a=this.getPointee(r);if(!a)return this.destructor(r),null;var c=Gf(this.registeredClass,a);if(c!==void 0){if(c.$$.count.value===0)return c.$$.ptr=a,c.$$.smartPtr=r,c.clone();var u=c.clone();return this.destructor(r),u}function p(){return this.isSmartPointer?_a(this.registeredClass.instancePrototype,{ptrType:this.pointeeType,ptr:a,smartPtrType:this,smartPtr:r}):_a(this.registeredClass.instancePrototype,{ptrType:this,ptr:r})}var _=this.registeredClass.getActualType(a),w=Lh[_];if(!w)return p.call(this);var A;this.isConst?A=w.constPointerType:A=w.pointerType;var F=Dh(a,this.registeredClass,A.registeredClass);return F===null?p.call(this):this.isSmartPointer?_a(A.registeredClass.instancePrototype,{ptrType:A,ptr:F,smartPtrType:this,smartPtr:r}):_a(A.registeredClass.instancePrototype,{ptrType:A,ptr:F})}var ls=r=>typeof FinalizationRegistry>"u"?(ls=a=>a,r):(Gl=new FinalizationRegistry(a=>{console.warn(a.leakWarning),Ih(a.$$)}),ls=a=>{var c=a.$$,u=!!c.smartPtr;if(u){var p={$$:c},_=c.ptrType.registeredClass,w=new Error(`Embind found a leaked C++ instance ${_.name} <${Bt(c.ptr)}>.
We'll free it automatically in this case, but this functionality is not reliable across various environments.
Make sure to invoke .delete() manually once you're done with the instance instead.
Originally allocated`);"captureStackTrace"in Error&&Error.captureStackTrace(w,Fh),p.leakWarning=w.stack.replace(/^Error: /,""),Gl.register(a,p,a)}return a},Ph=a=>Gl.unregister(a),ls(r)),va=[],Hf=()=>{for(;va.length;){var r=va.pop();r.$$.deleteScheduled=!1,r.delete()}},Nh,Wf=()=>{let r=ya.prototype;Object.assign(r,{isAliasOf(c){if(!(this instanceof ya)||!(c instanceof ya))return!1;var u=this.$$.ptrType.registeredClass,p=this.$$.ptr;c.$$=c.$$;for(var _=c.$$.ptrType.registeredClass,w=c.$$.ptr;u.baseClass;)p=u.upcast(p),u=u.baseClass;for(;_.baseClass;)w=_.upcast(w),_=_.baseClass;return u===_&&p===w},clone(){if(this.$$.ptr||zl(this),this.$$.preservePointerOnDelete)return this.$$.count.value+=1,this;var c=ls(Object.create(Object.getPrototypeOf(this),{$$:{value:Of(this.$$)}}));return c.$$.count.value+=1,c.$$.deleteScheduled=!1,c},delete(){this.$$.ptr||zl(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),Ph(this),Ih(this.$$),this.$$.preservePointerOnDelete||(this.$$.smartPtr=void 0,this.$$.ptr=void 0)},isDeleted(){return!this.$$.ptr},deleteLater(){return this.$$.ptr||zl(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),va.push(this),va.length===1&&Nh&&Nh(Hf),this.$$.deleteScheduled=!0,this}});let a=Symbol.dispose;a&&(r[a]=r.delete)};function ya(){}var xa=(r,a)=>Object.defineProperty(a,"name",{value:r}),Vl=(r,a,c)=>{if(r[a].overloadTable===void 0){var u=r[a];r[a]=function(...p){return r[a].overloadTable.hasOwnProperty(p.length)||xt(`Function '${c}' called with an invalid number of arguments (${p.length}) - expects one of (${r[a].overloadTable})!`),r[a].overloadTable[p.length].apply(this,p)},r[a].overloadTable=[],r[a].overloadTable[u.argCount]=u}},Hl=(r,a,c)=>{t.hasOwnProperty(r)?((c===void 0||t[r].overloadTable!==void 0&&t[r].overloadTable[c]!==void 0)&&xt(`Cannot register public name '${r}' twice`),Vl(t,r,r),t[r].overloadTable.hasOwnProperty(c)&&xt(`Cannot register multiple overloads of a function with the same number of arguments (${c})!`),t[r].overloadTable[c]=a):(t[r]=a,t[r].argCount=c)},Xf=48,$f=57,qf=r=>{G(typeof r=="string"),r=r.replace(/[^a-zA-Z0-9_]/g,"$");var a=r.charCodeAt(0);return a>=Xf&&a<=$f?`_${r}`:r};function Yf(r,a,c,u,p,_,w,A){this.name=r,this.constructor=a,this.instancePrototype=c,this.rawDestructor=u,this.baseClass=p,this.getActualType=_,this.upcast=w,this.downcast=A,this.pureVirtualFunctions=[]}var Sa=(r,a,c)=>{for(;a!==c;)a.upcast||xt(`Expected null or instance of ${c.name}, got an instance of ${a.name}`),r=a.upcast(r),a=a.baseClass;return r};function jf(r,a){if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;a.$$||xt(`Cannot pass "${er(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`);var c=a.$$.ptrType.registeredClass,u=Sa(a.$$.ptr,c,this.registeredClass);return u}function Zf(r,a){var c;if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),this.isSmartPointer?(c=this.rawConstructor(),r!==null&&r.push(this.rawDestructor,c),c):0;(!a||!a.$$)&&xt(`Cannot pass "${er(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),!this.isConst&&a.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${a.$$.smartPtrType?a.$$.smartPtrType.name:a.$$.ptrType.name} to parameter type ${this.name}`);var u=a.$$.ptrType.registeredClass;if(c=Sa(a.$$.ptr,u,this.registeredClass),this.isSmartPointer)switch(a.$$.smartPtr===void 0&&xt("Passing raw pointer to smart pointer is illegal"),this.sharingPolicy){case 0:a.$$.smartPtrType===this?c=a.$$.smartPtr:xt(`Cannot convert argument of type ${a.$$.smartPtrType?a.$$.smartPtrType.name:a.$$.ptrType.name} to parameter type ${this.name}`);break;case 1:c=a.$$.smartPtr;break;case 2:if(a.$$.smartPtrType===this)c=a.$$.smartPtr;else{var p=a.clone();c=this.rawShare(c,Jt.toHandle(()=>p.delete())),r!==null&&r.push(this.rawDestructor,c)}break;default:xt("Unsupporting sharing policy")}return c}function Jf(r,a){if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;a.$$||xt(`Cannot pass "${er(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),a.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${a.$$.ptrType.name} to parameter type ${this.name}`);var c=a.$$.ptrType.registeredClass,u=Sa(a.$$.ptr,c,this.registeredClass);return u}function Ma(r){return this.fromWireType($e[r>>2])}var Kf=()=>{Object.assign(ba.prototype,{getPointee(r){return this.rawGetPointee&&(r=this.rawGetPointee(r)),r},destructor(r){this.rawDestructor?.(r)},argPackAdvance:ii,readValueFromPointer:Ma,fromWireType:Fh})};function ba(r,a,c,u,p,_,w,A,F,X,Q){this.name=r,this.registeredClass=a,this.isReference=c,this.isConst=u,this.isSmartPointer=p,this.pointeeType=_,this.sharingPolicy=w,this.rawGetPointee=A,this.rawConstructor=F,this.rawShare=X,this.rawDestructor=Q,!p&&a.baseClass===void 0?u?(this.toWireType=jf,this.destructorFunction=null):(this.toWireType=Jf,this.destructorFunction=null):this.toWireType=Zf}var Uh=(r,a,c)=>{t.hasOwnProperty(r)||ga("Replacing nonexistent public symbol"),t[r].overloadTable!==void 0&&c!==void 0?t[r].overloadTable[c]=a:(t[r]=a,t[r].argCount=c)},Oh=[],wa,be=r=>{var a=Oh[r];return a||(Oh[r]=a=wa.get(r)),G(wa.get(r)==a,"JavaScript-side Wasm function table mirror is out of date!"),a},ri=(r,a,c=!1)=>{G(!c,"Async bindings are only supported with JSPI."),r=Zt(r);function u(){var _=be(a);return _}var p=u();return typeof p!="function"&&xt(`unknown function pointer with signature ${r}: ${a}`),p};class Qf extends Error{}var Bh=r=>{var a=nu(r),c=Zt(a);return Wn(a),c},tr=(r,a)=>{var c=[],u={};function p(_){if(!u[_]&&!Qi[_]){if(ma[_]){ma[_].forEach(p);return}c.push(_),u[_]=!0}}throw a.forEach(p),new Qf(`${r}: `+c.map(Bh).join([", "]))},Hn=(r,a,c)=>{r.forEach(A=>ma[A]=a);function u(A){var F=c(A);F.length!==r.length&&ga("Mismatched type converter count");for(var X=0;X<r.length;++X)Un(r[X],F[X])}var p=new Array(a.length),_=[],w=0;a.forEach((A,F)=>{Qi.hasOwnProperty(A)?p[F]=Qi[A]:(_.push(A),Mr.hasOwnProperty(A)||(Mr[A]=[]),Mr[A].push(()=>{p[F]=Qi[A],++w,w===_.length&&u(p)}))}),_.length===0&&u(p)},ep=(r,a,c,u,p,_,w,A,F,X,Q,oe,fe)=>{Q=Zt(Q),_=ri(p,_),A&&=ri(w,A),X&&=ri(F,X),fe=ri(oe,fe);var ce=qf(Q);Hl(ce,function(){tr(`Cannot construct ${Q} due to unbound types`,[u])}),Hn([r,a,c],u?[u]:[],me=>{me=me[0];var Ye,vt;u?(Ye=me.registeredClass,vt=Ye.instancePrototype):vt=ya.prototype;var at=xa(Q,function(...Nt){if(Object.getPrototypeOf(this)!==bt)throw new os(`Use 'new' to construct ${Q}`);if(nt.constructor_body===void 0)throw new os(`${Q} has no accessible constructor`);var rr=nt.constructor_body[Nt.length];if(rr===void 0)throw new os(`Tried to invoke ctor of ${Q} with invalid number of parameters (${Nt.length}) - expected (${Object.keys(nt.constructor_body).toString()}) parameters instead!`);return rr.apply(this,Nt)}),bt=Object.create(vt,{constructor:{value:at}});at.prototype=bt;var nt=new Yf(Q,at,bt,fe,Ye,_,A,X);nt.baseClass&&(nt.baseClass.__derivedClasses??=[],nt.baseClass.__derivedClasses.push(nt));var qt=new ba(Q,nt,!0,!1,!1),Kt=new ba(Q+"*",nt,!1,!1,!1),yn=new ba(Q+" const*",nt,!1,!0,!1);return Lh[r]={pointerType:Kt,constPointerType:yn},Uh(ce,at),[qt,Kt,yn]})},Ea=r=>{for(;r.length;){var a=r.pop(),c=r.pop();c(a)}};function kh(r){for(var a=1;a<r.length;++a)if(r[a]!==null&&r[a].destructorFunction===void 0)return!0;return!1}function zh(r,a,c,u,p){if(r<a||r>c){var _=a==c?a:`${a} to ${c}`;p(`function ${u} called with ${r} arguments, expected ${_}`)}}function mw(r,a,c,u){var p=kh(r),_=r.length-2,w=[],A=["fn"];a&&A.push("thisWired");for(var F=0;F<_;++F)w.push(`arg${F}`),A.push(`arg${F}Wired`);w=w.join(","),A=A.join(",");var X=`return function (${w}) {
`;X+=`checkArgCount(arguments.length, minArgs, maxArgs, humanName, throwBindingError);
`,p&&(X+=`var destructors = [];
`);var Q=p?"destructors":"null",oe=["humanName","throwBindingError","invoker","fn","runDestructors","retType","classParam"];a&&(X+=`var thisWired = classParam['toWireType'](${Q}, this);
`);for(var F=0;F<_;++F)X+=`var arg${F}Wired = argType${F}['toWireType'](${Q}, arg${F});
`,oe.push(`argType${F}`);X+=(c||u?"var rv = ":"")+`invoker(${A});
`;var fe=c?"rv":"";if(p)X+=`runDestructors(destructors);
`;else for(var F=a?1:2;F<r.length;++F){var ce=F===1?"thisWired":"arg"+(F-2)+"Wired";r[F].destructorFunction!==null&&(X+=`${ce}_dtor(${ce});
`,oe.push(`${ce}_dtor`))}return c&&(X+=`var ret = retType['fromWireType'](rv);
return ret;
`),X+=`}
`,oe.push("checkArgCount","minArgs","maxArgs"),X=`if (arguments.length !== ${oe.length}){ throw new Error(humanName + "Expected ${oe.length} closure arguments " + arguments.length + " given."); }
${X}`,[oe,X]}function tp(r){for(var a=r.length-2,c=r.length-1;c>=2&&r[c].optional;--c)a--;return a}function Ta(r,a,c,u,p,_){var w=a.length;w<2&&xt("argTypes array size mismatch! Must at least get return value and 'this' types!"),G(!_,"Async bindings are only supported with JSPI.");for(var A=a[1]!==null&&c!==null,F=kh(a),X=a[0].name!=="void",Q=w-2,oe=tp(a),fe=[r,xt,u,p,Ea,a[0],a[1]],ce=0;ce<w-2;++ce)fe.push(a[ce+2]);if(!F)for(var ce=A?1:2;ce<a.length;++ce)a[ce].destructorFunction!==null&&fe.push(a[ce].destructorFunction);fe.push(zh,oe,Q);var me=A?1:2,Ye=function(...vt){zh(vt.length,oe,Q,r,xt);for(var at=F?[]:null,bt=A?[a[1].toWireType(at,this)]:[],nt=0;nt<Q;++nt)bt.push(a[nt+2].toWireType(at,vt[nt]));var qt=u(p,...bt);if(F)Ea(at);else for(var nt=me;nt<a.length;++nt)a[nt].destructorFunction?.(bt[nt-me]);if(X)return a[0].fromWireType(qt)};return xa(r,Ye)}var Aa=(r,a)=>{for(var c=[],u=0;u<r;u++)c.push($e[a+u*4>>2]);return c},Wl=r=>{r=r.trim();let a=r.indexOf("(");return a===-1?r:(G(r.endsWith(")"),"Parentheses for argument names should match."),r.slice(0,a))},np=(r,a,c,u,p,_,w,A,F)=>{var X=Aa(c,u);a=Zt(a),a=Wl(a),_=ri(p,_,A),Hn([],[r],Q=>{Q=Q[0];var oe=`${Q.name}.${a}`;function fe(){tr(`Cannot call ${oe} due to unbound types`,X)}a.startsWith("@@")&&(a=Symbol[a.substring(2)]);var ce=Q.registeredClass.constructor;return ce[a]===void 0?(fe.argCount=c-1,ce[a]=fe):(Vl(ce,a,oe),ce[a].overloadTable[c-1]=fe),Hn([],X,me=>{var Ye=[me[0],null].concat(me.slice(1)),vt=Ta(oe,Ye,null,_,w,A);if(ce[a].overloadTable===void 0?(vt.argCount=c-1,ce[a]=vt):ce[a].overloadTable[c-1]=vt,Q.registeredClass.__derivedClasses)for(let at of Q.registeredClass.__derivedClasses)at.constructor.hasOwnProperty(a)||(at.constructor[a]=vt);return[]}),[]})},ip=(r,a,c,u,p,_)=>{G(a>0);var w=Aa(a,c);p=ri(u,p);var A=[_],F=[];Hn([],[r],X=>{X=X[0];var Q=`constructor ${X.name}`;if(X.registeredClass.constructor_body===void 0&&(X.registeredClass.constructor_body=[]),X.registeredClass.constructor_body[a-1]!==void 0)throw new os(`Cannot register multiple constructors with identical number of parameters (${a-1}) for class '${X.name}'! Overload resolution is currently only performed using the parameter count, not actual type info!`);return X.registeredClass.constructor_body[a-1]=()=>{tr(`Cannot construct ${X.name} due to unbound types`,w)},Hn([],w,oe=>(oe.splice(1,0,null),X.registeredClass.constructor_body[a-1]=Ta(Q,oe,null,p,_),[])),[]})},rp=(r,a,c,u,p,_,w,A,F,X)=>{var Q=Aa(c,u);a=Zt(a),a=Wl(a),_=ri(p,_,F),Hn([],[r],oe=>{oe=oe[0];var fe=`${oe.name}.${a}`;a.startsWith("@@")&&(a=Symbol[a.substring(2)]),A&&oe.registeredClass.pureVirtualFunctions.push(a);function ce(){tr(`Cannot call ${fe} due to unbound types`,Q)}var me=oe.registeredClass.instancePrototype,Ye=me[a];return Ye===void 0||Ye.overloadTable===void 0&&Ye.className!==oe.name&&Ye.argCount===c-2?(ce.argCount=c-2,ce.className=oe.name,me[a]=ce):(Vl(me,a,fe),me[a].overloadTable[c-2]=ce),Hn([],Q,vt=>{var at=Ta(fe,vt,oe,_,w,F);return me[a].overloadTable===void 0?(at.argCount=c-2,me[a]=at):me[a].overloadTable[c-2]=at,[]}),[]})},Gh=(r,a,c)=>(r instanceof Object||xt(`${c} with invalid "this": ${r}`),r instanceof a.registeredClass.constructor||xt(`${c} incompatible with "this" of type ${r.constructor.name}`),r.$$.ptr||xt(`cannot call emscripten binding method ${c} on deleted object`),Sa(r.$$.ptr,r.$$.ptrType.registeredClass,a.registeredClass)),sp=(r,a,c,u,p,_,w,A,F,X)=>{a=Zt(a),p=ri(u,p),Hn([],[r],Q=>{Q=Q[0];var oe=`${Q.name}.${a}`,fe={get(){tr(`Cannot access ${oe} due to unbound types`,[c,w])},enumerable:!0,configurable:!0};return F?fe.set=()=>tr(`Cannot access ${oe} due to unbound types`,[c,w]):fe.set=ce=>xt(oe+" is a read-only property"),Object.defineProperty(Q.registeredClass.instancePrototype,a,fe),Hn([],F?[c,w]:[c],ce=>{var me=ce[0],Ye={get(){var at=Gh(this,Q,oe+" getter");return me.fromWireType(p(_,at))},enumerable:!0};if(F){F=ri(A,F);var vt=ce[1];Ye.set=function(at){var bt=Gh(this,Q,oe+" setter"),nt=[];F(X,bt,vt.toWireType(nt,at)),Ea(nt)}}return Object.defineProperty(Q.registeredClass.instancePrototype,a,Ye),[]}),[]})},ap=(r,a,c)=>{r=Zt(r),Hn([],[a],u=>(u=u[0],t[r]=u.fromWireType(c),[]))},Vh=[],si=[0,1,,1,null,1,!0,1,!1,1],Xl=r=>{r>9&&--si[r+1]===0&&(G(si[r]!==void 0,"Decref for unallocated handle."),si[r]=void 0,Vh.push(r))},Jt={toValue:r=>(r||xt(`Cannot use deleted val. handle = ${r}`),G(r===2||si[r]!==void 0&&r%2===0,`invalid handle: ${r}`),si[r]),toHandle:r=>{switch(r){case void 0:return 2;case null:return 4;case!0:return 6;case!1:return 8;default:{let a=Vh.pop()||si.length;return si[a]=r,si[a+1]=1,a}}}},Hh={name:"emscripten::val",fromWireType:r=>{var a=Jt.toValue(r);return Xl(r),a},toWireType:(r,a)=>Jt.toHandle(a),argPackAdvance:ii,readValueFromPointer:Ma,destructorFunction:null},Wh=r=>Un(r,Hh),op=(r,a,c)=>{switch(a){case 1:return c?function(u){return this.fromWireType(pt[u])}:function(u){return this.fromWireType(It[u])};case 2:return c?function(u){return this.fromWireType(Mt[u>>1])}:function(u){return this.fromWireType(rn[u>>1])};case 4:return c?function(u){return this.fromWireType(De[u>>2])}:function(u){return this.fromWireType($e[u>>2])};default:throw new TypeError(`invalid integer width (${a}): ${r}`)}},lp=(r,a,c,u)=>{a=Zt(a);function p(){}p.values={},Un(r,{name:a,constructor:p,fromWireType:function(_){return this.constructor.values[_]},toWireType:(_,w)=>w.value,argPackAdvance:ii,readValueFromPointer:op(a,c,u),destructorFunction:null}),Hl(a,p)},Ra=(r,a)=>{var c=Qi[r];return c===void 0&&xt(`${a} has unknown type ${Bh(r)}`),c},cp=(r,a,c)=>{var u=Ra(r,"enum");a=Zt(a);var p=u.constructor,_=Object.create(u.constructor.prototype,{value:{value:c},constructor:{value:xa(`${u.name}_${a}`,function(){})}});p.values[c]=_,p[a]=_},hp=(r,a)=>{switch(a){case 4:return function(c){return this.fromWireType(hn[c>>2])};case 8:return function(c){return this.fromWireType(sn[c>>3])};default:throw new TypeError(`invalid float width (${a}): ${r}`)}},up=(r,a,c)=>{a=Zt(a),Un(r,{name:a,fromWireType:u=>u,toWireType:(u,p)=>{if(typeof p!="number"&&typeof p!="boolean")throw new TypeError(`Cannot convert ${er(p)} to ${this.name}`);return p},argPackAdvance:ii,readValueFromPointer:hp(a,c),destructorFunction:null})},dp=(r,a,c,u,p,_,w,A)=>{var F=Aa(a,c);r=Zt(r),r=Wl(r),p=ri(u,p,w),Hl(r,function(){tr(`Cannot call ${r} due to unbound types`,F)},a-1),Hn([],F,X=>{var Q=[X[0],null].concat(X.slice(1));return Uh(r,Ta(r,Q,null,p,_,w),a-1),[]})},fp=(r,a,c,u,p)=>{a=Zt(a);let _=u===0,w=F=>F;if(_){var A=32-8*c;w=F=>F<<A>>>A,p=w(p)}Un(r,{name:a,fromWireType:w,toWireType:(F,X)=>{if(typeof X!="number"&&typeof X!="boolean")throw new TypeError(`Cannot convert "${er(X)}" to ${a}`);return Ch(a,X,u,p),X},argPackAdvance:ii,readValueFromPointer:Rh(a,c,u!==0),destructorFunction:null})},pp=(r,a,c)=>{var u=[Int8Array,Uint8Array,Int16Array,Uint16Array,Int32Array,Uint32Array,Float32Array,Float64Array,BigInt64Array,BigUint64Array],p=u[a];function _(w){var A=$e[w>>2],F=$e[w+4>>2];return new p(pt.buffer,F,A)}c=Zt(c),Un(r,{name:c,fromWireType:_,argPackAdvance:ii,readValueFromPointer:_},{ignoreDuplicateRegistrations:!0})},mp=Object.assign({optional:!0},Hh),gp=(r,a)=>{Un(r,mp)},nr=(r,a,c)=>(G(typeof c=="number","stringToUTF8(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),st(r,It,a,c)),_p=(r,a)=>{a=Zt(a);var c=!0;Un(r,{name:a,fromWireType(u){var p=$e[u>>2],_=u+4,w;if(c)for(var A=_,F=0;F<=p;++F){var X=_+F;if(F==p||It[X]==0){var Q=X-A,oe=un(A,Q);w===void 0?w=oe:(w+="\0",w+=oe),A=X+1}}else{for(var fe=new Array(p),F=0;F<p;++F)fe[F]=String.fromCharCode(It[_+F]);w=fe.join("")}return Wn(u),w},toWireType(u,p){p instanceof ArrayBuffer&&(p=new Uint8Array(p));var _,w=typeof p=="string";w||ArrayBuffer.isView(p)&&p.BYTES_PER_ELEMENT==1||xt("Cannot pass non-string to std::string"),c&&w?_=Ge(p):_=p.length;var A=Zl(4+_+1),F=A+4;if($e[A>>2]=_,w)if(c)nr(p,F,_+1);else for(var X=0;X<_;++X){var Q=p.charCodeAt(X);Q>255&&(Wn(A),xt("String has UTF-16 code units that do not fit in 8 bits")),It[F+X]=Q}else It.set(p,F);return u!==null&&u.push(Wn,A),A},argPackAdvance:ii,readValueFromPointer:Ma,destructorFunction(u){Wn(u)}})},Xh=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0,vp=(r,a)=>{G(r%2==0,"Pointer passed to UTF16ToString must be aligned to two bytes!");for(var c=r>>1,u=c+a/2,p=c;!(p>=u)&&rn[p];)++p;if(p-c>16&&Xh)return Xh.decode(rn.subarray(c,p));for(var _="",w=c;!(w>=u);++w){var A=rn[w];if(A==0)break;_+=String.fromCharCode(A)}return _},yp=(r,a,c)=>{if(G(a%2==0,"Pointer passed to stringToUTF16 must be aligned to two bytes!"),G(typeof c=="number","stringToUTF16(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),c??=2147483647,c<2)return 0;c-=2;for(var u=a,p=c<r.length*2?c/2:r.length,_=0;_<p;++_){var w=r.charCodeAt(_);Mt[a>>1]=w,a+=2}return Mt[a>>1]=0,a-u},xp=r=>r.length*2,Sp=(r,a)=>{G(r%4==0,"Pointer passed to UTF32ToString must be aligned to four bytes!");for(var c="",u=0;!(u>=a/4);u++){var p=De[r+u*4>>2];if(!p)break;c+=String.fromCodePoint(p)}return c},Mp=(r,a,c)=>{if(G(a%4==0,"Pointer passed to stringToUTF32 must be aligned to four bytes!"),G(typeof c=="number","stringToUTF32(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),c??=2147483647,c<4)return 0;for(var u=a,p=u+c-4,_=0;_<r.length;++_){var w=r.codePointAt(_);if(w>65535&&_++,De[a>>2]=w,a+=4,a+4>p)break}return De[a>>2]=0,a-u},bp=r=>{for(var a=0,c=0;c<r.length;++c){var u=r.codePointAt(c);u>65535&&c++,a+=4}return a},wp=(r,a,c)=>{c=Zt(c);var u,p,_,w;a===2?(u=vp,p=yp,w=xp,_=A=>rn[A>>1]):a===4&&(u=Sp,p=Mp,w=bp,_=A=>$e[A>>2]),Un(r,{name:c,fromWireType:A=>{for(var F=$e[A>>2],X,Q=A+4,oe=0;oe<=F;++oe){var fe=A+4+oe*a;if(oe==F||_(fe)==0){var ce=fe-Q,me=u(Q,ce);X===void 0?X=me:(X+="\0",X+=me),Q=fe+a}}return Wn(A),X},toWireType:(A,F)=>{typeof F!="string"&&xt(`Cannot pass non-string to C++ string type ${c}`);var X=w(F),Q=Zl(4+X+a);return $e[Q>>2]=X/a,p(F,Q+4,X+a),A!==null&&A.push(Wn,Q),Q},argPackAdvance:ii,readValueFromPointer:Ma,destructorFunction(A){Wn(A)}})},Ep=(r,a)=>{Wh(r)},Tp=(r,a)=>{a=Zt(a),Un(r,{isVoid:!0,name:a,argPackAdvance:0,fromWireType:()=>{},toWireType:(c,u)=>{}})},Ap=()=>{throw new ge},$l=(r,a,c)=>{var u=[],p=r.toWireType(u,c);return u.length&&($e[a>>2]=Jt.toHandle(u)),p},Rp=(r,a,c)=>(r=Jt.toValue(r),a=Ra(a,"emval::as"),$l(a,c,r)),Ca=[],Cp=(r,a,c,u)=>(r=Ca[r],a=Jt.toValue(a),r(null,a,c,u)),Pp={},ql=r=>{var a=Pp[r];return a===void 0?Zt(r):a},Ip=(r,a,c,u,p)=>(r=Ca[r],a=Jt.toValue(a),c=ql(c),r(a,a[c],u,p)),$h=()=>globalThis,Dp=r=>r===0?Jt.toHandle($h()):(r=ql(r),Jt.toHandle($h()[r])),Lp=r=>{var a=Ca.length;return Ca.push(r),a},Fp=(r,a)=>{for(var c=new Array(r),u=0;u<r;++u)c[u]=Ra($e[a+u*4>>2],`parameter ${u}`);return c},Np=(r,a,c)=>{var u=Fp(r,a),p=u.shift();r--;var _=`return function (obj, func, destructorsRef, args) {
`,w=0,A=[];c===0&&A.push("obj");for(var F=["retType"],X=[p],Q=0;Q<r;++Q)A.push(`arg${Q}`),F.push(`argType${Q}`),X.push(u[Q]),_+=`  var arg${Q} = argType${Q}.readValueFromPointer(args${w?"+"+w:""});
`,w+=u[Q].argPackAdvance;var oe=c===1?"new func":"func.call";_+=`  var rv = ${oe}(${A.join(", ")});
`,p.isVoid||(F.push("emval_returnValue"),X.push($l),_+=`  return emval_returnValue(retType, destructorsRef, rv);
`),_+=`};
`;var fe=(me,Ye,vt,at)=>{for(var bt=c===0?[me]:[],nt=0;nt<r;++nt)bt.push(u[nt].readValueFromPointer(at)),at+=u[nt].argPackAdvance;var qt=c===1?new Ye(...bt):Ye.call(...bt);if(!p.isVoid)return $l(p,vt,qt)},ce=`methodCaller<(${u.map(me=>me.name).join(", ")}) => ${p.name}>`;return Lp(xa(ce,fe))},Up=(r,a)=>(r=Jt.toValue(r),a=Jt.toValue(a),Jt.toHandle(r[a])),Op=r=>{r>9&&(si[r+1]+=1)},Bp=r=>(r=Jt.toValue(r),typeof r=="number"),kp=r=>(r=Jt.toValue(r),typeof r=="string"),zp=()=>Jt.toHandle([]),Gp=r=>Jt.toHandle(ql(r)),Vp=r=>{var a=Jt.toValue(r);Ea(a),Xl(r)},Hp=(r,a)=>{r=Ra(r,"_emval_take_value");var c=r.readValueFromPointer(a);return Jt.toHandle(c)},Wp=r=>{throw r=Jt.toValue(r),r},Xp=r=>r%4===0&&(r%100!==0||r%400===0),$p=[0,31,60,91,121,152,182,213,244,274,305,335],qp=[0,31,59,90,120,151,181,212,243,273,304,334],qh=r=>{var a=Xp(r.getFullYear()),c=a?$p:qp,u=c[r.getMonth()]+r.getDate()-1;return u},Yp=9007199254740992,jp=-9007199254740992,Yl=r=>r<jp||r>Yp?NaN:Number(r);function Zp(r,a){r=Yl(r);var c=new Date(r*1e3);De[a>>2]=c.getSeconds(),De[a+4>>2]=c.getMinutes(),De[a+8>>2]=c.getHours(),De[a+12>>2]=c.getDate(),De[a+16>>2]=c.getMonth(),De[a+20>>2]=c.getFullYear()-1900,De[a+24>>2]=c.getDay();var u=qh(c)|0;De[a+28>>2]=u,De[a+36>>2]=-(c.getTimezoneOffset()*60);var p=new Date(c.getFullYear(),0,1),_=new Date(c.getFullYear(),6,1).getTimezoneOffset(),w=p.getTimezoneOffset(),A=(_!=w&&c.getTimezoneOffset()==Math.min(w,_))|0;De[a+32>>2]=A}var Jp=function(r){var a=(()=>{var c=new Date(De[r+20>>2]+1900,De[r+16>>2],De[r+12>>2],De[r+8>>2],De[r+4>>2],De[r>>2],0),u=De[r+32>>2],p=c.getTimezoneOffset(),_=new Date(c.getFullYear(),0,1),w=new Date(c.getFullYear(),6,1).getTimezoneOffset(),A=_.getTimezoneOffset(),F=Math.min(A,w);if(u<0)De[r+32>>2]=+(w!=A&&F==p);else if(u>0!=(F==p)){var X=Math.max(A,w),Q=u>0?F:X;c.setTime(c.getTime()+(Q-p)*6e4)}De[r+24>>2]=c.getDay();var oe=qh(c)|0;De[r+28>>2]=oe,De[r>>2]=c.getSeconds(),De[r+4>>2]=c.getMinutes(),De[r+8>>2]=c.getHours(),De[r+12>>2]=c.getDate(),De[r+16>>2]=c.getMonth(),De[r+20>>2]=c.getYear();var fe=c.getTime();return isNaN(fe)?-1:fe/1e3})();return BigInt(a)},Kp=(r,a,c,u)=>{var p=new Date().getFullYear(),_=new Date(p,0,1),w=new Date(p,6,1),A=_.getTimezoneOffset(),F=w.getTimezoneOffset(),X=Math.max(A,F);$e[r>>2]=X*60,De[a>>2]=+(A!=F);var Q=ce=>{var me=ce>=0?"-":"+",Ye=Math.abs(ce),vt=String(Math.floor(Ye/60)).padStart(2,"0"),at=String(Ye%60).padStart(2,"0");return`UTC${me}${vt}${at}`},oe=Q(A),fe=Q(F);G(oe),G(fe),G(Ge(oe)<=16,`timezone name truncated to fit in TZNAME_MAX (${oe})`),G(Ge(fe)<=16,`timezone name truncated to fit in TZNAME_MAX (${fe})`),F<A?(nr(oe,c,17),nr(fe,u,17)):(nr(oe,u,17),nr(fe,c,17))},Yh=()=>performance.now(),jh=()=>Date.now(),Qp=1,em=r=>r>=0&&r<=3;function tm(r,a,c){if(a=Yl(a),!em(r))return 28;var u;if(r===0)u=jh();else if(Qp)u=Yh();else return 52;var p=Math.round(u*1e3*1e3);return W[c>>3]=BigInt(p),0}var Pa=[],nm=(r,a)=>{G(Array.isArray(Pa)),G(a%16==0),Pa.length=0;for(var c;c=It[r++];){var u=String.fromCharCode(c),p=["d","f","i","p"];p.push("j"),G(p.includes(u),`Invalid character ${c}("${u}") in readEmAsmArgs! Use only [${p}], and do not specify "v" for void return argument.`);var _=c!=105;_&=c!=112,a+=_&&a%8?4:0,Pa.push(c==112?$e[a>>2]:c==106?W[a>>3]:c==105?De[a>>2]:sn[a>>3]),a+=_?8:4}return Pa},im=(r,a,c)=>{var u=nm(a,c);return G(tu.hasOwnProperty(r),`No EM_ASM constant found at address ${r}.  The loaded WebAssembly file is likely out of sync with the generated JavaScript.`),tu[r](...u)},rm=(r,a,c)=>im(r,a,c),Zh=()=>2147483648,sm=()=>Zh(),am=(r,a)=>(G(a,"alignment argument is required"),Math.ceil(r/a)*a),om=r=>{var a=Ht.buffer,c=(r-a.byteLength+65535)/65536|0;try{return Ht.grow(c),Ut(),1}catch(u){I(`growMemory: Attempted to grow heap from ${a.byteLength} bytes to ${r} bytes, but got error: ${u}`)}},lm=r=>{var a=It.length;r>>>=0,G(r>a);var c=Zh();if(r>c)return I(`Cannot enlarge memory, requested ${r} bytes, but the limit is ${c} bytes!`),!1;for(var u=1;u<=4;u*=2){var p=a*(1+.2/u);p=Math.min(p,r+100663296);var _=Math.min(c,am(Math.max(r,p),65536)),w=om(_);if(w)return!0}return I(`Failed to grow the heap from ${a} bytes to ${_} bytes, not enough memory!`),!1},jl={},cm=()=>d||"./this.program",cs=()=>{if(!cs.strings){var r=(typeof navigator=="object"&&navigator.language||"C").replace("-","_")+".UTF-8",a={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:r,_:cm()};for(var c in jl)jl[c]===void 0?delete a[c]:a[c]=jl[c];var u=[];for(var c in a)u.push(`${c}=${a[c]}`);cs.strings=u}return cs.strings},hm=(r,a)=>{var c=0,u=0;for(var p of cs()){var _=a+c;$e[r+u>>2]=_,c+=nr(p,_,1/0)+1,u+=4}return 0},um=(r,a)=>{var c=cs();$e[r>>2]=c.length;var u=0;for(var p of c)u+=Ge(p)+1;return $e[a>>2]=u,0},Jh=0,Kh=()=>Tt||Jh>0,dm=r=>{ie=r,Kh()||(t.onExit?.(r),z=!0),m(r,new Ae(r))},fm=(r,a)=>{if(ie=r,A_(),Kh()&&!a){var c=`program exited (with status: ${r}), but keepRuntimeAlive() is set (counter=${Jh}) due to an async operation, so halting execution but not exiting the runtime or preventing further async execution (you can use emscripten_force_exit, if you want to force a true shutdown)`;mt?.(c),I(c)}dm(r)},pm=fm;function mm(r){try{var a=ft.getStreamFromFD(r);return M.close(a),0}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return c.errno}}var gm=(r,a,c,u)=>{for(var p=0,_=0;_<c;_++){var w=$e[a>>2],A=$e[a+4>>2];a+=8;var F=M.read(r,pt,w,A,u);if(F<0)return-1;if(p+=F,F<A)break;typeof u<"u"&&(u+=F)}return p};function _m(r,a,c,u){try{var p=ft.getStreamFromFD(r),_=gm(p,a,c);return $e[u>>2]=_,0}catch(w){if(typeof M>"u"||w.name!=="ErrnoError")throw w;return w.errno}}function vm(r,a,c,u){a=Yl(a);try{if(isNaN(a))return 61;var p=ft.getStreamFromFD(r);return M.llseek(p,a,c),W[u>>3]=BigInt(p.position),p.getdents&&a===0&&c===0&&(p.getdents=null),0}catch(_){if(typeof M>"u"||_.name!=="ErrnoError")throw _;return _.errno}}var ym=(r,a,c,u)=>{for(var p=0,_=0;_<c;_++){var w=$e[a>>2],A=$e[a+4>>2];a+=8;var F=M.write(r,pt,w,A,u);if(F<0)return-1;if(p+=F,F<A)break;typeof u<"u"&&(u+=F)}return p};function xm(r,a,c,u){try{var p=ft.getStreamFromFD(r),_=ym(p,a,c);return $e[u>>2]=_,0}catch(w){if(typeof M>"u"||w.name!=="ErrnoError")throw w;return w.errno}}var Sm=r=>r,Mm=r=>{var a=t["_"+r];return G(a,"Cannot call unknown function "+r+", make sure it is exported"),a},bm=(r,a)=>{G(r.length>=0,"writeArrayToMemory array must have a length (should be an array or typed array)"),pt.set(r,a)},Ia=r=>ou(r),wm=r=>{var a=Ge(r)+1,c=Ia(a);return nr(r,c,a),c},Qh=(r,a,c,u,p)=>{var _={string:me=>{var Ye=0;return me!=null&&me!==0&&(Ye=wm(me)),Ye},array:me=>{var Ye=Ia(me.length);return bm(me,Ye),Ye}};function w(me){return a==="string"?un(me):a==="boolean"?!!me:me}var A=Mm(r),F=[],X=0;if(G(a!=="array",'Return type should not be "array".'),u)for(var Q=0;Q<u.length;Q++){var oe=_[c[Q]];oe?(X===0&&(X=_e()),F[Q]=oe(u[Q])):F[Q]=u[Q]}var fe=A(...F);function ce(me){return X!==0&&ye(X),w(me)}return fe=ce(fe),fe},Em=(r,a,c,u)=>(...p)=>Qh(r,a,c,p,u),Tm=(...r)=>M.createPath(...r),Am=(...r)=>M.unlink(...r),Rm=(...r)=>M.createLazyFile(...r),Cm=(...r)=>M.createDevice(...r),Pm=r=>Da(r),Im=r=>Ql(r),Dm=r=>{var a=_e(),c=Ia(4),u=Ia(4);cu(r,c,u);var p=$e[c>>2],_=$e[u>>2],w=un(p);Wn(p);var A;return _&&(A=un(_),Wn(_)),ye(a),[w,A]},eu=r=>Dm(r);M.createPreloadedFile=ei,M.staticInit(),Wf(),Kf(),G(si.length===10),t.noExitRuntime&&(Tt=t.noExitRuntime),t.preloadPlugins&&(an=t.preloadPlugins),t.print&&(U=t.print),t.printErr&&(I=t.printErr),t.wasmBinary&&(ee=t.wasmBinary),Nm(),t.arguments&&(f=t.arguments),t.thisProgram&&(d=t.thisProgram),G(typeof t.memoryInitializerPrefixURL>"u","Module.memoryInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.pthreadMainPrefixURL>"u","Module.pthreadMainPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.cdInitializerPrefixURL>"u","Module.cdInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.filePackagePrefixURL>"u","Module.filePackagePrefixURL option was removed, use Module.locateFile instead"),G(typeof t.read>"u","Module.read option was removed"),G(typeof t.readAsync>"u","Module.readAsync option was removed (modify readAsync in JS)"),G(typeof t.readBinary>"u","Module.readBinary option was removed (modify readBinary in JS)"),G(typeof t.setWindowTitle>"u","Module.setWindowTitle option was removed (modify emscripten_set_window_title in JS)"),G(typeof t.TOTAL_MEMORY>"u","Module.TOTAL_MEMORY has been renamed Module.INITIAL_MEMORY"),G(typeof t.ENVIRONMENT>"u","Module.ENVIRONMENT has been deprecated. To force the environment, use the ENVIRONMENT compile-time option (for example, -sENVIRONMENT=web or -sENVIRONMENT=node)"),G(typeof t.STACK_SIZE>"u","STACK_SIZE can no longer be set at runtime.  Use -sSTACK_SIZE at link time"),G(typeof t.wasmMemory>"u","Use of `wasmMemory` detected.  Use -sIMPORTED_MEMORY to define wasmMemory externally"),G(typeof t.INITIAL_MEMORY>"u","Detected runtime INITIAL_MEMORY setting.  Use -sIMPORTED_MEMORY to define wasmMemory dynamically"),t.addRunDependency=ve,t.removeRunDependency=de,t.ccall=Qh,t.cwrap=Em,t.FS_createPreloadedFile=ei,t.FS_unlink=Am,t.FS_createPath=Tm,t.FS_createDevice=Cm,t.FS=M,t.FS_createDataFile=jt,t.FS_createLazyFile=Rm,t.MEMFS=ke;var Lm=["writeI53ToI64","writeI53ToI64Clamped","writeI53ToI64Signaling","writeI53ToU64Clamped","writeI53ToU64Signaling","readI53FromI64","readI53FromU64","convertI32PairToI53","convertI32PairToI53Checked","convertU32PairToI53","getTempRet0","zeroMemory","withStackSave","inetPton4","inetNtop4","inetPton6","inetNtop6","readSockaddr","writeSockaddr","emscriptenLog","runMainThreadEmAsm","jstoi_q","autoResumeAudioContext","getDynCaller","dynCall","handleException","runtimeKeepalivePush","runtimeKeepalivePop","callUserCallback","maybeExit","asmjsMangle","HandleAllocator","getNativeTypeSize","addOnInit","addOnPostCtor","addOnPreMain","addOnExit","STACK_SIZE","STACK_ALIGN","POINTER_SIZE","ASSERTIONS","uleb128Encode","sigToWasmTypes","generateFuncType","convertJsFunctionToWasm","getEmptyTableSlot","updateTableMap","getFunctionAddress","addFunction","removeFunction","reallyNegative","unSign","strLen","reSign","formatString","intArrayToString","stringToAscii","stringToNewUTF8","registerKeyEventCallback","maybeCStringToJsString","findEventTarget","getBoundingClientRect","fillMouseEventData","registerMouseEventCallback","registerWheelEventCallback","registerUiEventCallback","registerFocusEventCallback","fillDeviceOrientationEventData","registerDeviceOrientationEventCallback","fillDeviceMotionEventData","registerDeviceMotionEventCallback","screenOrientation","fillOrientationChangeEventData","registerOrientationChangeEventCallback","fillFullscreenChangeEventData","registerFullscreenChangeEventCallback","JSEvents_requestFullscreen","JSEvents_resizeCanvasForFullscreen","registerRestoreOldStyle","hideEverythingExceptGivenElement","restoreHiddenElements","setLetterbox","softFullscreenResizeWebGLRenderTarget","doRequestFullscreen","fillPointerlockChangeEventData","registerPointerlockChangeEventCallback","registerPointerlockErrorEventCallback","requestPointerLock","fillVisibilityChangeEventData","registerVisibilityChangeEventCallback","registerTouchEventCallback","fillGamepadEventData","registerGamepadEventCallback","registerBeforeUnloadEventCallback","fillBatteryEventData","battery","registerBatteryEventCallback","setCanvasElementSize","getCanvasElementSize","jsStackTrace","getCallstack","convertPCtoSourceLocation","wasiRightsToMuslOFlags","wasiOFlagsToMuslOFlags","safeSetTimeout","setImmediateWrapped","safeRequestAnimationFrame","clearImmediateWrapped","registerPostMainLoop","registerPreMainLoop","getPromise","makePromise","idsToPromises","makePromiseCallback","Browser_asyncPrepareDataCounter","arraySum","addDays","getSocketFromFD","getSocketAddress","FS_mkdirTree","_setNetworkCallback","heapObjectForWebGLType","toTypedArrayIndex","webgl_enable_ANGLE_instanced_arrays","webgl_enable_OES_vertex_array_object","webgl_enable_WEBGL_draw_buffers","webgl_enable_WEBGL_multi_draw","webgl_enable_EXT_polygon_offset_clamp","webgl_enable_EXT_clip_control","webgl_enable_WEBGL_polygon_mode","emscriptenWebGLGet","computeUnpackAlignedImageSize","colorChannelsInGlTextureFormat","emscriptenWebGLGetTexPixelData","emscriptenWebGLGetUniform","webglGetUniformLocation","webglPrepareUniformLocationsBeforeFirstUse","webglGetLeftBracePos","emscriptenWebGLGetVertexAttrib","__glGetActiveAttribOrUniform","writeGLArray","registerWebGlEventCallback","runAndAbortIfError","ALLOC_NORMAL","ALLOC_STACK","allocate","writeStringToMemory","writeAsciiToMemory","demangle","stackTrace","getFunctionArgsName","createJsInvokerSignature","PureVirtualError","registerInheritedInstance","unregisterInheritedInstance","getInheritedInstanceCount","getLiveInheritedInstances","setDelayFunction","count_emval_handles"];Lm.forEach(Ke);var Fm=["run","out","err","callMain","abort","wasmMemory","wasmExports","HEAPF32","HEAPF64","HEAP8","HEAPU8","HEAP16","HEAPU16","HEAP32","HEAPU32","HEAP64","HEAPU64","writeStackCookie","checkStackCookie","INT53_MAX","INT53_MIN","bigintToI53Checked","stackSave","stackRestore","stackAlloc","setTempRet0","ptrToString","exitJS","getHeapMax","growMemory","ENV","ERRNO_CODES","strError","DNS","Protocols","Sockets","timers","warnOnce","readEmAsmArgsArray","readEmAsmArgs","runEmAsmFunction","getExecutableName","keepRuntimeAlive","asyncLoad","alignMemory","mmapAlloc","wasmTable","getUniqueRunDependency","noExitRuntime","addOnPreRun","addOnPostRun","freeTableIndexes","functionsInTableMap","setValue","getValue","PATH","PATH_FS","UTF8Decoder","UTF8ArrayToString","UTF8ToString","stringToUTF8Array","stringToUTF8","lengthBytesUTF8","intArrayFromString","AsciiToString","UTF16Decoder","UTF16ToString","stringToUTF16","lengthBytesUTF16","UTF32ToString","stringToUTF32","lengthBytesUTF32","stringToUTF8OnStack","writeArrayToMemory","JSEvents","specialHTMLTargets","findCanvasEventTarget","currentFullscreenStrategy","restoreOldWindowedStyle","UNWIND_CACHE","ExitStatus","getEnvStrings","checkWasiClock","doReadv","doWritev","initRandomFill","randomFill","emSetImmediate","emClearImmediate_deps","emClearImmediate","promiseMap","uncaughtExceptionCount","exceptionLast","exceptionCaught","ExceptionInfo","findMatchingCatch","getExceptionMessageCommon","Browser","requestFullscreen","requestFullScreen","setCanvasSize","getUserMedia","createContext","getPreloadedImageData__data","wget","MONTH_DAYS_REGULAR","MONTH_DAYS_LEAP","MONTH_DAYS_REGULAR_CUMULATIVE","MONTH_DAYS_LEAP_CUMULATIVE","isLeapYear","ydayFromDate","SYSCALLS","preloadPlugins","FS_modeStringToFlags","FS_getMode","FS_stdin_getChar_buffer","FS_stdin_getChar","FS_readFile","FS_root","FS_mounts","FS_devices","FS_streams","FS_nextInode","FS_nameTable","FS_currentPath","FS_initialized","FS_ignorePermissions","FS_filesystems","FS_syncFSRequests","FS_readFiles","FS_lookupPath","FS_getPath","FS_hashName","FS_hashAddNode","FS_hashRemoveNode","FS_lookupNode","FS_createNode","FS_destroyNode","FS_isRoot","FS_isMountpoint","FS_isFile","FS_isDir","FS_isLink","FS_isChrdev","FS_isBlkdev","FS_isFIFO","FS_isSocket","FS_flagsToPermissionString","FS_nodePermissions","FS_mayLookup","FS_mayCreate","FS_mayDelete","FS_mayOpen","FS_checkOpExists","FS_nextfd","FS_getStreamChecked","FS_getStream","FS_createStream","FS_closeStream","FS_dupStream","FS_doSetAttr","FS_chrdev_stream_ops","FS_major","FS_minor","FS_makedev","FS_registerDevice","FS_getDevice","FS_getMounts","FS_syncfs","FS_mount","FS_unmount","FS_lookup","FS_mknod","FS_statfs","FS_statfsStream","FS_statfsNode","FS_create","FS_mkdir","FS_mkdev","FS_symlink","FS_rename","FS_rmdir","FS_readdir","FS_readlink","FS_stat","FS_fstat","FS_lstat","FS_doChmod","FS_chmod","FS_lchmod","FS_fchmod","FS_doChown","FS_chown","FS_lchown","FS_fchown","FS_doTruncate","FS_truncate","FS_ftruncate","FS_utime","FS_open","FS_close","FS_isClosed","FS_llseek","FS_read","FS_write","FS_mmap","FS_msync","FS_ioctl","FS_writeFile","FS_cwd","FS_chdir","FS_createDefaultDirectories","FS_createDefaultDevices","FS_createSpecialDirectories","FS_createStandardStreams","FS_staticInit","FS_init","FS_quit","FS_findObject","FS_analyzePath","FS_createFile","FS_forceLoadFile","FS_absolutePath","FS_createFolder","FS_createLink","FS_joinPath","FS_mmapAlloc","FS_standardizePath","TTY","PIPEFS","SOCKFS","tempFixedLengthArray","miniTempWebGLFloatBuffers","miniTempWebGLIntBuffers","GL","AL","GLUT","EGL","GLEW","IDBStore","SDL","SDL_gfx","allocateUTF8","allocateUTF8OnStack","print","printErr","jstoi_s","InternalError","BindingError","throwInternalError","throwBindingError","registeredTypes","awaitingDependencies","typeDependencies","tupleRegistrations","structRegistrations","sharedRegisterType","whenDependentTypesAreResolved","getTypeName","getFunctionName","heap32VectorToArray","requireRegisteredType","usesDestructorStack","checkArgCount","getRequiredArgCount","createJsInvoker","UnboundTypeError","GenericWireTypeSize","EmValType","EmValOptionalType","throwUnboundTypeError","ensureOverloadTable","exposePublicSymbol","replacePublicSymbol","createNamedFunction","embindRepr","registeredInstances","getBasestPointer","getInheritedInstance","registeredPointers","registerType","integerReadValueFromPointer","enumReadValueFromPointer","floatReadValueFromPointer","assertIntegerRange","readPointer","runDestructors","craftInvokerFunction","embind__requireFunction","genericPointerToWireType","constNoSmartPtrRawPointerToWireType","nonConstNoSmartPtrRawPointerToWireType","init_RegisteredPointer","RegisteredPointer","RegisteredPointer_fromWireType","runDestructor","releaseClassHandle","finalizationRegistry","detachFinalizer_deps","detachFinalizer","attachFinalizer","makeClassHandle","init_ClassHandle","ClassHandle","throwInstanceAlreadyDeleted","deletionQueue","flushPendingDeletes","delayFunction","RegisteredClass","shallowCopyInternalPointer","downcastPointer","upcastPointer","validateThis","char_0","char_9","makeLegalFunctionName","emval_freelist","emval_handles","emval_symbols","getStringOrSymbol","Emval","emval_get_global","emval_returnValue","emval_lookupTypes","emval_methodCallers","emval_addMethodCaller"];Fm.forEach(Et),t.incrementExceptionRefcount=Pm,t.decrementExceptionRefcount=Im,t.getExceptionMessage=eu;function Nm(){je("fetchSettings")}var tu={679512:()=>{typeof t<"u"&&"mjDISABLESTRING mjENABLESTRING mjFRAMESTRING mjLABELSTRING mjRNDSTRING mjTIMERSTRING mjVISSTRING".split(" ").forEach(function(r){Object.defineProperty(t,r,{get:function(){return t["get_"+r]()},set:function(a){},enumerable:!0,configurable:!0})})}},nu=Pe("___getTypeName"),Zl=Pe("_malloc"),Um=Pe("___cxa_free_exception"),Jl=Pe("_fflush"),Wn=Pe("_free"),Kl=Pe("_emscripten_stack_get_end"),Om=Pe("_emscripten_stack_get_base"),iu=Pe("_strerror"),xe=Pe("_setThrew"),ru=Pe("__emscripten_tempret_set"),su=Pe("_emscripten_stack_init"),Bm=Pe("_emscripten_stack_get_free"),au=Pe("__emscripten_stack_restore"),ou=Pe("__emscripten_stack_alloc"),lu=Pe("_emscripten_stack_get_current"),Ql=Pe("___cxa_decrement_exception_refcount"),Da=Pe("___cxa_increment_exception_refcount"),cu=Pe("___get_exception_message"),hu=Pe("___cxa_can_catch"),uu=Pe("___cxa_get_exception_ptr");function km(r){nu=Me("__getTypeName",1),Zl=Me("malloc",1),Um=Me("__cxa_free_exception",1),Jl=Me("fflush",1),Wn=Me("free",1),Kl=r.emscripten_stack_get_end,Om=r.emscripten_stack_get_base,iu=Me("strerror",1),xe=Me("setThrew",2),ru=Me("_emscripten_tempret_set",1),su=r.emscripten_stack_init,Bm=r.emscripten_stack_get_free,au=r._emscripten_stack_restore,ou=r._emscripten_stack_alloc,lu=r.emscripten_stack_get_current,Ql=Me("__cxa_decrement_exception_refcount",1),Da=Me("__cxa_increment_exception_refcount",1),cu=Me("__get_exception_message",3),hu=Me("__cxa_can_catch",3),uu=Me("__cxa_get_exception_ptr",1)}var du={__assert_fail:ss,__cxa_begin_catch:yr,__cxa_current_primary_exception:fa,__cxa_end_catch:Ji,__cxa_find_matching_catch_2:Ol,__cxa_find_matching_catch_3:Bl,__cxa_find_matching_catch_4:kl,__cxa_rethrow:as,__cxa_rethrow_primary_exception:R,__cxa_throw:V,__cxa_uncaught_exceptions:te,__resumeException:K,__syscall_dup3:Rn,__syscall_fcntl64:Vn,__syscall_fstat64:pa,__syscall_ioctl:Rf,__syscall_lstat64:Cf,__syscall_newfstatat:Pf,__syscall_openat:If,__syscall_stat64:Df,_abort_js:Lf,_embind_register_bigint:Nf,_embind_register_bool:Uf,_embind_register_class:ep,_embind_register_class_class_function:np,_embind_register_class_constructor:ip,_embind_register_class_function:rp,_embind_register_class_property:sp,_embind_register_constant:ap,_embind_register_emval:Wh,_embind_register_enum:lp,_embind_register_enum_value:cp,_embind_register_float:up,_embind_register_function:dp,_embind_register_integer:fp,_embind_register_memory_view:pp,_embind_register_optional:gp,_embind_register_std_string:_p,_embind_register_std_wstring:wp,_embind_register_user_type:Ep,_embind_register_void:Tp,_emscripten_throw_longjmp:Ap,_emval_as:Rp,_emval_call:Cp,_emval_call_method:Ip,_emval_decref:Xl,_emval_get_global:Dp,_emval_get_method_caller:Np,_emval_get_property:Up,_emval_incref:Op,_emval_is_number:Bp,_emval_is_string:kp,_emval_new_array:zp,_emval_new_cstring:Gp,_emval_run_destructors:Vp,_emval_take_value:Hp,_emval_throw:Wp,_localtime_js:Zp,_mktime_js:Jp,_tzset_js:Kp,clock_time_get:tm,emscripten_asm_const_int:rm,emscripten_date_now:jh,emscripten_get_heap_max:sm,emscripten_get_now:Yh,emscripten_resize_heap:lm,environ_get:hm,environ_sizes_get:um,exit:pm,fd_close:mm,fd_read:_m,fd_seek:vm,fd_write:xm,invoke_ddd:d_,invoke_dddi:Cg,invoke_dddidi:Pg,invoke_ddidi:Rg,invoke_di:Ig,invoke_dii:yg,invoke_diii:Qm,invoke_diiii:Ag,invoke_diiiidd:Eg,invoke_diiiidi:ng,invoke_diiiii:Ym,invoke_diiiiii:lg,invoke_diiiiiii:Dg,invoke_diiiiiiiii:ag,invoke_diiiiiiiiiiii:og,invoke_fiii:b_,invoke_i:jm,invoke_id:Jg,invoke_ii:Vm,invoke_iid:Vg,invoke_iidddd:__,invoke_iidiii:gg,invoke_iidiiid:pg,invoke_iidiiiiidi:_g,invoke_iif:g_,invoke_iii:zm,invoke_iiid:vg,invoke_iiididdddddd:mg,invoke_iiidiiiiiiii:fg,invoke_iiii:Xm,invoke_iiiidddiiiii:Fg,invoke_iiiii:Km,invoke_iiiiid:Qg,invoke_iiiiii:qg,invoke_iiiiiii:Wg,invoke_iiiiiiii:Gg,invoke_iiiiiiiidd:e_,invoke_iiiiiiiii:wg,invoke_iiiiiiiiii:Xg,invoke_iiiiiiiiiidddiiiiiiiii:dg,invoke_iiiiiiiiiii:M_,invoke_iiiiiiiiiiii:w_,invoke_iiiiiiiiiiiii:s_,invoke_iiij:$g,invoke_iiji:Kg,invoke_j:x_,invoke_ji:h_,invoke_jiiii:Yg,invoke_jij:u_,invoke_v:Wm,invoke_vi:Hm,invoke_vid:Hg,invoke_viddd:jg,invoke_vidddd:Zg,invoke_vidi:Tg,invoke_vidiii:hg,invoke_vii:qm,invoke_viid:Mg,invoke_viiddi:r_,invoke_viiddidi:i_,invoke_viiddii:Lg,invoke_viidi:Sg,invoke_viidii:tg,invoke_viidiii:kg,invoke_viidiiid:Og,invoke_viidiiiii:ug,invoke_viidiiiiidi:zg,invoke_viidiiiiiiii:cg,invoke_viii:Gm,invoke_viiid:rg,invoke_viiidd:n_,invoke_viiidi:xg,invoke_viiididdddddd:Bg,invoke_viiidiiiiiiii:Ug,invoke_viiii:Jm,invoke_viiiiddd:t_,invoke_viiiidi:f_,invoke_viiiifi:p_,invoke_viiiii:$m,invoke_viiiiid:ig,invoke_viiiiii:Zm,invoke_viiiiiii:eg,invoke_viiiiiiii:bg,invoke_viiiiiiiiii:l_,invoke_viiiiiiiiiidddiiiiiiiii:Ng,invoke_viiiiiiiiiiid:sg,invoke_viiiiiiiiiiiii:o_,invoke_viiiiiiiiiiiiiii:E_,invoke_viiiiiiiiiiiiiiiiii:c_,invoke_viiiij:v_,invoke_viij:y_,invoke_viijii:S_,invoke_vij:m_,invoke_vijjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjj:a_,llvm_eh_typeid_for:Sm},ir=await Ee();function zm(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Gm(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Vm(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Hm(r,a){var c=_e();try{be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Wm(r){var a=_e();try{be(r)()}catch(c){if(ye(a),!(c instanceof H))throw c;xe(1,0)}}function Xm(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function $m(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function qm(r,a,c){var u=_e();try{be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Ym(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function jm(r){var a=_e();try{return be(r)()}catch(c){if(ye(a),!(c instanceof H))throw c;xe(1,0)}}function Zm(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Jm(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Km(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Qm(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function eg(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function tg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function ng(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function ig(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function rg(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function sg(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function ag(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function og(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function lg(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function cg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function hg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function ug(r,a,c,u,p,_,w,A,F){var X=_e();try{be(r)(a,c,u,p,_,w,A,F)}catch(Q){if(ye(X),!(Q instanceof H))throw Q;xe(1,0)}}function dg(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt){var yn=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt)}catch(Nt){if(ye(yn),!(Nt instanceof H))throw Nt;xe(1,0)}}function fg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function pg(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function mg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function gg(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function _g(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function vg(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function yg(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function xg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Sg(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Mg(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function bg(r,a,c,u,p,_,w,A,F){var X=_e();try{be(r)(a,c,u,p,_,w,A,F)}catch(Q){if(ye(X),!(Q instanceof H))throw Q;xe(1,0)}}function wg(r,a,c,u,p,_,w,A,F){var X=_e();try{return be(r)(a,c,u,p,_,w,A,F)}catch(Q){if(ye(X),!(Q instanceof H))throw Q;xe(1,0)}}function Eg(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Tg(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Ag(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Rg(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Cg(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Pg(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Ig(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Dg(r,a,c,u,p,_,w,A){var F=_e();try{return be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Lg(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Fg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function Ng(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,yn){var Nt=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,yn)}catch(rr){if(ye(Nt),!(rr instanceof H))throw rr;xe(1,0)}}function Ug(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Og(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Bg(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function kg(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function zg(r,a,c,u,p,_,w,A,F,X,Q){var oe=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function Gg(r,a,c,u,p,_,w,A){var F=_e();try{return be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Vg(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Hg(r,a,c){var u=_e();try{be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Wg(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Xg(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function $g(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function qg(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Yg(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;return xe(1,0),0n}}function jg(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Zg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Jg(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Kg(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Qg(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function e_(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function t_(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function n_(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function i_(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function r_(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function s_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function a_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,yn,Nt,rr,C_,P_,I_,D_,L_,F_,N_,U_,O_,B_,k_,z_,G_,V_,H_,W_,X_,$_,q_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,R0,C0,P0,I0,D0,L0,F0,N0){var U0=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,yn,Nt,rr,C_,P_,I_,D_,L_,F_,N_,U_,O_,B_,k_,z_,G_,V_,H_,W_,X_,$_,q_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,R0,C0,P0,I0,D0,L0,F0,N0)}catch(pu){if(ye(U0),!(pu instanceof H))throw pu;xe(1,0)}}function o_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce){var me=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce)}catch(Ye){if(ye(me),!(Ye instanceof H))throw Ye;xe(1,0)}}function l_(r,a,c,u,p,_,w,A,F,X,Q){var oe=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function c_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt){var nt=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,at,bt)}catch(qt){if(ye(nt),!(qt instanceof H))throw qt;xe(1,0)}}function h_(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;return xe(1,0),0n}}function u_(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;return xe(1,0),0n}}function d_(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function f_(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function p_(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function m_(r,a,c){var u=_e();try{be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function g_(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function __(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function v_(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function y_(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function x_(r){var a=_e();try{return be(r)()}catch(c){if(ye(a),!(c instanceof H))throw c;return xe(1,0),0n}}function S_(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function M_(r,a,c,u,p,_,w,A,F,X,Q){var oe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function b_(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function w_(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function E_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye){var vt=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye)}catch(at){if(ye(vt),!(at instanceof H))throw at;xe(1,0)}}var fu;function T_(){su(),Se()}function ec(){if(Je>0){L=ec;return}if(T_(),Le(),Je>0){L=ec;return}function r(){G(!fu),fu=!0,t.calledRun=!0,!z&&($t(),Rt?.(t),t.onRuntimeInitialized?.(),Fe("onRuntimeInitialized"),G(!t._main,'compiled without a main, but one is present. if you added it from JS, use Module["onRuntimeInitialized"]'),Ze())}t.setStatus?(t.setStatus("Running..."),setTimeout(()=>{setTimeout(()=>t.setStatus(""),1),r()},1)):r(),re()}function A_(){var r=U,a=I,c=!1;U=I=u=>{c=!0};try{Jl(0),["stdout","stderr"].forEach(u=>{var p=M.analyzePath("/dev/"+u);if(p){var _=p.object,w=_.rdev,A=lt.ttys[w];A?.output?.length&&(c=!0)}})}catch{}U=r,I=a,c&&Qn("stdio streams had content in them that was not flushed. you should set EXIT_RUNTIME to 1 (see the Emscripten FAQ), or make sure to emit a newline when you printf etc.")}function R_(){if(t.preInit)for(typeof t.preInit=="function"&&(t.preInit=[t.preInit]);t.preInit.length>0;)t.preInit.shift()();Fe("preInit")}R_(),ec(),Ct?e=t:e=new Promise((r,a)=>{Rt=r,mt=a});for(let r of Object.keys(t))r in i||Object.defineProperty(i,r,{configurable:!0,get(){pe(`Access to module property ('${r}') is no longer possible via the module constructor argument; Instead, use the result of the module constructor.`)}});return e}),_u=X0;var vu=i=>_u({wasmBinary:i});function $0([i,e,t,n]){return[1-2*(t*t+n*n),2*(e*t-i*n),2*(e*n+i*t),2*(e*t+i*n),1-2*(e*e+n*n),2*(t*n-i*e),2*(e*n-i*t),2*(t*n+i*e),1-2*(e*e+t*t)]}var q0=([i,e,t,n])=>Math.atan2(2*(i*n+e*t),1-2*(t*t+n*n)),Y0=i=>Math.abs(i%1)===.5?2*Math.round(i/2):Math.round(i),hs=class{constructor(e,t,n){this.mujoco=e,this.robot=n,this.model=e.MjModel.from_xml_string(t.xml),t.heights&&this.model.hfield_data.set(t.heights),this.data=new e.MjData(this.model),this.base=e.mj_name2id(this.model,e.mjtObj.mjOBJ_BODY.value,n.base),this.gravity=Math.hypot(...this.model.opt.gravity),this.compiled={mass:this.model.body_mass[this.base],inertia:this.model.body_inertia.slice(3*this.base,3*this.base+3)},this.play=new Float64Array(n.start.length-7),this.reset()}delete(){this.data.delete(),this.model.delete()}reset(e=this.robot.start){let{mujoco:t,model:n,data:s}=this,o=e.slice(7);if(t.mj_resetData(n,s),s.qpos.set(e),s.ctrl.set(o),this.play.set(o),n.nhistory){let{actuator_historyadr:l,actuator_history:h}=n,f=h.length/n.nu;o.forEach((d,m)=>{let y=l[m]+2+h[f*m];l[m]>=0&&s.history.fill(d,y,y+h[f*m])})}t.mj_forward(n,s),this.settled=!0}step(e){let{mujoco:t,model:n,data:s,robot:o}=this;s.ctrl.set(o.servo?this.servoTarget(e):e);for(let l=0;l<o.decimation;l++)this.settled||t.mj_step1(n,s),t.mj_step2(n,s),t.mj_step1(n,s),this.settled=!0}servoTarget(e){let{target_step:t,backlash:n,dead_band:s}=this.robot.servo,o=this.reading("joint_position");return Array.from(e,(l,h)=>{let f=t[h]>0?t[h]*Y0(l/t[h]):l;this.play[h]=Math.min(Math.max(this.play[h],f-n[h]/2),f+n[h]/2);let d=this.play[h]-o[h];return this.play[h]-Math.min(Math.max(d,-s[h]),s[h])})}reading(e){return this.data.sensordata.slice(...this.robot.columns[e])}projectedGravity(){let e=$0(this.reading("orientation")),t=this.model.opt.gravity;return[0,1,2].map(n=>(e[n]*t[0]+e[3+n]*t[1]+e[6+n]*t[2])/this.gravity)}position(){return this.data.qpos.slice(0,3)}yaw(){return q0(this.data.qpos.slice(3,7))}fallen(){return!(this.projectedGravity()[2]<-.5)||this.reading("trunk_force")[0]>0||!Number.isFinite(this.data.qpos[0])}push(e){let{qvel:t}=this.data;e.forEach((n,s)=>{t[s]+=n}),this.settled=!1}setFriction(e){let{geom_friction:t}=this.model;for(let n=0;n<t.length;n+=3)t[n]=e;this.settled=!1}setPayload(e){let{mujoco:t,model:n,base:s,compiled:o}=this,l=o.mass+e;n.body_mass[s]=l,o.inertia.forEach((f,d)=>{n.body_inertia[3*s+d]=f*l/o.mass});let h=new t.MjData(n);t.mj_setConst(n,h),h.delete(),this.settled=!1}setSlope(e){this.model.opt.gravity.set([-this.gravity*Math.sin(e),0,-this.gravity*Math.cos(e)]),this.settled=!1}};var $i={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},qi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Zu=0,Fc=1,Ju=2;var dr=1,Ku=2,jr=3,Yi=0,dn=1,fi=2,fr=0,Zr=1,Nc=2,Uc=3,Oc=4,Qu=5;var pr=100,ed=101,td=102,nd=103,id=104,rd=200,sd=201,ad=202,od=203,Bc=204,kc=205,ld=206,cd=207,hd=208,ud=209,dd=210,fd=211,pd=212,md=213,gd=214,lo=0,co=1,ho=2,Br=3,uo=4,fo=5,po=6,mo=7,zo=0,_d=1,vd=2,pi=0,zc=1,Gc=2,Vc=3,Hc=4,Wc=5,Xc=6,Zs=7;var $c=300,mr=301,Jr=302,Go=303,Vo=304,kr=1e3,oi=1001,go=1002,cn=1003,yd=1004;var Js=1005;var Sn=1006,Ho=1007;var Ci=1008;var Tn=1009,qc=1010,Yc=1011,Kr=1012,Wo=1013,Zn=1014,zn=1015,Jn=1016,Xo=1017,$o=1018,gr=1020,jc=35902,Zc=35899,Jc=1021,Kc=1022,Kn=1023,Ei=1026,Pi=1027,qo=1028,Yo=1029,ji=1030,jo=1031;var Zo=1033,Ks=33776,Qs=33777,ea=33778,ta=33779,Jo=35840,Ko=35841,Qo=35842,el=35843,tl=36196,nl=37492,il=37496,rl=37488,sl=37489,na=37490,al=37491,ol=37808,ll=37809,cl=37810,hl=37811,ul=37812,dl=37813,fl=37814,pl=37815,ml=37816,gl=37817,_l=37818,vl=37819,yl=37820,xl=37821,Sl=36492,Ml=36494,bl=36495,wl=36283,El=36284,ia=36285,Tl=36286;var Ss=2300,_o=2301,ao=2302,Ec=2303,Tc=2400,Ac=2401,Rc=2402;var xd=3200;var ra=0,Sd=1,Ii="",mn="srgb",Ms="srgb-linear",bs="linear",Pt="srgb";var oo=7680;var Md=519,bd=512,wd=513,Ed=514,Qc=515,Td=516,Ad=517,eh=518,th=519,Rd=35044;var nh="300 es",Bn=2e3,zr=2001;function j0(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Z0(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ws(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Cd(){let i=ws("canvas");return i.style.display="block",i}var yu={},Gr=null;function ih(...i){let e="THREE."+i.shift();Gr?Gr("log",e,...i):console.log(e,...i)}function Pd(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Qe(...i){i=Pd(i);let e="THREE."+i.shift();if(Gr)Gr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function it(...i){i=Pd(i);let e="THREE."+i.shift();if(Gr)Gr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function vs(...i){let e=i.join(" ");e in yu||(yu[e]=!0,Qe(...i))}function Id(i,e,t){return new Promise(function(n,s){function o(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(o,t);break;default:n()}}setTimeout(o,t)})}var Dd={[lo]:lo,[ho]:po,[uo]:uo,[Br]:fo,[co]:co,[po]:ho,[mo]:mo,[fo]:Br},jn=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let o=s.indexOf(t);o!==-1&&s.splice(o,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let o=0,l=s.length;o<l;o++)s[o].call(this,e);e.target=null}}},fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],xu=1234567,ys=Math.PI/180,Vr=180/Math.PI;function Qr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(fn[i&255]+fn[i>>8&255]+fn[i>>16&255]+fn[i>>24&255]+"-"+fn[e&255]+fn[e>>8&255]+"-"+fn[e>>16&15|64]+fn[e>>24&255]+"-"+fn[t&63|128]+fn[t>>8&255]+"-"+fn[t>>16&255]+fn[t>>24&255]+fn[n&255]+fn[n>>8&255]+fn[n>>16&255]+fn[n>>24&255]).toLowerCase()}function yt(i,e,t){return Math.max(e,Math.min(t,i))}function rh(i,e){return(i%e+e)%e}function J0(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function K0(i,e,t){return i!==e?(t-i)/(e-i):0}function xs(i,e,t){return(1-t)*i+t*e}function Q0(i,e,t,n){return xs(i,e,1-Math.exp(-t*n))}function ev(i,e=1){return e-Math.abs(rh(i,e*2)-e)}function tv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function nv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function iv(i,e){return i+Math.floor(Math.random()*(e-i+1))}function rv(i,e){return i+Math.random()*(e-i)}function sv(i){return i*(.5-Math.random())}function av(i){i!==void 0&&(xu=i);let e=xu+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function ov(i){return i*ys}function lv(i){return i*Vr}function cv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function hv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function sh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function uv(i,e,t,n,s){let o=Math.cos,l=Math.sin,h=o(t/2),f=l(t/2),d=o((e+n)/2),m=l((e+n)/2),y=o((e-n)/2),g=l((e-n)/2),x=o((n-e)/2),E=l((n-e)/2);switch(s){case"XYX":i.set(h*m,f*y,f*g,h*d);break;case"YZY":i.set(f*g,h*m,f*y,h*d);break;case"ZXZ":i.set(f*y,f*g,h*m,h*d);break;case"XZX":i.set(h*m,f*E,f*x,h*d);break;case"YXY":i.set(f*x,h*m,f*E,h*d);break;case"ZYZ":i.set(f*E,f*x,h*m,h*d);break;default:Qe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ah(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ld(i,e){if(e.constructor===Float32Array)return i;let t=ah(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Fd(i,e){if(e.constructor===Float32Array)return i;let t=ah(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var oh={DEG2RAD:ys,RAD2DEG:Vr,generateUUID:Qr,clamp:yt,euclideanModulo:rh,mapLinear:J0,inverseLerp:K0,lerp:xs,damp:Q0,pingpong:ev,smoothstep:tv,smootherstep:nv,randInt:iv,randFloat:rv,randFloatSpread:sv,seededRandom:av,degToRad:ov,radToDeg:lv,isPowerOfTwo:cv,ceilPowerOfTwo:hv,floorPowerOfTwo:sh,setQuaternionFromProperEuler:uv,normalize:Fd,denormalize:Ld},et=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),o=this.x-e.x,l=this.y-e.y;return this.x=o*n-l*s+e.x,this.y=o*s+l*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Mn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,o,l,h){let f=n[s+0],d=n[s+1],m=n[s+2],y=n[s+3],g=o[l+0],x=o[l+1],E=o[l+2],C=o[l+3];if(y!==C||f!==g||d!==x||m!==E){let S=f*g+d*x+m*E+y*C;S<0&&(g=-g,x=-x,E=-E,C=-C,S=-S);let v=1-h;if(S<.9995){let P=Math.acos(S),U=Math.sin(P);v=Math.sin(v*P)/U,h=Math.sin(h*P)/U,f=f*v+g*h,d=d*v+x*h,m=m*v+E*h,y=y*v+C*h}else{f=f*v+g*h,d=d*v+x*h,m=m*v+E*h,y=y*v+C*h;let P=1/Math.sqrt(f*f+d*d+m*m+y*y);f*=P,d*=P,m*=P,y*=P}}e[t]=f,e[t+1]=d,e[t+2]=m,e[t+3]=y}static multiplyQuaternionsFlat(e,t,n,s,o,l){let h=n[s],f=n[s+1],d=n[s+2],m=n[s+3],y=o[l],g=o[l+1],x=o[l+2],E=o[l+3];return e[t]=h*E+m*y+f*x-d*g,e[t+1]=f*E+m*g+d*y-h*x,e[t+2]=d*E+m*x+h*g-f*y,e[t+3]=m*E-h*y-f*g-d*x,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,o=e._z,l=e._order,h=Math.cos,f=Math.sin,d=h(n/2),m=h(s/2),y=h(o/2),g=f(n/2),x=f(s/2),E=f(o/2);switch(l){case"XYZ":this._x=g*m*y+d*x*E,this._y=d*x*y-g*m*E,this._z=d*m*E+g*x*y,this._w=d*m*y-g*x*E;break;case"YXZ":this._x=g*m*y+d*x*E,this._y=d*x*y-g*m*E,this._z=d*m*E-g*x*y,this._w=d*m*y+g*x*E;break;case"ZXY":this._x=g*m*y-d*x*E,this._y=d*x*y+g*m*E,this._z=d*m*E+g*x*y,this._w=d*m*y-g*x*E;break;case"ZYX":this._x=g*m*y-d*x*E,this._y=d*x*y+g*m*E,this._z=d*m*E-g*x*y,this._w=d*m*y+g*x*E;break;case"YZX":this._x=g*m*y+d*x*E,this._y=d*x*y+g*m*E,this._z=d*m*E-g*x*y,this._w=d*m*y-g*x*E;break;case"XZY":this._x=g*m*y-d*x*E,this._y=d*x*y-g*m*E,this._z=d*m*E+g*x*y,this._w=d*m*y+g*x*E;break;default:Qe("Quaternion: .setFromEuler() encountered an unknown order: "+l)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],o=t[8],l=t[1],h=t[5],f=t[9],d=t[2],m=t[6],y=t[10],g=n+h+y;if(g>0){let x=.5/Math.sqrt(g+1);this._w=.25/x,this._x=(m-f)*x,this._y=(o-d)*x,this._z=(l-s)*x}else if(n>h&&n>y){let x=2*Math.sqrt(1+n-h-y);this._w=(m-f)/x,this._x=.25*x,this._y=(s+l)/x,this._z=(o+d)/x}else if(h>y){let x=2*Math.sqrt(1+h-n-y);this._w=(o-d)/x,this._x=(s+l)/x,this._y=.25*x,this._z=(f+m)/x}else{let x=2*Math.sqrt(1+y-n-h);this._w=(l-s)/x,this._x=(o+d)/x,this._y=(f+m)/x,this._z=.25*x}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,o=e._z,l=e._w,h=t._x,f=t._y,d=t._z,m=t._w;return this._x=n*m+l*h+s*d-o*f,this._y=s*m+l*f+o*h-n*d,this._z=o*m+l*d+n*f-s*h,this._w=l*m-n*h-s*f-o*d,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,o=e._z,l=e._w,h=this.dot(e);h<0&&(n=-n,s=-s,o=-o,l=-l,h=-h);let f=1-t;if(h<.9995){let d=Math.acos(h),m=Math.sin(d);f=Math.sin(f*d)/m,t=Math.sin(t*d)/m,this._x=this._x*f+n*t,this._y=this._y*f+s*t,this._z=this._z*f+o*t,this._w=this._w*f+l*t,this._onChangeCallback()}else this._x=this._x*f+n*t,this._y=this._y*f+s*t,this._z=this._z*f+o*t,this._w=this._w*f+l*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),o=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),o*Math.sin(t),o*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},j=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Su.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Su.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[3]*n+o[6]*s,this.y=o[1]*t+o[4]*n+o[7]*s,this.z=o[2]*t+o[5]*n+o[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,o=e.elements,l=1/(o[3]*t+o[7]*n+o[11]*s+o[15]);return this.x=(o[0]*t+o[4]*n+o[8]*s+o[12])*l,this.y=(o[1]*t+o[5]*n+o[9]*s+o[13])*l,this.z=(o[2]*t+o[6]*n+o[10]*s+o[14])*l,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,o=e.x,l=e.y,h=e.z,f=e.w,d=2*(l*s-h*n),m=2*(h*t-o*s),y=2*(o*n-l*t);return this.x=t+f*d+l*y-h*m,this.y=n+f*m+h*d-o*y,this.z=s+f*y+o*m-l*d,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s,this.y=o[1]*t+o[5]*n+o[9]*s,this.z=o[2]*t+o[6]*n+o[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,o=e.z,l=t.x,h=t.y,f=t.z;return this.x=s*f-o*h,this.y=o*l-n*f,this.z=n*h-s*l,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return ic.copy(this).projectOnVector(e),this.sub(ic)}reflect(e){return this.sub(ic.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ic=new j,Su=new Mn,ct=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,o,l,h,f,d){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,l,h,f,d)}set(e,t,n,s,o,l,h,f,d){let m=this.elements;return m[0]=e,m[1]=s,m[2]=h,m[3]=t,m[4]=o,m[5]=f,m[6]=n,m[7]=l,m[8]=d,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,o=this.elements,l=n[0],h=n[3],f=n[6],d=n[1],m=n[4],y=n[7],g=n[2],x=n[5],E=n[8],C=s[0],S=s[3],v=s[6],P=s[1],U=s[4],I=s[7],O=s[2],N=s[5],b=s[8];return o[0]=l*C+h*P+f*O,o[3]=l*S+h*U+f*N,o[6]=l*v+h*I+f*b,o[1]=d*C+m*P+y*O,o[4]=d*S+m*U+y*N,o[7]=d*v+m*I+y*b,o[2]=g*C+x*P+E*O,o[5]=g*S+x*U+E*N,o[8]=g*v+x*I+E*b,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8];return t*l*m-t*h*d-n*o*m+n*h*f+s*o*d-s*l*f}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8],y=m*l-h*d,g=h*f-m*o,x=d*o-l*f,E=t*y+n*g+s*x;if(E===0)return this.set(0,0,0,0,0,0,0,0,0);let C=1/E;return e[0]=y*C,e[1]=(s*d-m*n)*C,e[2]=(h*n-s*l)*C,e[3]=g*C,e[4]=(m*t-s*f)*C,e[5]=(s*o-h*t)*C,e[6]=x*C,e[7]=(n*f-d*t)*C,e[8]=(l*t-n*o)*C,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,o,l,h){let f=Math.cos(o),d=Math.sin(o);return this.set(n*f,n*d,-n*(f*l+d*h)+l+e,-s*d,s*f,-s*(-d*l+f*h)+h+t,0,0,1),this}scale(e,t){return vs("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(rc.makeScale(e,t)),this}rotate(e){return vs("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(rc.makeRotation(-e)),this}translate(e,t){return vs("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(rc.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},rc=new ct,Mu=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),bu=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function dv(){let i={enabled:!0,workingColorSpace:Ms,spaces:{},convert:function(s,o,l){return this.enabled===!1||o===l||!o||!l||(this.spaces[o].transfer===Pt&&(s.r=wi(s.r),s.g=wi(s.g),s.b=wi(s.b)),this.spaces[o].primaries!==this.spaces[l].primaries&&(s.applyMatrix3(this.spaces[o].toXYZ),s.applyMatrix3(this.spaces[l].fromXYZ)),this.spaces[l].transfer===Pt&&(s.r=Or(s.r),s.g=Or(s.g),s.b=Or(s.b))),s},workingToColorSpace:function(s,o){return this.convert(s,this.workingColorSpace,o)},colorSpaceToWorking:function(s,o){return this.convert(s,o,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ii?bs:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,o=this.workingColorSpace){return s.fromArray(this.spaces[o].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,o,l){return s.copy(this.spaces[l].fromXYZ).multiply(this.spaces[o].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ms]:{primaries:e,whitePoint:n,transfer:bs,toXYZ:Mu,fromXYZ:bu,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:mn},outputColorSpaceConfig:{drawingBufferColorSpace:mn}},[mn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:Mu,fromXYZ:bu,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:mn}}}),i}var St=dv();function wi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Or(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var br,vo=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{br===void 0&&(br=ws("canvas")),br.width=e.width,br.height=e.height;let s=br.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=br}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ws("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),o=s.data;for(let l=0;l<o.length;l++)o[l]=wi(o[l]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(wi(t[n]/255)*255):t[n]=wi(t[n]);return{data:t,width:e.width,height:e.height}}else return Qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},fv=0,Hr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:fv++}),this.uuid=Qr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let o;if(Array.isArray(s)){o=[];for(let l=0,h=s.length;l<h;l++)s[l].isDataTexture?o.push(sc(s[l].image)):o.push(sc(s[l]))}else o=sc(s);n.url=o}return t||(e.images[this.uuid]=n),n}};function sc(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?vo.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Qe("Texture: Unable to serialize Texture."),{})}var pv=0,ac=new j,bn=class i extends jn{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=oi,s=oi,o=Sn,l=Ci,h=Kn,f=Tn,d=i.DEFAULT_ANISOTROPY,m=Ii){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:pv++}),this.uuid=Qr(),this.name="",this.source=new Hr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=o,this.minFilter=l,this.anisotropy=d,this.format=h,this.internalFormat=null,this.type=f,this.offset=new et(0,0),this.repeat=new et(1,1),this.center=new et(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=m,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ac).x}get height(){return this.source.getSize(ac).y}get depth(){return this.source.getSize(ac).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Qe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==$c)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case kr:e.x=e.x-Math.floor(e.x);break;case oi:e.x=e.x<0?0:1;break;case go:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case kr:e.y=e.y-Math.floor(e.y);break;case oi:e.y=e.y<0?0:1;break;case go:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};bn.DEFAULT_IMAGE=null;bn.DEFAULT_MAPPING=$c;bn.DEFAULT_ANISOTROPY=1;var Gt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,o=this.w,l=e.elements;return this.x=l[0]*t+l[4]*n+l[8]*s+l[12]*o,this.y=l[1]*t+l[5]*n+l[9]*s+l[13]*o,this.z=l[2]*t+l[6]*n+l[10]*s+l[14]*o,this.w=l[3]*t+l[7]*n+l[11]*s+l[15]*o,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,o,f=e.elements,d=f[0],m=f[4],y=f[8],g=f[1],x=f[5],E=f[9],C=f[2],S=f[6],v=f[10];if(Math.abs(m-g)<.01&&Math.abs(y-C)<.01&&Math.abs(E-S)<.01){if(Math.abs(m+g)<.1&&Math.abs(y+C)<.1&&Math.abs(E+S)<.1&&Math.abs(d+x+v-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let U=(d+1)/2,I=(x+1)/2,O=(v+1)/2,N=(m+g)/4,b=(y+C)/4,D=(E+S)/4;return U>I&&U>O?U<.01?(n=0,s=.707106781,o=.707106781):(n=Math.sqrt(U),s=N/n,o=b/n):I>O?I<.01?(n=.707106781,s=0,o=.707106781):(s=Math.sqrt(I),n=N/s,o=D/s):O<.01?(n=.707106781,s=.707106781,o=0):(o=Math.sqrt(O),n=b/o,s=D/o),this.set(n,s,o,t),this}let P=Math.sqrt((S-E)*(S-E)+(y-C)*(y-C)+(g-m)*(g-m));return Math.abs(P)<.001&&(P=1),this.x=(S-E)/P,this.y=(y-C)/P,this.z=(g-m)/P,this.w=Math.acos((d+x+v-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},yo=class extends jn{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Sn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t),this.textures=[];let s=n.count;for(let o=0;o<s;o++)this.textures[o]=new bn({width:e,height:t,depth:n.depth}),this.textures[o].isRenderTargetTexture=!0,this.textures[o].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Sn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,o=this.textures.length;s<o;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Hr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Dn=class extends yo{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Es=class extends bn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=oi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var xo=class extends bn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=oi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Lt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,o,l,h,f,d,m,y,g,x,E,C,S){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,l,h,f,d,m,y,g,x,E,C,S)}set(e,t,n,s,o,l,h,f,d,m,y,g,x,E,C,S){let v=this.elements;return v[0]=e,v[4]=t,v[8]=n,v[12]=s,v[1]=o,v[5]=l,v[9]=h,v[13]=f,v[2]=d,v[6]=m,v[10]=y,v[14]=g,v[3]=x,v[7]=E,v[11]=C,v[15]=S,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/wr.setFromMatrixColumn(e,0).length(),o=1/wr.setFromMatrixColumn(e,1).length(),l=1/wr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*o,t[5]=n[5]*o,t[6]=n[6]*o,t[7]=0,t[8]=n[8]*l,t[9]=n[9]*l,t[10]=n[10]*l,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,o=e.z,l=Math.cos(n),h=Math.sin(n),f=Math.cos(s),d=Math.sin(s),m=Math.cos(o),y=Math.sin(o);if(e.order==="XYZ"){let g=l*m,x=l*y,E=h*m,C=h*y;t[0]=f*m,t[4]=-f*y,t[8]=d,t[1]=x+E*d,t[5]=g-C*d,t[9]=-h*f,t[2]=C-g*d,t[6]=E+x*d,t[10]=l*f}else if(e.order==="YXZ"){let g=f*m,x=f*y,E=d*m,C=d*y;t[0]=g+C*h,t[4]=E*h-x,t[8]=l*d,t[1]=l*y,t[5]=l*m,t[9]=-h,t[2]=x*h-E,t[6]=C+g*h,t[10]=l*f}else if(e.order==="ZXY"){let g=f*m,x=f*y,E=d*m,C=d*y;t[0]=g-C*h,t[4]=-l*y,t[8]=E+x*h,t[1]=x+E*h,t[5]=l*m,t[9]=C-g*h,t[2]=-l*d,t[6]=h,t[10]=l*f}else if(e.order==="ZYX"){let g=l*m,x=l*y,E=h*m,C=h*y;t[0]=f*m,t[4]=E*d-x,t[8]=g*d+C,t[1]=f*y,t[5]=C*d+g,t[9]=x*d-E,t[2]=-d,t[6]=h*f,t[10]=l*f}else if(e.order==="YZX"){let g=l*f,x=l*d,E=h*f,C=h*d;t[0]=f*m,t[4]=C-g*y,t[8]=E*y+x,t[1]=y,t[5]=l*m,t[9]=-h*m,t[2]=-d*m,t[6]=x*y+E,t[10]=g-C*y}else if(e.order==="XZY"){let g=l*f,x=l*d,E=h*f,C=h*d;t[0]=f*m,t[4]=-y,t[8]=d*m,t[1]=g*y+C,t[5]=l*m,t[9]=x*y-E,t[2]=E*y-x,t[6]=h*m,t[10]=C*y+g}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(mv,e,gv)}lookAt(e,t,n){let s=this.elements;return Cn.subVectors(e,t),Cn.lengthSq()===0&&(Cn.z=1),Cn.normalize(),Fi.crossVectors(n,Cn),Fi.lengthSq()===0&&(Math.abs(n.z)===1?Cn.x+=1e-4:Cn.z+=1e-4,Cn.normalize(),Fi.crossVectors(n,Cn)),Fi.normalize(),Ua.crossVectors(Cn,Fi),s[0]=Fi.x,s[4]=Ua.x,s[8]=Cn.x,s[1]=Fi.y,s[5]=Ua.y,s[9]=Cn.y,s[2]=Fi.z,s[6]=Ua.z,s[10]=Cn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,o=this.elements,l=n[0],h=n[4],f=n[8],d=n[12],m=n[1],y=n[5],g=n[9],x=n[13],E=n[2],C=n[6],S=n[10],v=n[14],P=n[3],U=n[7],I=n[11],O=n[15],N=s[0],b=s[4],D=s[8],q=s[12],k=s[1],Y=s[5],J=s[9],ee=s[13],z=s[2],ie=s[6],G=s[10],ne=s[14],Se=s[3],re=s[7],H=s[11],ge=s[15];return o[0]=l*N+h*k+f*z+d*Se,o[4]=l*b+h*Y+f*ie+d*re,o[8]=l*D+h*J+f*G+d*H,o[12]=l*q+h*ee+f*ne+d*ge,o[1]=m*N+y*k+g*z+x*Se,o[5]=m*b+y*Y+g*ie+x*re,o[9]=m*D+y*J+g*G+x*H,o[13]=m*q+y*ee+g*ne+x*ge,o[2]=E*N+C*k+S*z+v*Se,o[6]=E*b+C*Y+S*ie+v*re,o[10]=E*D+C*J+S*G+v*H,o[14]=E*q+C*ee+S*ne+v*ge,o[3]=P*N+U*k+I*z+O*Se,o[7]=P*b+U*Y+I*ie+O*re,o[11]=P*D+U*J+I*G+O*H,o[15]=P*q+U*ee+I*ne+O*ge,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],o=e[12],l=e[1],h=e[5],f=e[9],d=e[13],m=e[2],y=e[6],g=e[10],x=e[14],E=e[3],C=e[7],S=e[11],v=e[15],P=f*x-d*g,U=h*x-d*y,I=h*g-f*y,O=l*x-d*m,N=l*g-f*m,b=l*y-h*m;return t*(C*P-S*U+v*I)-n*(E*P-S*O+v*N)+s*(E*U-C*O+v*b)-o*(E*I-C*N+S*b)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],o=e[1],l=e[5],h=e[9],f=e[2],d=e[6],m=e[10];return t*(l*m-h*d)-n*(o*m-h*f)+s*(o*d-l*f)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8],y=e[9],g=e[10],x=e[11],E=e[12],C=e[13],S=e[14],v=e[15],P=t*h-n*l,U=t*f-s*l,I=t*d-o*l,O=n*f-s*h,N=n*d-o*h,b=s*d-o*f,D=m*C-y*E,q=m*S-g*E,k=m*v-x*E,Y=y*S-g*C,J=y*v-x*C,ee=g*v-x*S,z=P*ee-U*J+I*Y+O*k-N*q+b*D;if(z===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let ie=1/z;return e[0]=(h*ee-f*J+d*Y)*ie,e[1]=(s*J-n*ee-o*Y)*ie,e[2]=(C*b-S*N+v*O)*ie,e[3]=(g*N-y*b-x*O)*ie,e[4]=(f*k-l*ee-d*q)*ie,e[5]=(t*ee-s*k+o*q)*ie,e[6]=(S*I-E*b-v*U)*ie,e[7]=(m*b-g*I+x*U)*ie,e[8]=(l*J-h*k+d*D)*ie,e[9]=(n*k-t*J-o*D)*ie,e[10]=(E*N-C*I+v*P)*ie,e[11]=(y*I-m*N-x*P)*ie,e[12]=(h*q-l*Y-f*D)*ie,e[13]=(t*Y-n*q+s*D)*ie,e[14]=(C*U-E*O-S*P)*ie,e[15]=(m*O-y*U+g*P)*ie,this}scale(e){let t=this.elements,n=e.x,s=e.y,o=e.z;return t[0]*=n,t[4]*=s,t[8]*=o,t[1]*=n,t[5]*=s,t[9]*=o,t[2]*=n,t[6]*=s,t[10]*=o,t[3]*=n,t[7]*=s,t[11]*=o,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),o=1-n,l=e.x,h=e.y,f=e.z,d=o*l,m=o*h;return this.set(d*l+n,d*h-s*f,d*f+s*h,0,d*h+s*f,m*h+n,m*f-s*l,0,d*f-s*h,m*f+s*l,o*f*f+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,o,l){return this.set(1,n,o,0,e,1,l,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,o=t._x,l=t._y,h=t._z,f=t._w,d=o+o,m=l+l,y=h+h,g=o*d,x=o*m,E=o*y,C=l*m,S=l*y,v=h*y,P=f*d,U=f*m,I=f*y,O=n.x,N=n.y,b=n.z;return s[0]=(1-(C+v))*O,s[1]=(x+I)*O,s[2]=(E-U)*O,s[3]=0,s[4]=(x-I)*N,s[5]=(1-(g+v))*N,s[6]=(S+P)*N,s[7]=0,s[8]=(E+U)*b,s[9]=(S-P)*b,s[10]=(1-(g+C))*b,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let o=this.determinantAffine();if(o===0)return n.set(1,1,1),t.identity(),this;let l=wr.set(s[0],s[1],s[2]).length(),h=wr.set(s[4],s[5],s[6]).length(),f=wr.set(s[8],s[9],s[10]).length();o<0&&(l=-l),$n.copy(this);let d=1/l,m=1/h,y=1/f;return $n.elements[0]*=d,$n.elements[1]*=d,$n.elements[2]*=d,$n.elements[4]*=m,$n.elements[5]*=m,$n.elements[6]*=m,$n.elements[8]*=y,$n.elements[9]*=y,$n.elements[10]*=y,t.setFromRotationMatrix($n),n.x=l,n.y=h,n.z=f,this}makePerspective(e,t,n,s,o,l,h=Bn,f=!1){let d=this.elements,m=2*o/(t-e),y=2*o/(n-s),g=(t+e)/(t-e),x=(n+s)/(n-s),E,C;if(f)E=o/(l-o),C=l*o/(l-o);else if(h===Bn)E=-(l+o)/(l-o),C=-2*l*o/(l-o);else if(h===zr)E=-l/(l-o),C=-l*o/(l-o);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+h);return d[0]=m,d[4]=0,d[8]=g,d[12]=0,d[1]=0,d[5]=y,d[9]=x,d[13]=0,d[2]=0,d[6]=0,d[10]=E,d[14]=C,d[3]=0,d[7]=0,d[11]=-1,d[15]=0,this}makeOrthographic(e,t,n,s,o,l,h=Bn,f=!1){let d=this.elements,m=2/(t-e),y=2/(n-s),g=-(t+e)/(t-e),x=-(n+s)/(n-s),E,C;if(f)E=1/(l-o),C=l/(l-o);else if(h===Bn)E=-2/(l-o),C=-(l+o)/(l-o);else if(h===zr)E=-1/(l-o),C=-o/(l-o);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+h);return d[0]=m,d[4]=0,d[8]=0,d[12]=g,d[1]=0,d[5]=y,d[9]=0,d[13]=x,d[2]=0,d[6]=0,d[10]=E,d[14]=C,d[3]=0,d[7]=0,d[11]=0,d[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},wr=new j,$n=new Lt,mv=new j(0,0,0),gv=new j(1,1,1),Fi=new j,Ua=new j,Cn=new j,wu=new Lt,Eu=new Mn,li=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,o=s[0],l=s[4],h=s[8],f=s[1],d=s[5],m=s[9],y=s[2],g=s[6],x=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(-m,x),this._z=Math.atan2(-l,o)):(this._x=Math.atan2(g,d),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(m,-1,1)),Math.abs(m)<.9999999?(this._y=Math.atan2(h,x),this._z=Math.atan2(f,d)):(this._y=Math.atan2(-y,o),this._z=0);break;case"ZXY":this._x=Math.asin(yt(g,-1,1)),Math.abs(g)<.9999999?(this._y=Math.atan2(-y,x),this._z=Math.atan2(-l,d)):(this._y=0,this._z=Math.atan2(f,o));break;case"ZYX":this._y=Math.asin(-yt(y,-1,1)),Math.abs(y)<.9999999?(this._x=Math.atan2(g,x),this._z=Math.atan2(f,o)):(this._x=0,this._z=Math.atan2(-l,d));break;case"YZX":this._z=Math.asin(yt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(-m,d),this._y=Math.atan2(-y,o)):(this._x=0,this._y=Math.atan2(h,x));break;case"XZY":this._z=Math.asin(-yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(g,d),this._y=Math.atan2(h,o)):(this._x=Math.atan2(-m,x),this._y=0);break;default:Qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return wu.makeRotationFromQuaternion(e),this.setFromRotationMatrix(wu,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Eu.setFromEuler(this),this.setFromQuaternion(Eu,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};li.DEFAULT_ORDER="XYZ";var Wr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},_v=0,Tu=new j,Er=new Mn,yi=new Lt,Oa=new j,us=new j,vv=new j,yv=new Mn,Au=new j(1,0,0),Ru=new j(0,1,0),Cu=new j(0,0,1),Pu={type:"added"},xv={type:"removed"},Tr={type:"childadded",child:null},oc={type:"childremoved",child:null},Qt=class i extends jn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:_v++}),this.uuid=Qr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new j,t=new li,n=new Mn,s=new j(1,1,1);function o(){n.setFromEuler(t,!1)}function l(){t.setFromQuaternion(n,void 0,!1)}t._onChange(o),n._onChange(l),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Lt},normalMatrix:{value:new ct}}),this.matrix=new Lt,this.matrixWorld=new Lt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Wr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Er.setFromAxisAngle(e,t),this.quaternion.multiply(Er),this}rotateOnWorldAxis(e,t){return Er.setFromAxisAngle(e,t),this.quaternion.premultiply(Er),this}rotateX(e){return this.rotateOnAxis(Au,e)}rotateY(e){return this.rotateOnAxis(Ru,e)}rotateZ(e){return this.rotateOnAxis(Cu,e)}translateOnAxis(e,t){return Tu.copy(e).applyQuaternion(this.quaternion),this.position.add(Tu.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Au,e)}translateY(e){return this.translateOnAxis(Ru,e)}translateZ(e){return this.translateOnAxis(Cu,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(yi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Oa.copy(e):Oa.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),us.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?yi.lookAt(us,Oa,this.up):yi.lookAt(Oa,us,this.up),this.quaternion.setFromRotationMatrix(yi),s&&(yi.extractRotation(s.matrixWorld),Er.setFromRotationMatrix(yi),this.quaternion.premultiply(Er.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Pu),Tr.child=e,this.dispatchEvent(Tr),Tr.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(xv),oc.child=e,this.dispatchEvent(oc),oc.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),yi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),yi.multiply(e.parent.matrixWorld)),e.applyMatrix4(yi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Pu),Tr.child=e,this.dispatchEvent(Tr),Tr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let l=this.children[n].getObjectByProperty(e,t);if(l!==void 0)return l}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let o=0,l=s.length;o<l;o++)s[o].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(us,e,vv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(us,yv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,o=this.matrix.elements;o[12]+=t-o[0]*t-o[4]*n-o[8]*s,o[13]+=n-o[1]*t-o[5]*n-o[9]*s,o[14]+=s-o[2]*t-o[6]*n-o[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let o=this.children;for(let l=0,h=o.length;l<h;l++)o[l].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(h=>({...h,boundingBox:h.boundingBox?h.boundingBox.toJSON():void 0,boundingSphere:h.boundingSphere?h.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(h=>({...h})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function o(h,f){return h[f.uuid]===void 0&&(h[f.uuid]=f.toJSON(e)),f.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=o(e.geometries,this.geometry);let h=this.geometry.parameters;if(h!==void 0&&h.shapes!==void 0){let f=h.shapes;if(Array.isArray(f))for(let d=0,m=f.length;d<m;d++){let y=f[d];o(e.shapes,y)}else o(e.shapes,f)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(o(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let h=[];for(let f=0,d=this.material.length;f<d;f++)h.push(o(e.materials,this.material[f]));s.material=h}else s.material=o(e.materials,this.material);if(this.children.length>0){s.children=[];for(let h=0;h<this.children.length;h++)s.children.push(this.children[h].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let h=0;h<this.animations.length;h++){let f=this.animations[h];s.animations.push(o(e.animations,f))}}if(t){let h=l(e.geometries),f=l(e.materials),d=l(e.textures),m=l(e.images),y=l(e.shapes),g=l(e.skeletons),x=l(e.animations),E=l(e.nodes);h.length>0&&(n.geometries=h),f.length>0&&(n.materials=f),d.length>0&&(n.textures=d),m.length>0&&(n.images=m),y.length>0&&(n.shapes=y),g.length>0&&(n.skeletons=g),x.length>0&&(n.animations=x),E.length>0&&(n.nodes=E)}return n.object=s,n;function l(h){let f=[];for(let d in h){let m=h[d];delete m.metadata,f.push(m)}return f}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Qt.DEFAULT_UP=new j(0,1,0);Qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Qt{constructor(){super(),this.isGroup=!0,this.type="Group"}},Sv={type:"move"},Xr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new j,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new j),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new j,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new j,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,o=null,l=null,h=this._targetRay,f=this._grip,d=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(d&&e.hand){l=!0;for(let C of e.hand.values()){let S=t.getJointPose(C,n),v=this._getHandJoint(d,C);S!==null&&(v.matrix.fromArray(S.transform.matrix),v.matrix.decompose(v.position,v.quaternion,v.scale),v.matrixWorldNeedsUpdate=!0,v.jointRadius=S.radius),v.visible=S!==null}let m=d.joints["index-finger-tip"],y=d.joints["thumb-tip"],g=m.position.distanceTo(y.position),x=.02,E=.005;d.inputState.pinching&&g>x+E?(d.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!d.inputState.pinching&&g<=x-E&&(d.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else f!==null&&e.gripSpace&&(o=t.getPose(e.gripSpace,n),o!==null&&(f.matrix.fromArray(o.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,o.linearVelocity?(f.hasLinearVelocity=!0,f.linearVelocity.copy(o.linearVelocity)):f.hasLinearVelocity=!1,o.angularVelocity?(f.hasAngularVelocity=!0,f.angularVelocity.copy(o.angularVelocity)):f.hasAngularVelocity=!1,f.eventsEnabled&&f.dispatchEvent({type:"gripUpdated",data:e,target:this})));h!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&o!==null&&(s=o),s!==null&&(h.matrix.fromArray(s.transform.matrix),h.matrix.decompose(h.position,h.quaternion,h.scale),h.matrixWorldNeedsUpdate=!0,s.linearVelocity?(h.hasLinearVelocity=!0,h.linearVelocity.copy(s.linearVelocity)):h.hasLinearVelocity=!1,s.angularVelocity?(h.hasAngularVelocity=!0,h.angularVelocity.copy(s.angularVelocity)):h.hasAngularVelocity=!1,this.dispatchEvent(Sv)))}return h!==null&&(h.visible=s!==null),f!==null&&(f.visible=o!==null),d!==null&&(d.visible=l!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new kn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Nd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ni={h:0,s:0,l:0},Ba={h:0,s:0,l:0};function lc(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ht=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=mn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=St.workingColorSpace){if(e=rh(e,1),t=yt(t,0,1),n=yt(n,0,1),t===0)this.r=this.g=this.b=n;else{let o=n<=.5?n*(1+t):n+t-n*t,l=2*n-o;this.r=lc(l,o,e+1/3),this.g=lc(l,o,e),this.b=lc(l,o,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=mn){function n(o){o!==void 0&&parseFloat(o)<1&&Qe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let o,l=s[1],h=s[2];switch(l){case"rgb":case"rgba":if(o=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setRGB(Math.min(255,parseInt(o[1],10))/255,Math.min(255,parseInt(o[2],10))/255,Math.min(255,parseInt(o[3],10))/255,t);if(o=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setRGB(Math.min(100,parseFloat(o[1]))/100,Math.min(100,parseFloat(o[2]))/100,Math.min(100,parseFloat(o[3]))/100,t);break;case"hsl":case"hsla":if(o=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setHSL(parseFloat(o[1])/360,parseFloat(o[2])/100,parseFloat(o[3])/100,t);break;default:Qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let o=s[1],l=o.length;if(l===3)return this.setRGB(parseInt(o.charAt(0),16)/15,parseInt(o.charAt(1),16)/15,parseInt(o.charAt(2),16)/15,t);if(l===6)return this.setHex(parseInt(o,16),t);Qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=mn){let n=Nd[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=wi(e.r),this.g=wi(e.g),this.b=wi(e.b),this}copyLinearToSRGB(e){return this.r=Or(e.r),this.g=Or(e.g),this.b=Or(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=mn){return St.workingToColorSpace(pn.copy(this),e),Math.round(yt(pn.r*255,0,255))*65536+Math.round(yt(pn.g*255,0,255))*256+Math.round(yt(pn.b*255,0,255))}getHexString(e=mn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(pn.copy(this),t);let n=pn.r,s=pn.g,o=pn.b,l=Math.max(n,s,o),h=Math.min(n,s,o),f,d,m=(h+l)/2;if(h===l)f=0,d=0;else{let y=l-h;switch(d=m<=.5?y/(l+h):y/(2-l-h),l){case n:f=(s-o)/y+(s<o?6:0);break;case s:f=(o-n)/y+2;break;case o:f=(n-s)/y+4;break}f/=6}return e.h=f,e.s=d,e.l=m,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(pn.copy(this),t),e.r=pn.r,e.g=pn.g,e.b=pn.b,e}getStyle(e=mn){St.workingToColorSpace(pn.copy(this),e);let t=pn.r,n=pn.g,s=pn.b;return e!==mn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ni),this.setHSL(Ni.h+e,Ni.s+t,Ni.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ni),e.getHSL(Ba);let n=xs(Ni.h,Ba.h,t),s=xs(Ni.s,Ba.s,t),o=xs(Ni.l,Ba.l,t);return this.setHSL(n,s,o),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,o=e.elements;return this.r=o[0]*t+o[3]*n+o[6]*s,this.g=o[1]*t+o[4]*n+o[7]*s,this.b=o[2]*t+o[5]*n+o[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},pn=new ht;ht.NAMES=Nd;var Ts=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ht(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},hr=class extends Qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new li,this.environmentIntensity=1,this.environmentRotation=new li,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},qn=new j,xi=new j,cc=new j,Si=new j,Ar=new j,Rr=new j,Iu=new j,hc=new j,uc=new j,dc=new j,fc=new Gt,pc=new Gt,mc=new Gt,ki=class i{constructor(e=new j,t=new j,n=new j){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),qn.subVectors(e,t),s.cross(qn);let o=s.lengthSq();return o>0?s.multiplyScalar(1/Math.sqrt(o)):s.set(0,0,0)}static getBarycoord(e,t,n,s,o){qn.subVectors(s,t),xi.subVectors(n,t),cc.subVectors(e,t);let l=qn.dot(qn),h=qn.dot(xi),f=qn.dot(cc),d=xi.dot(xi),m=xi.dot(cc),y=l*d-h*h;if(y===0)return o.set(0,0,0),null;let g=1/y,x=(d*f-h*m)*g,E=(l*m-h*f)*g;return o.set(1-x-E,E,x)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Si)===null?!1:Si.x>=0&&Si.y>=0&&Si.x+Si.y<=1}static getInterpolation(e,t,n,s,o,l,h,f){return this.getBarycoord(e,t,n,s,Si)===null?(f.x=0,f.y=0,"z"in f&&(f.z=0),"w"in f&&(f.w=0),null):(f.setScalar(0),f.addScaledVector(o,Si.x),f.addScaledVector(l,Si.y),f.addScaledVector(h,Si.z),f)}static getInterpolatedAttribute(e,t,n,s,o,l){return fc.setScalar(0),pc.setScalar(0),mc.setScalar(0),fc.fromBufferAttribute(e,t),pc.fromBufferAttribute(e,n),mc.fromBufferAttribute(e,s),l.setScalar(0),l.addScaledVector(fc,o.x),l.addScaledVector(pc,o.y),l.addScaledVector(mc,o.z),l}static isFrontFacing(e,t,n,s){return qn.subVectors(n,t),xi.subVectors(e,t),qn.cross(xi).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return qn.subVectors(this.c,this.b),xi.subVectors(this.a,this.b),qn.cross(xi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,o){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,o)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,o=this.c,l,h;Ar.subVectors(s,n),Rr.subVectors(o,n),hc.subVectors(e,n);let f=Ar.dot(hc),d=Rr.dot(hc);if(f<=0&&d<=0)return t.copy(n);uc.subVectors(e,s);let m=Ar.dot(uc),y=Rr.dot(uc);if(m>=0&&y<=m)return t.copy(s);let g=f*y-m*d;if(g<=0&&f>=0&&m<=0&&f-m>0)return l=f/(f-m),t.copy(n).addScaledVector(Ar,l);dc.subVectors(e,o);let x=Ar.dot(dc),E=Rr.dot(dc);if(E>=0&&x<=E)return t.copy(o);let C=x*d-f*E;if(C<=0&&d>=0&&E<=0)return h=d/(d-E),t.copy(n).addScaledVector(Rr,h);let S=m*E-x*y;if(S<=0&&y-m>=0&&x-E>=0)return Iu.subVectors(o,s),h=(y-m)/(y-m+(x-E)),t.copy(s).addScaledVector(Iu,h);let v=1/(S+C+g);return l=C*v,h=g*v,t.copy(n).addScaledVector(Ar,l).addScaledVector(Rr,h)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ci=class{constructor(e=new j(1/0,1/0,1/0),t=new j(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Yn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Yn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Yn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let o=n.getAttribute("position");if(t===!0&&o!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let l=0,h=o.count;l<h;l++)e.isMesh===!0?e.getVertexPosition(l,Yn):Yn.fromBufferAttribute(o,l),Yn.applyMatrix4(e.matrixWorld),this.expandByPoint(Yn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ka.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),ka.copy(n.boundingBox)),ka.applyMatrix4(e.matrixWorld),this.union(ka)}let s=e.children;for(let o=0,l=s.length;o<l;o++)this.expandByObject(s[o],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Yn),Yn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ds),za.subVectors(this.max,ds),Cr.subVectors(e.a,ds),Pr.subVectors(e.b,ds),Ir.subVectors(e.c,ds),Ui.subVectors(Pr,Cr),Oi.subVectors(Ir,Pr),ar.subVectors(Cr,Ir);let t=[0,-Ui.z,Ui.y,0,-Oi.z,Oi.y,0,-ar.z,ar.y,Ui.z,0,-Ui.x,Oi.z,0,-Oi.x,ar.z,0,-ar.x,-Ui.y,Ui.x,0,-Oi.y,Oi.x,0,-ar.y,ar.x,0];return!gc(t,Cr,Pr,Ir,za)||(t=[1,0,0,0,1,0,0,0,1],!gc(t,Cr,Pr,Ir,za))?!1:(Ga.crossVectors(Ui,Oi),t=[Ga.x,Ga.y,Ga.z],gc(t,Cr,Pr,Ir,za))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Yn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Yn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Mi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Mi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Mi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Mi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Mi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Mi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Mi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Mi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Mi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Mi=[new j,new j,new j,new j,new j,new j,new j,new j],Yn=new j,ka=new ci,Cr=new j,Pr=new j,Ir=new j,Ui=new j,Oi=new j,ar=new j,ds=new j,za=new j,Ga=new j,or=new j;function gc(i,e,t,n,s){for(let o=0,l=i.length-3;o<=l;o+=3){or.fromArray(i,o);let h=s.x*Math.abs(or.x)+s.y*Math.abs(or.y)+s.z*Math.abs(or.z),f=e.dot(or),d=t.dot(or),m=n.dot(or);if(Math.max(-Math.max(f,d,m),Math.min(f,d,m))>h)return!1}return!0}var Yt=new j,Va=new et,Mv=0,En=class extends jn{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Mv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Rd,this.updateRanges=[],this.gpuType=zn,this.version=0,this._normalizationScale=e!==void 0?ah(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,o=this.itemSize;s<o;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Va.fromBufferAttribute(this,t),Va.applyMatrix3(e),this.setXY(t,Va.x,Va.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix3(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix4(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyNormalMatrix(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.transformDirection(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,o){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),o=this._normalize(o)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=o,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ld(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Fd(e,this.array)}};var As=class extends En{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Rs=class extends En{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Xt=class extends En{constructor(e,t,n){super(new Float32Array(e),t,n)}},bv=new ci,fs=new j,_c=new j,Ti=class{constructor(e=new j,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):bv.setFromPoints(e).getCenter(n);let s=0;for(let o=0,l=e.length;o<l;o++)s=Math.max(s,n.distanceToSquared(e[o]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;fs.subVectors(e,this.center);let t=fs.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(fs,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(_c.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(fs.copy(e.center).add(_c)),this.expandByPoint(fs.copy(e.center).sub(_c))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},wv=0,On=new Lt,vc=new Qt,Dr=new j,Pn=new ci,ps=new ci,ln=new j,wn=class i extends jn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:wv++}),this.uuid=Qr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(j0(e)?Rs:As)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let o=new ct().getNormalMatrix(e);n.applyNormalMatrix(o),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return On.makeRotationFromQuaternion(e),this.applyMatrix4(On),this}rotateX(e){return On.makeRotationX(e),this.applyMatrix4(On),this}rotateY(e){return On.makeRotationY(e),this.applyMatrix4(On),this}rotateZ(e){return On.makeRotationZ(e),this.applyMatrix4(On),this}translate(e,t,n){return On.makeTranslation(e,t,n),this.applyMatrix4(On),this}scale(e,t,n){return On.makeScale(e,t,n),this.applyMatrix4(On),this}lookAt(e){return vc.lookAt(e),vc.updateMatrix(),this.applyMatrix4(vc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Dr).negate(),this.translate(Dr.x,Dr.y,Dr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,o=e.length;s<o;s++){let l=e[s];n.push(l.x,l.y,l.z||0)}this.setAttribute("position",new Xt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let o=e[s];t.setXYZ(s,o.x,o.y,o.z||0)}e.length>t.count&&Qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ci);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new j(-1/0,-1/0,-1/0),new j(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let o=t[n];Pn.setFromBufferAttribute(o),this.morphTargetsRelative?(ln.addVectors(this.boundingBox.min,Pn.min),this.boundingBox.expandByPoint(ln),ln.addVectors(this.boundingBox.max,Pn.max),this.boundingBox.expandByPoint(ln)):(this.boundingBox.expandByPoint(Pn.min),this.boundingBox.expandByPoint(Pn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ti);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new j,1/0);return}if(e){let n=this.boundingSphere.center;if(Pn.setFromBufferAttribute(e),t)for(let o=0,l=t.length;o<l;o++){let h=t[o];ps.setFromBufferAttribute(h),this.morphTargetsRelative?(ln.addVectors(Pn.min,ps.min),Pn.expandByPoint(ln),ln.addVectors(Pn.max,ps.max),Pn.expandByPoint(ln)):(Pn.expandByPoint(ps.min),Pn.expandByPoint(ps.max))}Pn.getCenter(n);let s=0;for(let o=0,l=e.count;o<l;o++)ln.fromBufferAttribute(e,o),s=Math.max(s,n.distanceToSquared(ln));if(t)for(let o=0,l=t.length;o<l;o++){let h=t[o],f=this.morphTargetsRelative;for(let d=0,m=h.count;d<m;d++)ln.fromBufferAttribute(h,d),f&&(Dr.fromBufferAttribute(e,d),ln.add(Dr)),s=Math.max(s,n.distanceToSquared(ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,o=t.uv,l=this.getAttribute("tangent");(l===void 0||l.count!==n.count)&&(l=new En(new Float32Array(4*n.count),4),this.setAttribute("tangent",l));let h=[],f=[],d=new Uint8Array(n.count);for(let q=0;q<n.count;q++)h[q]=new j,f[q]=new j;let m=new j,y=new j,g=new j,x=new et,E=new et,C=new et,S=new j,v=new j;function P(q,k,Y){d[q]=d[k]=d[Y]=1,m.fromBufferAttribute(n,q),y.fromBufferAttribute(n,k),g.fromBufferAttribute(n,Y),x.fromBufferAttribute(o,q),E.fromBufferAttribute(o,k),C.fromBufferAttribute(o,Y),y.sub(m),g.sub(m),E.sub(x),C.sub(x);let J=1/(E.x*C.y-C.x*E.y);isFinite(J)&&(S.copy(y).multiplyScalar(C.y).addScaledVector(g,-E.y).multiplyScalar(J),v.copy(g).multiplyScalar(E.x).addScaledVector(y,-C.x).multiplyScalar(J),h[q].add(S),h[k].add(S),h[Y].add(S),f[q].add(v),f[k].add(v),f[Y].add(v))}let U=this.groups;U.length===0&&(U=[{start:0,count:e.count}]);for(let q=0,k=U.length;q<k;++q){let Y=U[q],J=Y.start,ee=Y.count;for(let z=J,ie=J+ee;z<ie;z+=3)P(e.getX(z+0),e.getX(z+1),e.getX(z+2))}let I=new j,O=new j,N=new j,b=new j;function D(q){N.fromBufferAttribute(s,q),b.copy(N);let k=h[q];I.copy(k),I.sub(N.multiplyScalar(N.dot(k))).normalize(),O.crossVectors(b,k);let J=O.dot(f[q])<0?-1:1;l.setXYZW(q,I.x,I.y,I.z,J)}for(let q=0,k=n.count;q<k;++q)d[q]&&D(q);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new En(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let g=0,x=n.count;g<x;g++)n.setXYZ(g,0,0,0);let s=new j,o=new j,l=new j,h=new j,f=new j,d=new j,m=new j,y=new j;if(e)for(let g=0,x=e.count;g<x;g+=3){let E=e.getX(g+0),C=e.getX(g+1),S=e.getX(g+2);s.fromBufferAttribute(t,E),o.fromBufferAttribute(t,C),l.fromBufferAttribute(t,S),m.subVectors(l,o),y.subVectors(s,o),m.cross(y),h.fromBufferAttribute(n,E),f.fromBufferAttribute(n,C),d.fromBufferAttribute(n,S),h.add(m),f.add(m),d.add(m),n.setXYZ(E,h.x,h.y,h.z),n.setXYZ(C,f.x,f.y,f.z),n.setXYZ(S,d.x,d.y,d.z)}else for(let g=0,x=t.count;g<x;g+=3)s.fromBufferAttribute(t,g+0),o.fromBufferAttribute(t,g+1),l.fromBufferAttribute(t,g+2),m.subVectors(l,o),y.subVectors(s,o),m.cross(y),n.setXYZ(g+0,m.x,m.y,m.z),n.setXYZ(g+1,m.x,m.y,m.z),n.setXYZ(g+2,m.x,m.y,m.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)ln.fromBufferAttribute(e,t),ln.normalize(),e.setXYZ(t,ln.x,ln.y,ln.z)}toNonIndexed(){function e(h,f){let d=h.array,m=h.itemSize,y=h.normalized,g=new d.constructor(f.length*m),x=0,E=0;for(let C=0,S=f.length;C<S;C++){h.isInterleavedBufferAttribute?x=f[C]*h.data.stride+h.offset:x=f[C]*m;for(let v=0;v<m;v++)g[E++]=d[x++]}return new En(g,m,y)}if(this.index===null)return Qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let h in s){let f=s[h],d=e(f,n);t.setAttribute(h,d)}let o=this.morphAttributes;for(let h in o){let f=[],d=o[h];for(let m=0,y=d.length;m<y;m++){let g=d[m],x=e(g,n);f.push(x)}t.morphAttributes[h]=f}t.morphTargetsRelative=this.morphTargetsRelative;let l=this.groups;for(let h=0,f=l.length;h<f;h++){let d=l[h];t.addGroup(d.start,d.count,d.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let f=this.parameters;for(let d in f)f[d]!==void 0&&(e[d]=f[d]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let f in n){let d=n[f];e.data.attributes[f]=d.toJSON(e.data)}let s={},o=!1;for(let f in this.morphAttributes){let d=this.morphAttributes[f],m=[];for(let y=0,g=d.length;y<g;y++){let x=d[y];m.push(x.toJSON(e.data))}m.length>0&&(s[f]=m,o=!0)}o&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let l=this.groups;l.length>0&&(e.data.groups=JSON.parse(JSON.stringify(l)));let h=this.boundingSphere;return h!==null&&(e.data.boundingSphere=h.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let d in s){let m=s[d];this.setAttribute(d,m.clone(t))}let o=e.morphAttributes;for(let d in o){let m=[],y=o[d];for(let g=0,x=y.length;g<x;g++)m.push(y[g].clone(t));this.morphAttributes[d]=m}this.morphTargetsRelative=e.morphTargetsRelative;let l=e.groups;for(let d=0,m=l.length;d<m;d++){let y=l[d];this.addGroup(y.start,y.count,y.materialIndex)}let h=e.boundingBox;h!==null&&(this.boundingBox=h.clone());let f=e.boundingSphere;return f!==null&&(this.boundingSphere=f.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var yc=new j,Ev=new j,Tv=new ct,In=class{constructor(e=new j(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=yc.subVectors(n,t).cross(Ev.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(yc),o=this.normal.dot(s);if(o===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let l=-(e.start.dot(this.normal)+this.constant)/o;return n===!0&&(l<0||l>1)?null:t.copy(e.start).addScaledVector(s,l)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Tv.getNormalMatrix(e),s=this.coplanarPoint(yc).applyMatrix4(e),o=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(o),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Av=0,hi=class extends jn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Av++}),this.uuid=Qr(),this.name="",this.type="Material",this.blending=Zr,this.side=Yi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bc,this.blendDst=kc,this.blendEquation=pr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=Br,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Md,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=oo,this.stencilZFail=oo,this.stencilZPass=oo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Qe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(o=>o.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(o){let l=[];for(let h in o){let f=o[h];delete f.metadata,l.push(f)}return l}if(t){let o=s(e.textures),l=s(e.images);o.length>0&&(n.textures=o),l.length>0&&(n.images=l)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new In().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new et().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new et().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let o=0;o!==s;++o)n[o]=t[o].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var bi=new j,xc=new j,Ha=new j,Wa=new j,zi=class{constructor(e=new j,t=new j(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,bi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=bi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(bi.copy(this.origin).addScaledVector(this.direction,t),bi.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){xc.copy(e).add(t).multiplyScalar(.5),Ha.copy(t).sub(e).normalize(),Wa.copy(this.origin).sub(xc);let o=e.distanceTo(t)*.5,l=-this.direction.dot(Ha),h=Wa.dot(this.direction),f=-Wa.dot(Ha),d=Wa.lengthSq(),m=Math.abs(1-l*l),y,g,x,E;if(m>0)if(y=l*f-h,g=l*h-f,E=o*m,y>=0)if(g>=-E)if(g<=E){let C=1/m;y*=C,g*=C,x=y*(y+l*g+2*h)+g*(l*y+g+2*f)+d}else g=o,y=Math.max(0,-(l*g+h)),x=-y*y+g*(g+2*f)+d;else g=-o,y=Math.max(0,-(l*g+h)),x=-y*y+g*(g+2*f)+d;else g<=-E?(y=Math.max(0,-(-l*o+h)),g=y>0?-o:Math.min(Math.max(-o,-f),o),x=-y*y+g*(g+2*f)+d):g<=E?(y=0,g=Math.min(Math.max(-o,-f),o),x=g*(g+2*f)+d):(y=Math.max(0,-(l*o+h)),g=y>0?o:Math.min(Math.max(-o,-f),o),x=-y*y+g*(g+2*f)+d);else g=l>0?-o:o,y=Math.max(0,-(l*g+h)),x=-y*y+g*(g+2*f)+d;return n&&n.copy(this.origin).addScaledVector(this.direction,y),s&&s.copy(xc).addScaledVector(Ha,g),x}intersectSphere(e,t){if(e.radius<0)return null;bi.subVectors(e.center,this.origin);let n=bi.dot(this.direction),s=bi.dot(bi)-n*n,o=e.radius*e.radius;if(s>o)return null;let l=Math.sqrt(o-s),h=n-l,f=n+l;return f<0?null:h<0?this.at(f,t):this.at(h,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,o,l,h,f,d=1/this.direction.x,m=1/this.direction.y,y=1/this.direction.z,g=this.origin;return d>=0?(n=(e.min.x-g.x)*d,s=(e.max.x-g.x)*d):(n=(e.max.x-g.x)*d,s=(e.min.x-g.x)*d),m>=0?(o=(e.min.y-g.y)*m,l=(e.max.y-g.y)*m):(o=(e.max.y-g.y)*m,l=(e.min.y-g.y)*m),n>l||o>s||((o>n||isNaN(n))&&(n=o),(l<s||isNaN(s))&&(s=l),y>=0?(h=(e.min.z-g.z)*y,f=(e.max.z-g.z)*y):(h=(e.max.z-g.z)*y,f=(e.min.z-g.z)*y),n>f||h>s)||((h>n||n!==n)&&(n=h),(f<s||s!==s)&&(s=f),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,bi)!==null}intersectTriangle(e,t,n,s,o){let l=this.origin,h=this.direction,f=h.x,d=h.y,m=h.z,y=e.x-l.x,g=e.y-l.y,x=e.z-l.z,E=t.x-l.x,C=t.y-l.y,S=t.z-l.z,v=n.x-l.x,P=n.y-l.y,U=n.z-l.z,I=Math.abs(f),O=Math.abs(d),N=Math.abs(m),b,D,q,k,Y,J,ee,z,ie,G,ne,Se;if(I>=O&&I>=N?(q=f,J=y,ie=E,Se=v,f>=0?(b=d,D=m,k=g,Y=x,ee=C,z=S,G=P,ne=U):(b=m,D=d,k=x,Y=g,ee=S,z=C,G=U,ne=P)):O>=N?(q=d,J=g,ie=C,Se=P,d>=0?(b=m,D=f,k=x,Y=y,ee=S,z=E,G=U,ne=v):(b=f,D=m,k=y,Y=x,ee=E,z=S,G=v,ne=U)):(q=m,J=x,ie=S,Se=U,m>=0?(b=f,D=d,k=y,Y=g,ee=E,z=C,G=v,ne=P):(b=d,D=f,k=g,Y=y,ee=C,z=E,G=P,ne=v)),q===0)return null;let re=b/q,H=D/q,ge=1/q,We=k-re*J,rt=Y-H*J,ue=ee-re*ie,Fe=z-H*ie,Pe=G-re*Se,je=ne-H*Se,Ue=Pe*Fe-je*ue,ot=We*je-rt*Pe,Vt=ue*rt-Fe*We;if(s){if(Ue<0||ot<0||Vt<0)return null}else if((Ue<0||ot<0||Vt<0)&&(Ue>0||ot>0||Vt>0))return null;let Ke=Ue+ot+Vt;if(Ke===0)return null;let Et=ge*(Ue*J+ot*ie+Vt*Se);return(Ke>0?Et<0:Et>0)?null:this.at(Et/Ke,o)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Cs=class extends hi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new li,this.combine=zo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Du=new Lt,lr=new zi,Xa=new Ti,Lu=new j,$a=new j,qa=new j,Ya=new j,Sc=new j,ja=new j,Fu=new j,Za=new j,Ot=class extends Qt{constructor(e=new wn,t=new Cs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,l=s.length;o<l;o++){let h=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[h]=o}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,o=n.morphAttributes.position,l=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let h=this.morphTargetInfluences;if(o&&h){ja.set(0,0,0);for(let f=0,d=o.length;f<d;f++){let m=h[f],y=o[f];m!==0&&(Sc.fromBufferAttribute(y,e),l?ja.addScaledVector(Sc,m):ja.addScaledVector(Sc.sub(t),m))}t.add(ja)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,o=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Xa.copy(n.boundingSphere),Xa.applyMatrix4(o),lr.copy(e.ray).recast(e.near),!(Xa.containsPoint(lr.origin)===!1&&(lr.intersectSphere(Xa,Lu)===null||lr.origin.distanceToSquared(Lu)>(e.far-e.near)**2))&&(Du.copy(o).invert(),lr.copy(e.ray).applyMatrix4(Du),!(n.boundingBox!==null&&lr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,lr)))}_computeIntersections(e,t,n){let s,o=this.geometry,l=this.material,h=o.index,f=o.attributes.position,d=o.attributes.uv,m=o.attributes.uv1,y=o.attributes.normal,g=o.groups,x=o.drawRange;if(h!==null)if(Array.isArray(l))for(let E=0,C=g.length;E<C;E++){let S=g[E],v=l[S.materialIndex],P=Math.max(S.start,x.start),U=Math.min(h.count,Math.min(S.start+S.count,x.start+x.count));for(let I=P,O=U;I<O;I+=3){let N=h.getX(I),b=h.getX(I+1),D=h.getX(I+2);s=Ja(this,v,e,n,d,m,y,N,b,D),s&&(s.faceIndex=Math.floor(I/3),s.face.materialIndex=S.materialIndex,t.push(s))}}else{let E=Math.max(0,x.start),C=Math.min(h.count,x.start+x.count);for(let S=E,v=C;S<v;S+=3){let P=h.getX(S),U=h.getX(S+1),I=h.getX(S+2);s=Ja(this,l,e,n,d,m,y,P,U,I),s&&(s.faceIndex=Math.floor(S/3),t.push(s))}}else if(f!==void 0)if(Array.isArray(l))for(let E=0,C=g.length;E<C;E++){let S=g[E],v=l[S.materialIndex],P=Math.max(S.start,x.start),U=Math.min(f.count,Math.min(S.start+S.count,x.start+x.count));for(let I=P,O=U;I<O;I+=3){let N=I,b=I+1,D=I+2;s=Ja(this,v,e,n,d,m,y,N,b,D),s&&(s.faceIndex=Math.floor(I/3),s.face.materialIndex=S.materialIndex,t.push(s))}}else{let E=Math.max(0,x.start),C=Math.min(f.count,x.start+x.count);for(let S=E,v=C;S<v;S+=3){let P=S,U=S+1,I=S+2;s=Ja(this,l,e,n,d,m,y,P,U,I),s&&(s.faceIndex=Math.floor(S/3),t.push(s))}}}};function Rv(i,e,t,n,s,o,l,h){let f;if(e.side===dn?f=n.intersectTriangle(l,o,s,!0,h):f=n.intersectTriangle(s,o,l,e.side===Yi,h),f===null)return null;Za.copy(h),Za.applyMatrix4(i.matrixWorld);let d=t.ray.origin.distanceTo(Za);return d<t.near||d>t.far?null:{distance:d,point:Za.clone(),object:i}}function Ja(i,e,t,n,s,o,l,h,f,d){i.getVertexPosition(h,$a),i.getVertexPosition(f,qa),i.getVertexPosition(d,Ya);let m=Rv(i,e,t,n,$a,qa,Ya,Fu);if(m){let y=new j;ki.getBarycoord(Fu,$a,qa,Ya,y),s&&(m.uv=ki.getInterpolatedAttribute(s,h,f,d,y,new et)),o&&(m.uv1=ki.getInterpolatedAttribute(o,h,f,d,y,new et)),l&&(m.normal=ki.getInterpolatedAttribute(l,h,f,d,y,new j),m.normal.dot(n.direction)>0&&m.normal.multiplyScalar(-1));let g={a:h,b:f,c:d,normal:new j,materialIndex:0};ki.getNormal($a,qa,Ya,g.normal),m.face=g,m.barycoord=y}return m}var Ps=class extends bn{constructor(e=null,t=1,n=1,s,o,l,h,f,d=cn,m=cn,y,g){super(null,l,h,f,d,m,s,o,y,g),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Is=class extends En{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Lr=new Lt,Nu=new Lt,Ka=[],Uu=new ci,Cv=new Lt,ms=new Ot,gs=new Ti,Ds=class extends Ot{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Is(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Cv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new ci),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Lr),Uu.copy(e.boundingBox).applyMatrix4(Lr),this.boundingBox.union(Uu)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ti),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Lr),gs.copy(e.boundingSphere).applyMatrix4(Lr),this.boundingSphere.union(gs)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,o=n.length+1,l=e*o+1;for(let h=0;h<n.length;h++)n[h]=s[l+h]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(ms.geometry=this.geometry,ms.material=this.material,ms.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),gs.copy(this.boundingSphere),gs.applyMatrix4(n),e.ray.intersectsSphere(gs)!==!1))for(let o=0;o<s;o++){this.getMatrixAt(o,Lr),Nu.multiplyMatrices(n,Lr),ms.matrixWorld=Nu,ms.raycast(e,Ka);for(let l=0,h=Ka.length;l<h;l++){let f=Ka[l];f.instanceId=o,f.object=this,t.push(f)}Ka.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Is(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Ps(new Float32Array(s*this.count),s,this.count,qo,zn));let o=this.morphTexture.source.data.data,l=0;for(let d=0;d<n.length;d++)l+=n[d];let h=this.geometry.morphTargetsRelative?1:1-l,f=s*e;return o[f]=h,o.set(n,f+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},cr=new Ti,Pv=new et(.5,.5),Qa=new j,Gi=class{constructor(e=new In,t=new In,n=new In,s=new In,o=new In,l=new In){this.planes=[e,t,n,s,o,l]}set(e,t,n,s,o,l){let h=this.planes;return h[0].copy(e),h[1].copy(t),h[2].copy(n),h[3].copy(s),h[4].copy(o),h[5].copy(l),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Bn,n=!1){let s=this.planes,o=e.elements,l=o[0],h=o[1],f=o[2],d=o[3],m=o[4],y=o[5],g=o[6],x=o[7],E=o[8],C=o[9],S=o[10],v=o[11],P=o[12],U=o[13],I=o[14],O=o[15];if(s[0].setComponents(d-l,x-m,v-E,O-P).normalize(),s[1].setComponents(d+l,x+m,v+E,O+P).normalize(),s[2].setComponents(d+h,x+y,v+C,O+U).normalize(),s[3].setComponents(d-h,x-y,v-C,O-U).normalize(),n)s[4].setComponents(f,g,S,I).normalize(),s[5].setComponents(d-f,x-g,v-S,O-I).normalize();else if(s[4].setComponents(d-f,x-g,v-S,O-I).normalize(),t===Bn)s[5].setComponents(d+f,x+g,v+S,O+I).normalize();else if(t===zr)s[5].setComponents(f,g,S,I).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),cr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),cr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(cr)}intersectsSprite(e){cr.center.set(0,0,0);let t=Pv.distanceTo(e.center);return cr.radius=.7071067811865476+t,cr.applyMatrix4(e.matrixWorld),this.intersectsSphere(cr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let o=0;o<6;o++)if(t[o].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Qa.x=s.normal.x>0?e.max.x:e.min.x,Qa.y=s.normal.y>0?e.max.y:e.min.y,Qa.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Qa)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Ou=new Lt,So=class i{constructor(){this.coordinateSystem=Bn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let o=t[s];Ou.multiplyMatrices(o.projectionMatrix,o.matrixWorldInverse),n[s]===void 0&&(n[s]=new Gi),n[s].setFromProjectionMatrix(Ou,o.coordinateSystem,o.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Gi),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ls=class extends hi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Mo=new j,bo=new j,Bu=new Lt,_s=new zi,eo=new Ti,Mc=new j,ku=new j,wo=class extends Qt{constructor(e=new wn,t=new Ls){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,o=t.count;s<o;s++)Mo.fromBufferAttribute(t,s-1),bo.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Mo.distanceTo(bo);e.setAttribute("lineDistance",new Xt(n,1))}else Qe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,o=e.params.Line.threshold,l=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),eo.copy(n.boundingSphere),eo.applyMatrix4(s),eo.radius+=o,e.ray.intersectsSphere(eo)===!1)return;Bu.copy(s).invert(),_s.copy(e.ray).applyMatrix4(Bu);let h=o/((this.scale.x+this.scale.y+this.scale.z)/3),f=h*h,d=this.isLineSegments?2:1,m=n.index,g=n.attributes.position;if(m!==null){let x=Math.max(0,l.start),E=Math.min(m.count,l.start+l.count);for(let C=x,S=E-1;C<S;C+=d){let v=m.getX(C),P=m.getX(C+1),U=to(this,e,_s,f,v,P,C);U&&t.push(U)}if(this.isLineLoop){let C=m.getX(E-1),S=m.getX(x),v=to(this,e,_s,f,C,S,E-1);v&&t.push(v)}}else{let x=Math.max(0,l.start),E=Math.min(g.count,l.start+l.count);for(let C=x,S=E-1;C<S;C+=d){let v=to(this,e,_s,f,C,C+1,C);v&&t.push(v)}if(this.isLineLoop){let C=to(this,e,_s,f,E-1,x,E-1);C&&t.push(C)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,l=s.length;o<l;o++){let h=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[h]=o}}}}};function to(i,e,t,n,s,o,l){let h=i.geometry.attributes.position;if(Mo.fromBufferAttribute(h,s),bo.fromBufferAttribute(h,o),t.distanceSqToSegment(Mo,bo,Mc,ku)>n)return;Mc.applyMatrix4(i.matrixWorld);let d=e.ray.origin.distanceTo(Mc);if(!(d<e.near||d>e.far))return{distance:d,point:ku.clone().applyMatrix4(i.matrixWorld),index:l,face:null,faceIndex:null,barycoord:null,object:i}}var Fs=class extends bn{constructor(e=[],t=mr,n,s,o,l,h,f,d,m){super(e,t,n,s,o,l,h,f,d,m),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Ns=class extends bn{constructor(e,t,n,s,o,l,h,f,d){super(e,t,n,s,o,l,h,f,d),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ai=class extends bn{constructor(e,t,n=Zn,s,o,l,h=cn,f=cn,d,m=Ei,y=1){if(m!==Ei&&m!==Pi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let g={width:e,height:t,depth:y};super(g,s,o,l,h,f,m,n,d),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Hr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Us=class extends Ai{constructor(e,t=Zn,n=mr,s,o,l=cn,h=cn,f,d=Ei){let m={width:e,height:e,depth:1},y=[m,m,m,m,m,m];super(e,e,t,n,s,o,l,h,f,d),this.image=y,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Os=class extends bn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ui=class i extends wn{constructor(e=1,t=1,n=1,s=1,o=1,l=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:o,depthSegments:l};let h=this;s=Math.floor(s),o=Math.floor(o),l=Math.floor(l);let f=[],d=[],m=[],y=[],g=0,x=0;E("z","y","x",-1,-1,n,t,e,l,o,0),E("z","y","x",1,-1,n,t,-e,l,o,1),E("x","z","y",1,1,e,n,t,s,l,2),E("x","z","y",1,-1,e,n,-t,s,l,3),E("x","y","z",1,-1,e,t,n,s,o,4),E("x","y","z",-1,-1,e,t,-n,s,o,5),this.setIndex(f),this.setAttribute("position",new Xt(d,3)),this.setAttribute("normal",new Xt(m,3)),this.setAttribute("uv",new Xt(y,2));function E(C,S,v,P,U,I,O,N,b,D,q){let k=I/b,Y=O/D,J=I/2,ee=O/2,z=N/2,ie=b+1,G=D+1,ne=0,Se=0,re=new j;for(let H=0;H<G;H++){let ge=H*Y-ee;for(let We=0;We<ie;We++){let rt=We*k-J;re[C]=rt*P,re[S]=ge*U,re[v]=z,d.push(re.x,re.y,re.z),re[C]=0,re[S]=0,re[v]=N>0?1:-1,m.push(re.x,re.y,re.z),y.push(We/b),y.push(1-H/D),ne+=1}}for(let H=0;H<D;H++)for(let ge=0;ge<b;ge++){let We=g+ge+ie*H,rt=g+ge+ie*(H+1),ue=g+(ge+1)+ie*(H+1),Fe=g+(ge+1)+ie*H;f.push(We,rt,Fe),f.push(rt,ue,Fe),Se+=6}h.addGroup(x,Se,q),x+=Se,g+=ne}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},Bs=class i extends wn{constructor(e=1,t=1,n=4,s=8,o=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:s,heightSegments:o},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),o=Math.max(1,Math.floor(o));let l=[],h=[],f=[],d=[],m=t/2,y=Math.PI/2*e,g=t,x=2*y+g,E=n*2+o,C=s+1,S=new j,v=new j;for(let P=0;P<=E;P++){let U=0,I=0,O=0,N=0;if(P<=n){let q=P/n,k=q*Math.PI/2;I=-m-e*Math.cos(k),O=e*Math.sin(k),N=-e*Math.cos(k),U=q*y}else if(P<=n+o){let q=(P-n)/o;I=-m+q*t,O=e,N=0,U=y+q*g}else{let q=(P-n-o)/n,k=q*Math.PI/2;I=m+e*Math.sin(k),O=e*Math.cos(k),N=e*Math.sin(k),U=y+g+q*y}let b=Math.max(0,Math.min(1,U/x)),D=0;P===0?D=.5/s:P===E&&(D=-.5/s);for(let q=0;q<=s;q++){let k=q/s,Y=k*Math.PI*2,J=Math.sin(Y),ee=Math.cos(Y);v.x=-O*ee,v.y=I,v.z=O*J,h.push(v.x,v.y,v.z),S.set(-O*ee,N,O*J),S.normalize(),f.push(S.x,S.y,S.z),d.push(k+D,b)}if(P>0){let q=(P-1)*C;for(let k=0;k<s;k++){let Y=q+k,J=q+k+1,ee=P*C+k,z=P*C+k+1;l.push(Y,J,ee),l.push(J,z,ee)}}}this.setIndex(l),this.setAttribute("position",new Xt(h,3)),this.setAttribute("normal",new Xt(f,3)),this.setAttribute("uv",new Xt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var $r=class i extends wn{constructor(e=1,t=1,n=1,s=32,o=1,l=!1,h=0,f=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:o,openEnded:l,thetaStart:h,thetaLength:f};let d=this;s=Math.floor(s),o=Math.floor(o);let m=[],y=[],g=[],x=[],E=0,C=[],S=n/2,v=0;P(),l===!1&&(e>0&&U(!0),t>0&&U(!1)),this.setIndex(m),this.setAttribute("position",new Xt(y,3)),this.setAttribute("normal",new Xt(g,3)),this.setAttribute("uv",new Xt(x,2));function P(){let I=new j,O=new j,N=0,b=(t-e)/n;for(let D=0;D<=o;D++){let q=[],k=D/o,Y=k*(t-e)+e;for(let J=0;J<=s;J++){let ee=J/s,z=ee*f+h,ie=Math.sin(z),G=Math.cos(z);O.x=Y*ie,O.y=-k*n+S,O.z=Y*G,y.push(O.x,O.y,O.z),I.set(ie,b,G).normalize(),g.push(I.x,I.y,I.z),x.push(ee,1-k),q.push(E++)}C.push(q)}for(let D=0;D<s;D++)for(let q=0;q<o;q++){let k=C[q][D],Y=C[q+1][D],J=C[q+1][D+1],ee=C[q][D+1];(e>0||q!==0)&&(m.push(k,Y,ee),N+=3),(t>0||q!==o-1)&&(m.push(Y,J,ee),N+=3)}d.addGroup(v,N,0),v+=N}function U(I){let O=E,N=new et,b=new j,D=0,q=I===!0?e:t,k=I===!0?1:-1;for(let J=1;J<=s;J++)y.push(0,S*k,0),g.push(0,k,0),x.push(.5,.5),E++;let Y=E;for(let J=0;J<=s;J++){let z=J/s*f+h,ie=Math.cos(z),G=Math.sin(z);b.x=q*G,b.y=S*k,b.z=q*ie,y.push(b.x,b.y,b.z),g.push(0,k,0),N.x=ie*.5+.5,N.y=G*.5*k+.5,x.push(N.x,N.y),E++}for(let J=0;J<s;J++){let ee=O+J,z=Y+J;I===!0?m.push(z,z+1,ee):m.push(z+1,z,ee),D+=3}d.addGroup(v,D,I===!0?1:2),v+=D}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Eo=class i extends $r{constructor(e=1,t=1,n=32,s=1,o=!1,l=0,h=Math.PI*2){super(0,e,t,n,s,o,l,h),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:o,thetaStart:l,thetaLength:h}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Vi=class i extends wn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let o=e/2,l=t/2,h=Math.floor(n),f=Math.floor(s),d=h+1,m=f+1,y=e/h,g=t/f,x=[],E=[],C=[],S=[];for(let v=0;v<m;v++){let P=v*g-l;for(let U=0;U<d;U++){let I=U*y-o;E.push(I,-P,0),C.push(0,0,1),S.push(U/h),S.push(1-v/f)}}for(let v=0;v<f;v++)for(let P=0;P<h;P++){let U=P+d*v,I=P+d*(v+1),O=P+1+d*(v+1),N=P+1+d*v;x.push(U,I,N),x.push(I,O,N)}this.setIndex(x),this.setAttribute("position",new Xt(E,3)),this.setAttribute("normal",new Xt(C,3)),this.setAttribute("uv",new Xt(S,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var ur=class i extends wn{constructor(e=1,t=32,n=16,s=0,o=Math.PI*2,l=0,h=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:o,thetaStart:l,thetaLength:h},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let f=Math.min(l+h,Math.PI),d=0,m=[],y=new j,g=new j,x=[],E=[],C=[],S=[];for(let v=0;v<=n;v++){let P=[],U=v/n,I=l+U*h,O=e*Math.cos(I),N=Math.sqrt(e*e-O*O),b=0;v===0&&l===0?b=.5/t:v===n&&f===Math.PI&&(b=-.5/t);for(let D=0;D<=t;D++){let q=D/t,k=s+q*o;y.x=-N*Math.cos(k),y.y=O,y.z=N*Math.sin(k),E.push(y.x,y.y,y.z),g.copy(y).normalize(),C.push(g.x,g.y,g.z),S.push(q+b,1-U),P.push(d++)}m.push(P)}for(let v=0;v<n;v++)for(let P=0;P<t;P++){let U=m[v][P+1],I=m[v][P],O=m[v+1][P],N=m[v+1][P+1];(v!==0||l>0)&&x.push(U,I,N),(v!==n-1||f<Math.PI)&&x.push(I,O,N)}this.setIndex(x),this.setAttribute("position",new Xt(E,3)),this.setAttribute("normal",new Xt(C,3)),this.setAttribute("uv",new Xt(S,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function _r(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(zu(s))s.isRenderTargetTexture?(Qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(zu(s[0])){let o=[];for(let l=0,h=s.length;l<h;l++)o[l]=s[l].clone();e[t][n]=o}else e[t][n]=s.slice();else e[t][n]=s}}return e}function _n(i){let e={};for(let t=0;t<i.length;t++){let n=_r(i[t]);for(let s in n)e[s]=n[s]}return e}function zu(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Iv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function lh(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Ud={clone:_r,merge:_n},Dv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Lv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,di=class extends hi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Dv,this.fragmentShader=Lv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=_r(e.uniforms),this.uniformsGroups=Iv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let l=this.uniforms[s].value;l&&l.isTexture?t.uniforms[s]={type:"t",value:l.toJSON(e).uuid}:l&&l.isColor?t.uniforms[s]={type:"c",value:l.getHex()}:l&&l.isVector2?t.uniforms[s]={type:"v2",value:l.toArray()}:l&&l.isVector3?t.uniforms[s]={type:"v3",value:l.toArray()}:l&&l.isVector4?t.uniforms[s]={type:"v4",value:l.toArray()}:l&&l.isMatrix3?t.uniforms[s]={type:"m3",value:l.toArray()}:l&&l.isMatrix4?t.uniforms[s]={type:"m4",value:l.toArray()}:t.uniforms[s]={value:l}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ht().setHex(s.value);break;case"v2":this.uniforms[n].value=new et().fromArray(s.value);break;case"v3":this.uniforms[n].value=new j().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Gt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ct().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Lt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},To=class extends di{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ri=class extends hi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ra,this.normalScale=new et(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new li,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var ks=class extends hi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ra,this.normalScale=new et(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new li,this.combine=zo,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Ao=class extends hi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=xd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ro=class extends hi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Fr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function no(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Hi=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],o=t[n-1];e:{t:{let l;n:{i:if(!(e<s)){for(let h=n+2;;){if(s===void 0){if(e<o)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===h)break;if(o=s,s=t[++n],e<s)break t}l=t.length;break n}if(!(e>=o)){let h=t[1];e<h&&(n=2,o=h);for(let f=n-2;;){if(o===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===f)break;if(s=o,o=t[--n-1],e>=o)break t}l=n,n=0;break n}break e}for(;n<l;){let h=n+l>>>1;e<t[h]?l=h:n=h+1}if(s=t[n],o=t[n-1],o===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,o,s)}return this.interpolate_(n,o,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,o=e*s;for(let l=0;l!==s;++l)t[l]=n[o+l];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Co=class extends Hi{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Tc,endingEnd:Tc}}intervalChanged_(e,t,n){let s=this.parameterPositions,o=e-2,l=e+1,h=s[o],f=s[l];if(h===void 0)switch(this.getSettings_().endingStart){case Ac:o=e,h=2*t-n;break;case Rc:o=s.length-2,h=t+s[o]-s[o+1];break;default:o=e,h=n}if(f===void 0)switch(this.getSettings_().endingEnd){case Ac:l=e,f=2*n-t;break;case Rc:l=1,f=n+s[1]-s[0];break;default:l=e-1,f=t}let d=(n-t)*.5,m=this.valueSize;this._weightPrev=d/(t-h),this._weightNext=d/(f-n),this._offsetPrev=o*m,this._offsetNext=l*m}interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=this._offsetPrev,y=this._offsetNext,g=this._weightPrev,x=this._weightNext,E=(n-t)/(s-t),C=E*E,S=C*E,v=-g*S+2*g*C-g*E,P=(1+g)*S+(-1.5-2*g)*C+(-.5+g)*E+1,U=(-1-x)*S+(1.5+x)*C+.5*E,I=x*S-x*C;for(let O=0;O!==h;++O)o[O]=v*l[m+O]+P*l[d+O]+U*l[f+O]+I*l[y+O];return o}},Po=class extends Hi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=(n-t)/(s-t),y=1-m;for(let g=0;g!==h;++g)o[g]=l[d+g]*y+l[f+g]*m;return o}},Io=class extends Hi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Do=class extends Hi{interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=this.inTangents,y=this.outTangents;if(!m||!y){let E=(n-t)/(s-t),C=1-E;for(let S=0;S!==h;++S)o[S]=l[d+S]*C+l[f+S]*E;return o}let g=h*2,x=e-1;for(let E=0;E!==h;++E){let C=l[d+E],S=l[f+E],v=x*g+E*2,P=y[v],U=y[v+1],I=e*g+E*2,O=m[I],N=m[I+1],b=Nv(n,t,P,O,s);o[E]=Od(b,C,U,N,S)}return o}};function Od(i,e,t,n,s){let o=1-i;return o*o*o*e+3*o*o*i*t+3*o*i*i*n+i*i*i*s}function Fv(i,e,t,n,s){let o=1-i;return 3*o*o*(t-e)+6*o*i*(n-t)+3*i*i*(s-n)}function Nv(i,e,t,n,s){let o=(i-e)/(s-e);for(let l=0;l<8;l++){let h=Od(o,e,t,n,s)-i;if(Math.abs(h)<1e-10)break;let f=Fv(o,e,t,n,s);if(Math.abs(f)<1e-10)break;o=Math.max(0,Math.min(1,o-h/f))}return o}var Ln=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Fr(t,this.TimeBufferType),this.values=Fr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Fr(e.times,Array),values:Fr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),no(e.settings)&&(n.settings={inTangents:Fr(e.settings.inTangents,Array),outTangents:Fr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Io(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Po(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Co(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Do(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ss:t=this.InterpolantFactoryMethodDiscrete;break;case _o:t=this.InterpolantFactoryMethodLinear;break;case ao:t=this.InterpolantFactoryMethodSmooth;break;case Ec:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ss;case this.InterpolantFactoryMethodLinear:return _o;case this.InterpolantFactoryMethodSmooth:return ao;case this.InterpolantFactoryMethodBezier:return Ec}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;no(this.settings)&&(Gu(this.settings.inTangents,e),Gu(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;no(this.settings)&&(Vu(this.settings.inTangents,e),Vu(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,o=0,l=s-1;for(;o!==s&&n[o]<e;)++o;for(;l!==-1&&n[l]>t;)--l;if(++l,o!==0||l!==s){o>=l&&(l=Math.max(l,1),o=l-1);let h=this.getValueSize();this.times=n.slice(o,l),this.values=this.values.slice(o*h,l*h)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,o=n.length;o===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let l=null;for(let h=0;h!==o;h++){let f=n[h];if(typeof f=="number"&&isNaN(f)){it("KeyframeTrack: Time is not a valid number.",this,h,f),e=!1;break}if(l!==null&&l>f){it("KeyframeTrack: Out of order keys.",this,h,f,l),e=!1;break}l=f}if(s!==void 0&&Z0(s))for(let h=0,f=s.length;h!==f;++h){let d=s[h];if(isNaN(d)){it("KeyframeTrack: Value is not a valid number.",this,h,d),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===ao,o=e.length-1,l=1;for(let h=1;h<o;++h){let f=!1,d=e[h],m=e[h+1];if(d!==m&&(h!==1||d!==e[0]))if(s)f=!0;else{let y=h*n,g=y-n,x=y+n;for(let E=0;E!==n;++E){let C=t[y+E];if(C!==t[g+E]||C!==t[x+E]){f=!0;break}}}if(f){if(h!==l){e[l]=e[h];let y=h*n,g=l*n;for(let x=0;x!==n;++x)t[g+x]=t[y+x]}++l}}if(o>0){e[l]=e[o];for(let h=o*n,f=l*n,d=0;d!==n;++d)t[f+d]=t[h+d];++l}return l!==e.length?(this.times=e.slice(0,l),this.values=t.slice(0,l*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,no(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Gu(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Vu(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Ln.prototype.ValueTypeName="";Ln.prototype.TimeBufferType=Float32Array;Ln.prototype.ValueBufferType=Float32Array;Ln.prototype.DefaultInterpolation=_o;var Wi=class extends Ln{constructor(e,t,n){super(e,t,n)}};Wi.prototype.ValueTypeName="bool";Wi.prototype.ValueBufferType=Array;Wi.prototype.DefaultInterpolation=Ss;Wi.prototype.InterpolantFactoryMethodLinear=void 0;Wi.prototype.InterpolantFactoryMethodSmooth=void 0;var Lo=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}};Lo.prototype.ValueTypeName="color";var Fo=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}};Fo.prototype.ValueTypeName="number";var No=class extends Hi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=(n-t)/(s-t),d=e*h;for(let m=d+h;d!==m;d+=4)Mn.slerpFlat(o,0,l,d-h,l,d,f);return o}},zs=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new No(this.times,this.values,this.getValueSize(),e)}};zs.prototype.ValueTypeName="quaternion";zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Xi=class extends Ln{constructor(e,t,n){super(e,t,n)}};Xi.prototype.ValueTypeName="string";Xi.prototype.ValueBufferType=Array;Xi.prototype.DefaultInterpolation=Ss;Xi.prototype.InterpolantFactoryMethodLinear=void 0;Xi.prototype.InterpolantFactoryMethodSmooth=void 0;var Uo=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}};Uo.prototype.ValueTypeName="vector";var Oo=class{constructor(e,t,n){let s=this,o=!1,l=0,h=0,f,d=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(m){h++,o===!1&&s.onStart!==void 0&&s.onStart(m,l,h),o=!0},this.itemEnd=function(m){l++,s.onProgress!==void 0&&s.onProgress(m,l,h),l===h&&(o=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(m){s.onError!==void 0&&s.onError(m)},this.resolveURL=function(m){return m=m.normalize("NFC"),f?f(m):m},this.setURLModifier=function(m){return f=m,this},this.addHandler=function(m,y){return d.push(m,y),this},this.removeHandler=function(m){let y=d.indexOf(m);return y!==-1&&d.splice(y,2),this},this.getHandler=function(m){for(let y=0,g=d.length;y<g;y+=2){let x=d[y],E=d[y+1];if(x.global&&(x.lastIndex=0),x.test(m))return E}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Bd=new Oo,Bo=class{constructor(e){this.manager=e!==void 0?e:Bd,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,o){n.load(e,s,t,o)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Bo.DEFAULT_MATERIAL_NAME="__DEFAULT";var Gs=class extends Qt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var bc=new Lt,Hu=new j,Wu=new j,Vs=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new et(512,512),this.mapType=Tn,this.map=null,this.mapPass=null,this.matrix=new Lt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gi,this._frameExtents=new et(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Hu.setFromMatrixPosition(e.matrixWorld),t.position.copy(Hu),Wu.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Wu),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){bc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(bc,e.coordinateSystem,e.reversedDepth);let o=this._frameExtents,l=s?s.z/o.x:1,h=s?s.w/o.y:1,f=s?s.x/o.x:0,d=s?s.y/o.y:0;e.coordinateSystem===zr||e.reversedDepth?t.set(.5*l,0,0,.5*l+f,0,.5*h,0,.5*h+d,0,0,1,0,0,0,0,1):t.set(.5*l,0,0,.5*l+f,0,.5*h,0,.5*h+d,0,0,.5,.5,0,0,0,1),t.multiply(bc)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},io=new j,ro=new Mn,ai=new j,Hs=class extends Qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Lt,this.projectionMatrix=new Lt,this.projectionMatrixInverse=new Lt,this.coordinateSystem=Bn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(io,ro,ai),ai.x===1&&ai.y===1&&ai.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(io,ro,ai.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(io,ro,ai),ai.x===1&&ai.y===1&&ai.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(io,ro,ai.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Bi=new j,Xu=new et,$u=new et,gn=class extends Hs{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Vr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ys*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Vr*2*Math.atan(Math.tan(ys*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Bi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Bi.x,Bi.y).multiplyScalar(-e/Bi.z),Bi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Bi.x,Bi.y).multiplyScalar(-e/Bi.z)}getViewSize(e,t){return this.getViewBounds(e,Xu,$u),t.subVectors($u,Xu)}setViewOffset(e,t,n,s,o,l){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ys*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,o=-.5*s,l=this.view;if(this.view!==null&&this.view.enabled){let f=l.fullWidth,d=l.fullHeight;o+=l.offsetX*s/f,t-=l.offsetY*n/d,s*=l.width/f,n*=l.height/d}let h=this.filmOffset;h!==0&&(o+=e*h/this.getFilmWidth()),this.projectionMatrix.makePerspective(o,o+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Cc=class extends Vs{constructor(){super(new gn(90,1,.5,500)),this.isPointLightShadow=!0}},Ws=class extends Gs{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new Cc}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Xs=class extends Hs{constructor(e=-1,t=1,n=1,s=-1,o=.1,l=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=o,this.far=l,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,o,l){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,o=n-e,l=n+e,h=s+t,f=s-t;if(this.view!==null&&this.view.enabled){let d=(this.right-this.left)/this.view.fullWidth/this.zoom,m=(this.top-this.bottom)/this.view.fullHeight/this.zoom;o+=d*this.view.offsetX,l=o+d*this.view.width,h-=m*this.view.offsetY,f=h-m*this.view.height}this.projectionMatrix.makeOrthographic(o,l,h,f,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Pc=class extends Vs{constructor(){super(new Xs(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},$s=class extends Gs{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.shadow=new Pc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Nr=-90,Ur=1,qr=class extends Qt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new gn(Nr,Ur,e,t);s.layers=this.layers,this.add(s);let o=new gn(Nr,Ur,e,t);o.layers=this.layers,this.add(o);let l=new gn(Nr,Ur,e,t);l.layers=this.layers,this.add(l);let h=new gn(Nr,Ur,e,t);h.layers=this.layers,this.add(h);let f=new gn(Nr,Ur,e,t);f.layers=this.layers,this.add(f);let d=new gn(Nr,Ur,e,t);d.layers=this.layers,this.add(d)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,o,l,h,f]=t;for(let d of t)this.remove(d);if(e===Bn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),o.up.set(0,0,-1),o.lookAt(0,1,0),l.up.set(0,0,1),l.lookAt(0,-1,0),h.up.set(0,1,0),h.lookAt(0,0,1),f.up.set(0,1,0),f.lookAt(0,0,-1);else if(e===zr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),o.up.set(0,0,1),o.lookAt(0,1,0),l.up.set(0,0,-1),l.lookAt(0,-1,0),h.up.set(0,-1,0),h.lookAt(0,0,1),f.up.set(0,-1,0),f.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let d of t)this.add(d),d.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[o,l,h,f,d,m]=this.children,y=e.getRenderTarget(),g=e.getActiveCubeFace(),x=e.getActiveMipmapLevel(),E=e.xr.enabled;e.xr.enabled=!1;let C=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let S=!1;e.isWebGLRenderer===!0?S=e.state.buffers.depth.getReversed():S=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,1,s),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,2,s),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(n,3,s),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,f),e.setRenderTarget(n,4,s),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,d),n.texture.mipmapsAutoUpdate=C,e.setRenderTarget(n,5,s),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,m),e.setRenderTarget(y,g,x),e.xr.enabled=E,n.texture.needsPMREMUpdate=!0}},ko=class extends gn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ch="\\[\\]\\.:\\/",Uv=new RegExp("["+ch+"]","g"),hh="[^"+ch+"]",Ov="[^"+ch.replace("\\.","")+"]",Bv=/((?:WC+[\/:])*)/.source.replace("WC",hh),kv=/(WCOD+)?/.source.replace("WCOD",Ov),zv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",hh),Gv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",hh),Vv=new RegExp("^"+Bv+kv+zv+Gv+"$"),Hv=["material","materials","bones","map"],Ic=class{constructor(e,t,n){let s=n||zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,o=n.length;s!==o;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},zt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Uv,"")}static parseTrackName(e){let t=Vv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let o=n.nodeName.substring(s+1);Hv.indexOf(o)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=o)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(o){for(let l=0;l<o.length;l++){let h=o[l];if(h.name===t||h.uuid===t)return h;let f=n(h.children);if(f)return f}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,o=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let d=t.objectIndex;switch(n){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let m=0;m<e.length;m++)if(e[m].name===d){d=m;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(d!==void 0){if(e[d]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[d]}}let l=e[s];if(l===void 0){let d=t.nodeName;it("PropertyBinding: Trying to update property for track: "+d+"."+s+" but it wasn't found.",e);return}let h=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?h=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(h=this.Versioning.MatrixWorldNeedsUpdate);let f=this.BindingType.Direct;if(o!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[o]!==void 0&&(o=e.morphTargetDictionary[o])}f=this.BindingType.ArrayElement,this.resolvedProperty=l,this.propertyIndex=o}else l.fromArray!==void 0&&l.toArray!==void 0?(f=this.BindingType.HasFromToArray,this.resolvedProperty=l):Array.isArray(l)?(f=this.BindingType.EntireArray,this.resolvedProperty=l):this.propertyName=s;this.getValue=this.GetterByBindingType[f],this.setValue=this.SetterByBindingTypeAndVersioning[f][h]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};zt.Composite=Ic;zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};zt.prototype.GetterByBindingType=[zt.prototype._getValue_direct,zt.prototype._getValue_array,zt.prototype._getValue_arrayElement,zt.prototype._getValue_toArray];zt.prototype.SetterByBindingTypeAndVersioning=[[zt.prototype._setValue_direct,zt.prototype._setValue_direct_setNeedsUpdate,zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_array,zt.prototype._setValue_array_setNeedsUpdate,zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_arrayElement,zt.prototype._setValue_arrayElement_setNeedsUpdate,zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_fromArray,zt.prototype._setValue_fromArray_setNeedsUpdate,zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Pw=new Float32Array(1);var qu=new Lt,qs=class{constructor(e,t,n=0,s=1/0){this.ray=new zi(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Wr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):it("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return qu.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(qu),this}intersectObject(e,t=!0,n=[]){return Dc(e,this,n,t),n.sort(Yu),n}intersectObjects(e,t=!0,n=[]){for(let s=0,o=e.length;s<o;s++)Dc(e[s],this,n,t);return n.sort(Yu),n}};function Yu(i,e){return i.distance-e.distance}function Dc(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let o=i.children;for(let l=0,h=o.length;l<h;l++)Dc(o[l],e,t,!0)}}var Yr=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(yt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Lc=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let o=this.elements;return o[0]=e,o[2]=t,o[1]=n,o[3]=s,this}};var ju=new j,so,wc,Ys=class extends Qt{constructor(e=new j(0,0,1),t=new j(0,0,0),n=1,s=16776960,o=n*.2,l=o*.2){super(),this.type="ArrowHelper",so===void 0&&(so=new wn,so.setAttribute("position",new Xt([0,0,0,0,1,0],3)),wc=new Eo(.5,1,5,1),wc.translate(0,-.5,0)),this.position.copy(t),this.line=new wo(so,new Ls({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Ot(wc,new Cs({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,o,l)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{ju.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(ju,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var js=class extends jn{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function uh(i,e,t,n){let s=Wv(n);switch(t){case Jc:return i*e;case qo:return i*e/s.components*s.byteLength;case Yo:return i*e/s.components*s.byteLength;case ji:return i*e*2/s.components*s.byteLength;case jo:return i*e*2/s.components*s.byteLength;case Kc:return i*e*3/s.components*s.byteLength;case Kn:return i*e*4/s.components*s.byteLength;case Zo:return i*e*4/s.components*s.byteLength;case Ks:case Qs:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ea:case ta:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ko:case el:return Math.max(i,16)*Math.max(e,8)/4;case Jo:case Qo:return Math.max(i,8)*Math.max(e,8)/2;case tl:case nl:case rl:case sl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case il:case na:case al:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ol:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ll:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case cl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case hl:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ul:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case dl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case fl:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case pl:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ml:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case gl:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case _l:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case vl:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case yl:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case xl:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Sl:case Ml:case bl:return Math.ceil(i/4)*Math.ceil(e/4)*16;case wl:case El:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ia:case Tl:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Wv(i){switch(i){case Tn:case qc:return{byteLength:1,components:1};case Kr:case Yc:case Jn:return{byteLength:2,components:1};case Xo:case $o:return{byteLength:2,components:4};case Zn:case Wo:case zn:return{byteLength:4,components:1};case jc:case Zc:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function of(){let i=null,e=!1,t=null,n=null;function s(o,l){n=i.requestAnimationFrame(s),t(o,l)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(o){t=o},setContext:function(o){i=o}}}function $v(i){let e=new WeakMap;function t(h,f){let d=h.array,m=h.usage,y=d.byteLength,g=i.createBuffer();i.bindBuffer(f,g),i.bufferData(f,d,m),h.onUploadCallback();let x;if(d instanceof Float32Array)x=i.FLOAT;else if(typeof Float16Array<"u"&&d instanceof Float16Array)x=i.HALF_FLOAT;else if(d instanceof Uint16Array)h.isFloat16BufferAttribute?x=i.HALF_FLOAT:x=i.UNSIGNED_SHORT;else if(d instanceof Int16Array)x=i.SHORT;else if(d instanceof Uint32Array)x=i.UNSIGNED_INT;else if(d instanceof Int32Array)x=i.INT;else if(d instanceof Int8Array)x=i.BYTE;else if(d instanceof Uint8Array)x=i.UNSIGNED_BYTE;else if(d instanceof Uint8ClampedArray)x=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+d);return{buffer:g,type:x,bytesPerElement:d.BYTES_PER_ELEMENT,version:h.version,size:y}}function n(h,f,d){let m=f.array,y=f.updateRanges;if(i.bindBuffer(d,h),y.length===0)i.bufferSubData(d,0,m);else{y.sort((x,E)=>x.start-E.start);let g=0;for(let x=1;x<y.length;x++){let E=y[g],C=y[x];C.start<=E.start+E.count+1?E.count=Math.max(E.count,C.start+C.count-E.start):(++g,y[g]=C)}y.length=g+1;for(let x=0,E=y.length;x<E;x++){let C=y[x];i.bufferSubData(d,C.start*m.BYTES_PER_ELEMENT,m,C.start,C.count)}f.clearUpdateRanges()}f.onUploadCallback()}function s(h){return h.isInterleavedBufferAttribute&&(h=h.data),e.get(h)}function o(h){h.isInterleavedBufferAttribute&&(h=h.data);let f=e.get(h);f&&(i.deleteBuffer(f.buffer),e.delete(h))}function l(h,f){if(h.isInterleavedBufferAttribute&&(h=h.data),h.isGLBufferAttribute){let m=e.get(h);(!m||m.version<h.version)&&e.set(h,{buffer:h.buffer,type:h.type,bytesPerElement:h.elementSize,version:h.version});return}let d=e.get(h);if(d===void 0)e.set(h,t(h,f));else if(d.version<h.version){if(d.size!==h.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(d.buffer,h,f),d.version=h.version}}return{get:s,remove:o,update:l}}var qv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Yv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,jv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Zv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Jv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Kv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Qv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ey=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ty=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,ny=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,iy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ry=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,sy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,ay=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,oy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ly=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,cy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,hy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,uy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,dy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,fy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,py=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,my=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,gy=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,_y=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,vy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Sy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,My="gl_FragColor = linearToOutputTexel( gl_FragColor );",by=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,wy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Ey=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ty=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Ay=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ry=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Cy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Py=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Iy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Dy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ly=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Fy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Ny=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Uy=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Oy=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,By=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,ky=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,zy=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Gy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Vy=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Hy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Wy=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Xy=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,$y=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,qy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Yy=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,jy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Zy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Jy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ky=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Qy=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,ex=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,tx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,nx=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ix=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,rx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,sx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,ax=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,ox=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lx=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,cx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,hx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,ux=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,dx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,px=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,mx=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,gx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,_x=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,vx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Sx=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Mx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,bx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,wx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ex=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Tx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Ax=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Rx=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Cx=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Px=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Ix=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Dx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Lx=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Fx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Nx=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Ux=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Ox=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Bx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,kx=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,zx=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Gx=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Vx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Hx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Wx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Xx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,$x=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,qx=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Yx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jx=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Zx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Jx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Kx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Qx=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,eS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,tS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,nS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,iS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,sS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,aS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,oS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,lS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,cS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,hS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,uS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,fS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,pS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,mS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,_S=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,SS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,MS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,bS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,wS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,ES=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,_t={alphahash_fragment:qv,alphahash_pars_fragment:Yv,alphamap_fragment:jv,alphamap_pars_fragment:Zv,alphatest_fragment:Jv,alphatest_pars_fragment:Kv,aomap_fragment:Qv,aomap_pars_fragment:ey,batching_pars_vertex:ty,batching_vertex:ny,begin_vertex:iy,beginnormal_vertex:ry,bsdfs:sy,iridescence_fragment:ay,bumpmap_pars_fragment:oy,clipping_planes_fragment:ly,clipping_planes_pars_fragment:cy,clipping_planes_pars_vertex:hy,clipping_planes_vertex:uy,color_fragment:dy,color_pars_fragment:fy,color_pars_vertex:py,color_vertex:my,common:gy,defaultnormal_vertex:_y,displacementmap_pars_vertex:vy,displacementmap_vertex:yy,emissivemap_fragment:xy,emissivemap_pars_fragment:Sy,colorspace_fragment:My,colorspace_pars_fragment:by,envmap_fragment:wy,envmap_common_pars_fragment:Ey,envmap_pars_fragment:Ty,envmap_pars_vertex:Ay,envmap_physical_pars_fragment:By,envmap_vertex:Ry,fog_vertex:Cy,fog_pars_vertex:Py,fog_fragment:Iy,fog_pars_fragment:Dy,gradientmap_pars_fragment:Ly,lightmap_pars_fragment:Fy,lights_lambert_fragment:Ny,lights_lambert_pars_fragment:Uy,lights_pars_begin:Oy,lights_toon_fragment:ky,lights_toon_pars_fragment:zy,lights_phong_fragment:Gy,lights_phong_pars_fragment:Vy,lights_physical_fragment:Hy,lights_physical_pars_fragment:Wy,lights_fragment_begin:Xy,lights_fragment_maps:$y,lights_fragment_end:qy,lightprobes_pars_fragment:Yy,logdepthbuf_fragment:jy,logdepthbuf_pars_fragment:Zy,logdepthbuf_pars_vertex:Jy,logdepthbuf_vertex:Ky,map_fragment:Qy,map_pars_fragment:ex,map_particle_fragment:tx,map_particle_pars_fragment:nx,metalnessmap_fragment:ix,metalnessmap_pars_fragment:rx,morphinstance_vertex:sx,morphcolor_vertex:ax,morphnormal_vertex:ox,morphtarget_pars_vertex:lx,morphtarget_vertex:cx,normal_fragment_begin:hx,normal_fragment_maps:ux,normal_pars_fragment:dx,normal_pars_vertex:fx,normal_vertex:px,normalmap_pars_fragment:mx,clearcoat_normal_fragment_begin:gx,clearcoat_normal_fragment_maps:_x,clearcoat_pars_fragment:vx,iridescence_pars_fragment:yx,opaque_fragment:xx,packing:Sx,premultiplied_alpha_fragment:Mx,project_vertex:bx,dithering_fragment:wx,dithering_pars_fragment:Ex,roughnessmap_fragment:Tx,roughnessmap_pars_fragment:Ax,shadowmap_pars_fragment:Rx,shadowmap_pars_vertex:Cx,shadowmap_vertex:Px,shadowmask_pars_fragment:Ix,skinbase_vertex:Dx,skinning_pars_vertex:Lx,skinning_vertex:Fx,skinnormal_vertex:Nx,specularmap_fragment:Ux,specularmap_pars_fragment:Ox,tonemapping_fragment:Bx,tonemapping_pars_fragment:kx,transmission_fragment:zx,transmission_pars_fragment:Gx,uv_pars_fragment:Vx,uv_pars_vertex:Hx,uv_vertex:Wx,worldpos_vertex:Xx,background_vert:$x,background_frag:qx,backgroundCube_vert:Yx,backgroundCube_frag:jx,cube_vert:Zx,cube_frag:Jx,depth_vert:Kx,depth_frag:Qx,distance_vert:eS,distance_frag:tS,equirect_vert:nS,equirect_frag:iS,linedashed_vert:rS,linedashed_frag:sS,meshbasic_vert:aS,meshbasic_frag:oS,meshlambert_vert:lS,meshlambert_frag:cS,meshmatcap_vert:hS,meshmatcap_frag:uS,meshnormal_vert:dS,meshnormal_frag:fS,meshphong_vert:pS,meshphong_frag:mS,meshphysical_vert:gS,meshphysical_frag:_S,meshtoon_vert:vS,meshtoon_frag:yS,points_vert:xS,points_frag:SS,shadow_vert:MS,shadow_frag:bS,sprite_vert:wS,sprite_frag:ES},Be={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new et(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new et(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},gi={basic:{uniforms:_n([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.fog]),vertexShader:_t.meshbasic_vert,fragmentShader:_t.meshbasic_frag},lambert:{uniforms:_n([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:_t.meshlambert_vert,fragmentShader:_t.meshlambert_frag},phong:{uniforms:_n([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_t.meshphong_vert,fragmentShader:_t.meshphong_frag},standard:{uniforms:_n([Be.common,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.roughnessmap,Be.metalnessmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag},toon:{uniforms:_n([Be.common,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.gradientmap,Be.fog,Be.lights,{emissive:{value:new ht(0)}}]),vertexShader:_t.meshtoon_vert,fragmentShader:_t.meshtoon_frag},matcap:{uniforms:_n([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,{matcap:{value:null}}]),vertexShader:_t.meshmatcap_vert,fragmentShader:_t.meshmatcap_frag},points:{uniforms:_n([Be.points,Be.fog]),vertexShader:_t.points_vert,fragmentShader:_t.points_frag},dashed:{uniforms:_n([Be.common,Be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_t.linedashed_vert,fragmentShader:_t.linedashed_frag},depth:{uniforms:_n([Be.common,Be.displacementmap]),vertexShader:_t.depth_vert,fragmentShader:_t.depth_frag},normal:{uniforms:_n([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,{opacity:{value:1}}]),vertexShader:_t.meshnormal_vert,fragmentShader:_t.meshnormal_frag},sprite:{uniforms:_n([Be.sprite,Be.fog]),vertexShader:_t.sprite_vert,fragmentShader:_t.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_t.background_vert,fragmentShader:_t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:_t.backgroundCube_vert,fragmentShader:_t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_t.cube_vert,fragmentShader:_t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_t.equirect_vert,fragmentShader:_t.equirect_frag},distance:{uniforms:_n([Be.common,Be.displacementmap,{referencePosition:{value:new j},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_t.distance_vert,fragmentShader:_t.distance_frag},shadow:{uniforms:_n([Be.lights,Be.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:_t.shadow_vert,fragmentShader:_t.shadow_frag}};gi.physical={uniforms:_n([gi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new et(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ct},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new et},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new et},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag};var Al={r:0,b:0,g:0},TS=new Lt,lf=new ct;lf.set(-1,0,0,0,1,0,0,0,1);function AS(i,e,t,n,s,o){let l=new ht(0),h=s===!0?0:1,f,d,m=null,y=0,g=null;function x(P){let U=P.isScene===!0?P.background:null;if(U&&U.isTexture){let I=P.backgroundBlurriness>0;U=e.get(U,I)}return U}function E(P){let U=!1,I=x(P);I===null?S(l,h):I&&I.isColor&&(S(I,1),U=!0);let O=i.xr.getEnvironmentBlendMode();O==="additive"?t.buffers.color.setClear(0,0,0,1,o):O==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,o),(i.autoClear||U)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function C(P,U){let I=x(U);I&&I.isCubeTexture?(d===void 0&&(d=new Ot(new ui(1,1,1),new di({name:"BackgroundCubeMaterial",uniforms:_r(gi.backgroundCube.uniforms),vertexShader:gi.backgroundCube.vertexShader,fragmentShader:gi.backgroundCube.fragmentShader,side:dn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),d.geometry.deleteAttribute("normal"),d.geometry.deleteAttribute("uv"),d.onBeforeRender=function(O,N,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(d.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(d)),d.material.uniforms.envMap.value=I,d.material.uniforms.backgroundBlurriness.value=U.backgroundBlurriness,d.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,d.material.uniforms.backgroundRotation.value.setFromMatrix4(TS.makeRotationFromEuler(U.backgroundRotation)).transpose(),I.isRenderTargetTexture===!1&&d.material.uniforms.backgroundRotation.value.premultiply(lf),d.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,(m!==I||y!==I.version||g!==i.toneMapping)&&(d.material.needsUpdate=!0,m=I,y=I.version,g=i.toneMapping),d.layers.enableAll(),P.unshift(d,d.geometry,d.material,0,0,null)):I&&I.isTexture&&(f===void 0&&(f=new Ot(new Vi(2,2),new di({name:"BackgroundMaterial",uniforms:_r(gi.background.uniforms),vertexShader:gi.background.vertexShader,fragmentShader:gi.background.fragmentShader,side:Yi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),f.geometry.deleteAttribute("normal"),Object.defineProperty(f.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(f)),f.material.uniforms.t2D.value=I,f.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,f.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,I.matrixAutoUpdate===!0&&I.updateMatrix(),f.material.uniforms.uvTransform.value.copy(I.matrix),(m!==I||y!==I.version||g!==i.toneMapping)&&(f.material.needsUpdate=!0,m=I,y=I.version,g=i.toneMapping),f.layers.enableAll(),P.unshift(f,f.geometry,f.material,0,0,null))}function S(P,U){P.getRGB(Al,lh(i)),t.buffers.color.setClear(Al.r,Al.g,Al.b,U,o)}function v(){d!==void 0&&(d.geometry.dispose(),d.material.dispose(),d=void 0),f!==void 0&&(f.geometry.dispose(),f.material.dispose(),f=void 0)}return{getClearColor:function(){return l},setClearColor:function(P,U=1){l.set(P),h=U,S(l,h)},getClearAlpha:function(){return h},setClearAlpha:function(P){h=P,S(l,h)},render:E,addToRenderList:C,dispose:v}}function RS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=g(null),o=s,l=!1;function h(Y,J,ee,z,ie){let G=!1,ne=y(Y,z,ee,J);o!==ne&&(o=ne,d(o.object)),G=x(Y,z,ee,ie),G&&E(Y,z,ee,ie),ie!==null&&e.update(ie,i.ELEMENT_ARRAY_BUFFER),(G||l)&&(l=!1,I(Y,J,ee,z),ie!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(ie).buffer))}function f(){return i.createVertexArray()}function d(Y){return i.bindVertexArray(Y)}function m(Y){return i.deleteVertexArray(Y)}function y(Y,J,ee,z){let ie=z.wireframe===!0,G=n[J.id];G===void 0&&(G={},n[J.id]=G);let ne=Y.isInstancedMesh===!0?Y.id:0,Se=G[ne];Se===void 0&&(Se={},G[ne]=Se);let re=Se[ee.id];re===void 0&&(re={},Se[ee.id]=re);let H=re[ie];return H===void 0&&(H=g(f()),re[ie]=H),H}function g(Y){let J=[],ee=[],z=[];for(let ie=0;ie<t;ie++)J[ie]=0,ee[ie]=0,z[ie]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:J,enabledAttributes:ee,attributeDivisors:z,object:Y,attributes:{},index:null}}function x(Y,J,ee,z){let ie=o.attributes,G=J.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=ie[re],We=G[re];if(We===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(We=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(We=Y.instanceColor)),ge===void 0||ge.attribute!==We||We&&ge.data!==We.data)return!0;ne++}return o.attributesNum!==ne||o.index!==z}function E(Y,J,ee,z){let ie={},G=J.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=G[re];ge===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(ge=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(ge=Y.instanceColor));let We={};We.attribute=ge,ge&&ge.data&&(We.data=ge.data),ie[re]=We,ne++}o.attributes=ie,o.attributesNum=ne,o.index=z}function C(){let Y=o.newAttributes;for(let J=0,ee=Y.length;J<ee;J++)Y[J]=0}function S(Y){v(Y,0)}function v(Y,J){let ee=o.newAttributes,z=o.enabledAttributes,ie=o.attributeDivisors;ee[Y]=1,z[Y]===0&&(i.enableVertexAttribArray(Y),z[Y]=1),ie[Y]!==J&&(i.vertexAttribDivisor(Y,J),ie[Y]=J)}function P(){let Y=o.newAttributes,J=o.enabledAttributes;for(let ee=0,z=J.length;ee<z;ee++)J[ee]!==Y[ee]&&(i.disableVertexAttribArray(ee),J[ee]=0)}function U(Y,J,ee,z,ie,G,ne){ne===!0?i.vertexAttribIPointer(Y,J,ee,ie,G):i.vertexAttribPointer(Y,J,ee,z,ie,G)}function I(Y,J,ee,z){C();let ie=z.attributes,G=ee.getAttributes(),ne=J.defaultAttributeValues;for(let Se in G){let re=G[Se];if(re.location>=0){let H=ie[Se];if(H===void 0&&(Se==="instanceMatrix"&&Y.instanceMatrix&&(H=Y.instanceMatrix),Se==="instanceColor"&&Y.instanceColor&&(H=Y.instanceColor)),H!==void 0){let ge=H.normalized,We=H.itemSize,rt=e.get(H);if(rt===void 0)continue;let ue=rt.buffer,Fe=rt.type,Pe=rt.bytesPerElement,je=Fe===i.INT||Fe===i.UNSIGNED_INT||H.gpuType===Wo;if(H.isInterleavedBufferAttribute){let Ue=H.data,ot=Ue.isInterleavedBuffer===!0?Ue.stride:Ue.itemSize,Vt=H.offset;if(Ue.isInstancedInterleavedBuffer||Ue.isInstancedBufferAttribute){for(let Ke=0;Ke<re.locationSize;Ke++)v(re.location+Ke,Ue.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=Ue.meshPerAttribute*Ue.count)}else for(let Ke=0;Ke<re.locationSize;Ke++)S(re.location+Ke);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Ke=0;Ke<re.locationSize;Ke++)U(re.location+Ke,We/re.locationSize,Fe,ge,ot*Pe,(Vt+We/re.locationSize*Ke)*Pe,je)}else{if(H.isInstancedBufferAttribute){for(let Ue=0;Ue<re.locationSize;Ue++)v(re.location+Ue,H.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=H.meshPerAttribute*H.count)}else for(let Ue=0;Ue<re.locationSize;Ue++)S(re.location+Ue);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Ue=0;Ue<re.locationSize;Ue++)U(re.location+Ue,We/re.locationSize,Fe,ge,We*Pe,We/re.locationSize*Ue*Pe,je)}}else if(ne!==void 0){let ge=ne[Se];if(ge!==void 0)switch(ge.length){case 2:i.vertexAttrib2fv(re.location,ge);break;case 3:i.vertexAttrib3fv(re.location,ge);break;case 4:i.vertexAttrib4fv(re.location,ge);break;default:i.vertexAttrib1fv(re.location,ge)}}}}P()}function O(){q();for(let Y in n){let J=n[Y];for(let ee in J){let z=J[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y]}}function N(Y){if(n[Y.id]===void 0)return;let J=n[Y.id];for(let ee in J){let z=J[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y.id]}function b(Y){for(let J in n){let ee=n[J];for(let z in ee){let ie=ee[z];if(ie[Y.id]===void 0)continue;let G=ie[Y.id];for(let ne in G)m(G[ne].object),delete G[ne];delete ie[Y.id]}}}function D(Y){for(let J in n){let ee=n[J],z=Y.isInstancedMesh===!0?Y.id:0,ie=ee[z];if(ie!==void 0){for(let G in ie){let ne=ie[G];for(let Se in ne)m(ne[Se].object),delete ne[Se];delete ie[G]}delete ee[z],Object.keys(ee).length===0&&delete n[J]}}}function q(){k(),l=!0,o!==s&&(o=s,d(o.object))}function k(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:h,reset:q,resetDefaultState:k,dispose:O,releaseStatesOfGeometry:N,releaseStatesOfObject:D,releaseStatesOfProgram:b,initAttributes:C,enableAttribute:S,disableUnusedAttributes:P}}function CS(i,e,t){let n;function s(f){n=f}function o(f,d){i.drawArrays(n,f,d),t.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawArraysInstanced(n,f,d,m),t.update(d,n,m))}function h(f,d,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,f,0,d,0,m);let g=0;for(let x=0;x<m;x++)g+=d[x];t.update(g,n,1)}this.setMode=s,this.render=o,this.renderInstances=l,this.renderMultiDraw=h}function PS(i,e,t,n){let s;function o(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let b=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function l(b){return!(b!==Kn&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function h(b){let D=b===Jn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(b!==Tn&&b!==zn&&!D&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function f(b){if(b==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let d=t.precision!==void 0?t.precision:"highp",m=f(d);m!==d&&(Qe("WebGLRenderer:",d,"not supported, using",m,"instead."),d=m);let y=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),g=t.logarithmicDepthBuffer===!0&&y===!1;t.reversedDepthBuffer===!0&&y===!1&&Qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&y===!0&&Qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let x=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),E=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),C=i.getParameter(i.MAX_TEXTURE_SIZE),S=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),v=i.getParameter(i.MAX_VERTEX_ATTRIBS),P=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),U=i.getParameter(i.MAX_VARYING_VECTORS),I=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),O=i.getParameter(i.MAX_SAMPLES),N=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:o,getMaxPrecision:f,textureFormatReadable:l,textureTypeReadable:h,precision:d,logarithmicDepthBuffer:g,reversedDepthBuffer:y,maxTextures:x,maxVertexTextures:E,maxTextureSize:C,maxCubemapSize:S,maxAttributes:v,maxVertexUniforms:P,maxVaryings:U,maxFragmentUniforms:I,maxSamples:O,samples:N}}function IS(i){let e=this,t=null,n=0,s=!1,o=!1,l=new In,h=new ct,f={value:null,needsUpdate:!1};this.uniform=f,this.numPlanes=0,this.numIntersection=0,this.init=function(y,g){let x=y.length!==0||g||n!==0||s;return s=g,n=y.length,x},this.beginShadows=function(){o=!0,m(null)},this.endShadows=function(){o=!1},this.setGlobalState=function(y,g){t=m(y,g,0)},this.setState=function(y,g,x){let E=y.clippingPlanes,C=y.clipIntersection,S=y.clipShadows,v=i.get(y);if(!s||E===null||E.length===0||o&&!S)o?m(null):d();else{let P=o?0:n,U=P*4,I=v.clippingState||null;f.value=I,I=m(E,g,U,x);for(let O=0;O!==U;++O)I[O]=t[O];v.clippingState=I,this.numIntersection=C?this.numPlanes:0,this.numPlanes+=P}};function d(){f.value!==t&&(f.value=t,f.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function m(y,g,x,E){let C=y!==null?y.length:0,S=null;if(C!==0){if(S=f.value,E!==!0||S===null){let v=x+C*4,P=g.matrixWorldInverse;h.getNormalMatrix(P),(S===null||S.length<v)&&(S=new Float32Array(v));for(let U=0,I=x;U!==C;++U,I+=4)l.copy(y[U]).applyMatrix4(P,h),l.normal.toArray(S,I),S[I+3]=l.constant}f.value=S,f.needsUpdate=!0}return e.numPlanes=C,e.numIntersection=0,S}}var oa=class extends Dn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Fs(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ui(5,5,5),o=new di({name:"CubemapFromEquirect",uniforms:_r(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:dn,blending:fr});o.uniforms.tEquirect.value=t;let l=new Ot(s,o),h=t.minFilter;return t.minFilter===Ci&&(t.minFilter=Sn),new qr(1,10,this).update(e,l),t.minFilter=h,l.geometry.dispose(),l.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let o=e.getRenderTarget();for(let l=0;l<6;l++)e.setRenderTarget(this,l),e.clear(t,n,s);e.setRenderTarget(o)}},kd=256,DS=3,LS=20,cf=256,hf=16,FS=3,NS=new j,US=new ht,ts=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new qr(1,10,null),this._boxMesh=new Ot(new ui(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,o={}){let{size:l=256,position:h=NS}=o,f=this._renderer;this._setSize(l);let d=this._allocateTarget(),m=this._getSourceTarget(!0);t>0&&(m.texture.mipmapsAutoUpdate=!1);let y=f.autoClear,g=f.autoClearColor,x=f.autoClearDepth,E=f.autoClearStencil,C=e.background;f.autoClear=!0,f.autoClearColor=!0,f.autoClearDepth=!0,f.autoClearStencil=!0,C===null&&(e.background=f.getClearColor(US));let S=new qr(n,s,m);return S.position.copy(h),S.update(f,e),f.autoClear=y,f.autoClearColor=g,f.autoClearDepth=x,f.autoClearStencil=E,e.background=C,t>0&&(m.texture.mipmapsAutoUpdate=!0,this._blur(d,t)),this._applyPMREM(d),d}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Vd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Gd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(kd,sh(e))}_fromTexture(e,t){e.mapping===mr||e.mapping===Jr?this._setSize(e.image.length===0?kd:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=zd(e,!1,!1),n=Math.log2(e)-DS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=zd(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,o=this._cubeCamera;s.material=n,o.renderTarget=e,o.activeMipmapLevel=t;let l=e.width>>t;e.viewport.set(0,0,l,l),o.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===mr||e.mapping===Jr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Vd()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Gd()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=OS(),this._integrationMaterial=BS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let o=this._integrationMaterial.uniforms;o.envMap.value=this._sourceTarget.texture,o.sourceLod.value=Math.log2(t/hf);for(let l=0;l<=n;l++){let h=i.lodToRoughness(l,n);if(l>n-FS)o.roughness.value=h,this._renderCube(e,l,this._integrationMaterial);else{let f=h>0?Math.log2(t)+.5*Math.log2(6/(cf*Math.pow(h,4)))+.5:0;s.roughness.value=h,s.lodBias.value=f,this._renderCube(e,l,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=kS());let n=this._blurMaterial,s=n.uniforms,o=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=o.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(o,0,n)}};function zd(i,e,t){return new oa(i,{minFilter:Ci,generateMipmaps:e,type:Jn,colorSpace:Ms,depthBuffer:t})}function la(i,e,t){return new di({name:i,uniforms:e,vertexShader:_t.cube_vert,fragmentShader:t,side:dn,blending:fr,depthTest:!1,depthWrite:!1})}function OS(){return la("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${cf}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function BS(){return la("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:hf}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function kS(){return la("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${LS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Gd(){return la("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Vd(){return la("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function zS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(g,x=!1){return g==null?null:x?l(g):o(g)}function o(g){if(g&&g.isTexture){let x=g.mapping;if(x===Go||x===Vo)if(e.has(g)){let E=e.get(g).texture;return h(E,g.mapping)}else{let E=g.image;if(E&&E.height>0){let C=new oa(E.height);return C.fromEquirectangularTexture(i,g),e.set(g,C),g.addEventListener("dispose",d),h(C.texture,g.mapping)}else return null}}return g}function l(g){if(g&&g.isTexture&&g.isPMREMTexture!==!0){let x=g.mapping,E=x===Go||x===Vo,C=x===mr||x===Jr;if(E||C){let S=t.get(g),v=S!==void 0?S.texture.pmremVersion:0;if(g.isRenderTargetTexture&&g.pmremVersion!==v)return n===null&&(n=new ts(i)),S=E?n.fromEquirectangular(g,S):n.fromCubemap(g,S),S.texture.pmremVersion=g.pmremVersion,t.set(g,S),S.texture;if(S!==void 0)return S.texture;{let P=g.image;return E&&P&&P.height>0||C&&P&&f(P)?(n===null&&(n=new ts(i)),S=E?n.fromEquirectangular(g):n.fromCubemap(g),S.texture.pmremVersion=g.pmremVersion,t.set(g,S),g.addEventListener("dispose",m),S.texture):null}}}return g}function h(g,x){return x===Go?g.mapping=mr:x===Vo&&(g.mapping=Jr),g}function f(g){let x=0,E=6;for(let C=0;C<E;C++)g[C]!==void 0&&x++;return x===E}function d(g){let x=g.target;x.removeEventListener("dispose",d);let E=e.get(x);E!==void 0&&(e.delete(x),E.dispose())}function m(g){let x=g.target;x.removeEventListener("dispose",m);let E=t.get(x);E!==void 0&&(t.delete(x),E.dispose())}function y(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:y}}function GS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&vs("WebGLRenderer: "+n+" extension not supported."),s}}}function VS(i,e,t,n){let s={},o=new WeakMap,l=new FinalizationRegistry(E=>delete s[E]);function h(E){f(E.target)}function f(E){E.index!==null&&e.remove(E.index);for(let S in E.attributes)e.remove(E.attributes[S]);E.removeEventListener("dispose",h),delete s[E.id],l.unregister(E);let C=o.get(E);C&&(e.remove(C),o.delete(E)),n.releaseStatesOfGeometry(E),E.isInstancedBufferGeometry===!0&&delete E._maxInstanceCount,t.memory.geometries--}function d(E,C){return s[C.id]!==void 0||(C.addEventListener("dispose",h),s[C.id]=new WeakRef(C),l.register(C,C.id,C),t.memory.geometries++),C}function m(E){let C=E.attributes;for(let S in C)e.update(C[S],i.ARRAY_BUFFER)}function y(E){let C=E.index,S=E.attributes.position,v=0;if(S===void 0)return;let P=C!==null?C.array.length:S.array.length/3-1,U=S.count>=65535?Rs:As,I=new U(Math.ceil(P/3)*6,1),O=I.array;if(C!==null){let b=C.array;v=C.version;for(let D=0,q=0;D<P;D+=3){let k=b[D+0],Y=b[D+1],J=b[D+2];O[q++]=k,O[q++]=Y,O[q++]=Y,O[q++]=J,O[q++]=J,O[q++]=k}}else{v=S.version;for(let b=0,D=0;b<P;b+=3){let q=b+0,k=b+1,Y=b+2;O[D++]=q,O[D++]=k,O[D++]=k,O[D++]=Y,O[D++]=Y,O[D++]=q}}I.version=v;let N=o.get(E);N&&e.remove(N),o.set(E,I)}function g(E){let C=o.get(E);if(C){let S=E.index;S!==null&&C.version<S.version&&y(E)}else y(E);return o.get(E)}function x(){for(let E in s){let C=s[E].deref();C!==void 0&&f(C)}}return{get:d,update:m,getWireframeAttribute:g,dispose:x}}function HS(i,e,t){let n;function s(y){n=y}let o,l;function h(y){o=y.type,l=y.bytesPerElement}function f(y,g){i.drawElements(n,g,o,y*l),t.update(g,n,1)}function d(y,g,x){x!==0&&(i.drawElementsInstanced(n,g,o,y*l,x),t.update(g,n,x))}function m(y,g,x){if(x===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,g,0,o,y,0,x);let C=0;for(let S=0;S<x;S++)C+=g[S];t.update(C,n,1)}this.setMode=s,this.setIndex=h,this.render=f,this.renderInstances=d,this.renderMultiDraw=m}function WS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(o,l,h){switch(t.calls++,l){case i.TRIANGLES:t.triangles+=h*(o/3);break;case i.LINES:t.lines+=h*(o/2);break;case i.LINE_STRIP:t.lines+=h*(o-1);break;case i.LINE_LOOP:t.lines+=h*o;break;case i.POINTS:t.points+=h*o;break;default:it("WebGLInfo: Unknown draw mode:",l);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function XS(i,e,t){let n=new WeakMap,s=new Gt;function o(l,h,f){let d=l.morphTargetInfluences,m=h.morphAttributes.position||h.morphAttributes.normal||h.morphAttributes.color,y=m!==void 0?m.length:0,g=n.get(h);if(g===void 0||g.count!==y){let q=function(){b.dispose(),n.delete(h),h.removeEventListener("dispose",q)};g!==void 0&&g.texture.dispose();let x=h.morphAttributes.position!==void 0,E=h.morphAttributes.normal!==void 0,C=h.morphAttributes.color!==void 0,S=h.morphAttributes.position||[],v=h.morphAttributes.normal||[],P=h.morphAttributes.color||[],U=0;x===!0&&(U=1),E===!0&&(U=2),C===!0&&(U=3);let I=h.attributes.position.count*U,O=1;I>e.maxTextureSize&&(O=Math.ceil(I/e.maxTextureSize),I=e.maxTextureSize);let N=new Float32Array(I*O*4*y),b=new Es(N,I,O,y);b.type=zn,b.needsUpdate=!0;let D=U*4;for(let k=0;k<y;k++){let Y=S[k],J=v[k],ee=P[k],z=I*O*4*k;for(let ie=0;ie<Y.count;ie++){let G=ie*D;x===!0&&(s.fromBufferAttribute(Y,ie),N[z+G+0]=s.x,N[z+G+1]=s.y,N[z+G+2]=s.z,N[z+G+3]=0),E===!0&&(s.fromBufferAttribute(J,ie),N[z+G+4]=s.x,N[z+G+5]=s.y,N[z+G+6]=s.z,N[z+G+7]=0),C===!0&&(s.fromBufferAttribute(ee,ie),N[z+G+8]=s.x,N[z+G+9]=s.y,N[z+G+10]=s.z,N[z+G+11]=ee.itemSize===4?s.w:1)}}g={count:y,texture:b,size:new et(I,O)},n.set(h,g),h.addEventListener("dispose",q)}if(l.isInstancedMesh===!0&&l.morphTexture!==null)f.getUniforms().setValue(i,"morphTexture",l.morphTexture,t);else{let x=0;for(let C=0;C<d.length;C++)x+=d[C];let E=h.morphTargetsRelative?1:1-x;f.getUniforms().setValue(i,"morphTargetBaseInfluence",E),f.getUniforms().setValue(i,"morphTargetInfluences",d)}f.getUniforms().setValue(i,"morphTargetsTexture",g.texture,t),f.getUniforms().setValue(i,"morphTargetsTextureSize",g.size)}return{update:o}}function $S(i,e,t,n,s){let o=new WeakMap;function l(d){let m=s.render.frame,y=d.geometry,g=e.get(d,y);if(o.get(g)!==m&&(e.update(g),o.set(g,m)),d.isInstancedMesh&&(d.hasEventListener("dispose",f)===!1&&d.addEventListener("dispose",f),o.get(d)!==m&&(t.update(d.instanceMatrix,i.ARRAY_BUFFER),d.instanceColor!==null&&t.update(d.instanceColor,i.ARRAY_BUFFER),o.set(d,m))),d.isSkinnedMesh){let x=d.skeleton;o.get(x)!==m&&(x.update(),o.set(x,m))}return g}function h(){o=new WeakMap}function f(d){let m=d.target;m.removeEventListener("dispose",f),n.releaseStatesOfObject(m),t.remove(m.instanceMatrix),m.instanceColor!==null&&t.remove(m.instanceColor)}return{update:l,dispose:h}}var qS={[zc]:"LINEAR_TONE_MAPPING",[Gc]:"REINHARD_TONE_MAPPING",[Vc]:"CINEON_TONE_MAPPING",[Hc]:"ACES_FILMIC_TONE_MAPPING",[Xc]:"AGX_TONE_MAPPING",[Zs]:"NEUTRAL_TONE_MAPPING",[Wc]:"CUSTOM_TONE_MAPPING"};function YS(i,e,t,n,s,o){let l=new Dn(e,t,{type:i,depthBuffer:s,stencilBuffer:o,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),h=null,f=null,d=null,m=new wn;m.setAttribute("position",new Xt([-1,3,0,-1,-1,0,3,-1,0],3)),m.setAttribute("uv",new Xt([0,2,0,0,2,0],2));let y=new To({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),g=new Ot(m,y),x=new Xs(-1,1,1,-1,0,1),E=null,C=null,S=!1,v,P=null,U=[],I=!1;this.setSize=function(O,N){l.setSize(O,N),h!==null&&h.setSize(O,N),f!==null&&f.setSize(O,N);for(let b=0;b<U.length;b++){let D=U[b];D.setSize&&D.setSize(O,N)}},this.setEffects=function(O){U=O,I=U.length>0&&U[0].isRenderPass===!0;let N=l.width,b=l.height;U.length>0&&h===null&&(h=new Dn(N,b,{type:Jn,depthBuffer:!1,stencilBuffer:!1}),f=new Dn(N,b,{type:Jn,depthBuffer:!1,stencilBuffer:!1}));let D=s===!0&&U.some(q=>q.needsDepthTexture===!0);D!==(l.depthTexture!==null)&&(D===!0&&d===null&&(d=new Ai(N,b),o===!0&&(d.format=Pi,d.type=gr)),l.dispose(),l.depthTexture=D?d:null,l.resolveDepthBuffer=D,l.storeMultisampledDepthBuffer=D);for(let q=0;q<U.length;q++){let k=U[q];k.setSize&&k.setSize(N,b),D&&k.needsDepthTexture===!0&&k.setDepthTexture&&k.setDepthTexture(d)}},this.begin=function(O,N){if(S||O.toneMapping===pi&&U.length===0)return!1;if(P=N,N!==null){let b=N.width,D=N.height;(l.width!==b||l.height!==D)&&this.setSize(b,D)}return I===!1&&O.setRenderTarget(l),v=O.toneMapping,O.toneMapping=pi,!0},this.hasRenderPass=function(){return I},this.end=function(O,N){O.toneMapping=v,S=!0;let b=l,D=h;for(let q=0;q<U.length;q++){let k=U[q];k.enabled!==!1&&(k.render(O,D,b,N),k.needsSwap!==!1&&(b=D,D=D===h?f:h))}if(E!==O.outputColorSpace||C!==O.toneMapping){E=O.outputColorSpace,C=O.toneMapping,y.defines={},St.getTransfer(E)===Pt&&(y.defines.SRGB_TRANSFER="");let q=qS[C];q&&(y.defines[q]=""),y.needsUpdate=!0}y.uniforms.tDiffuse.value=b.texture,O.setRenderTarget(P),O.render(g,x),P=null,S=!1},this.isCompositing=function(){return S},this.dispose=function(){l.dispose(),h!==null&&h.dispose(),f!==null&&f.dispose(),m.dispose(),y.dispose()}}var uf=new bn,df=new Ai(1,1),ff=new Us(1),pf=new Es,mf=new xo,gf=new Fs,Hd=[],Wd=[],Xd=new Float32Array(16),$d=new Float32Array(9),qd=new Float32Array(4);function ns(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,o=Hd[s];if(o===void 0&&(o=new Float32Array(s),Hd[s]=o),e!==0){n.toArray(o,0);for(let l=1,h=0;l!==e;++l)h+=t,i[l].toArray(o,h)}return o}function en(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Pl(i,e){let t=Wd[e];t===void 0&&(t=new Int32Array(e),Wd[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function jS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function ZS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2fv(this.addr,e),tn(t,e)}}function JS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(en(t,e))return;i.uniform3fv(this.addr,e),tn(t,e)}}function KS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4fv(this.addr,e),tn(t,e)}}function QS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;qd.set(n),i.uniformMatrix2fv(this.addr,!1,qd),tn(t,n)}}function eM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;$d.set(n),i.uniformMatrix3fv(this.addr,!1,$d),tn(t,n)}}function tM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Xd.set(n),i.uniformMatrix4fv(this.addr,!1,Xd),tn(t,n)}}function nM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function iM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2iv(this.addr,e),tn(t,e)}}function rM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3iv(this.addr,e),tn(t,e)}}function sM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4iv(this.addr,e),tn(t,e)}}function aM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function oM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2uiv(this.addr,e),tn(t,e)}}function lM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3uiv(this.addr,e),tn(t,e)}}function cM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4uiv(this.addr,e),tn(t,e)}}function Il(i){return i.version===0&&(i.compareFunction=th,i.needsUpdate=!0),i}function hM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_2D_SHADOW?o=Il(df):o=uf,t.setTexture2D(e||o,s)}function uM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||mf,s)}function dM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Il(ff):o=gf,t.setTextureCube(e||o,s)}function fM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||pf,s)}function pM(i){switch(i){case 5126:return jS;case 35664:return ZS;case 35665:return JS;case 35666:return KS;case 35674:return QS;case 35675:return eM;case 35676:return tM;case 5124:case 35670:return nM;case 35667:case 35671:return iM;case 35668:case 35672:return rM;case 35669:case 35673:return sM;case 5125:return aM;case 36294:return oM;case 36295:return lM;case 36296:return cM;case 35678:case 36198:case 36298:case 36306:case 35682:return hM;case 35679:case 36299:case 36307:return uM;case 35680:case 36300:case 36308:case 36293:return dM;case 36289:case 36303:case 36311:case 36292:return fM}}function mM(i,e){i.uniform1fv(this.addr,e)}function gM(i,e){let t=ns(e,this.size,2);i.uniform2fv(this.addr,t)}function _M(i,e){let t=ns(e,this.size,3);i.uniform3fv(this.addr,t)}function vM(i,e){let t=ns(e,this.size,4);i.uniform4fv(this.addr,t)}function yM(i,e){let t=ns(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function xM(i,e){let t=ns(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function SM(i,e){let t=ns(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function MM(i,e){i.uniform1iv(this.addr,e)}function bM(i,e){i.uniform2iv(this.addr,e)}function wM(i,e){i.uniform3iv(this.addr,e)}function EM(i,e){i.uniform4iv(this.addr,e)}function TM(i,e){i.uniform1uiv(this.addr,e)}function AM(i,e){i.uniform2uiv(this.addr,e)}function RM(i,e){i.uniform3uiv(this.addr,e)}function CM(i,e){i.uniform4uiv(this.addr,e)}function PM(i,e,t){let n=this.cache,s=e.length,o=Pl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));let l;this.type===i.SAMPLER_2D_SHADOW?l=Il(df):l=uf;for(let h=0;h!==s;++h)t.setTexture2D(e[h]||l,o[h])}function IM(i,e,t){let n=this.cache,s=e.length,o=Pl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let l=0;l!==s;++l)t.setTexture3D(e[l]||mf,o[l])}function DM(i,e,t){let n=this.cache,s=e.length,o=Pl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));let l;this.type===i.SAMPLER_CUBE_SHADOW?l=Il(ff):l=gf;for(let h=0;h!==s;++h)t.setTextureCube(e[h]||l,o[h])}function LM(i,e,t){let n=this.cache,s=e.length,o=Pl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let l=0;l!==s;++l)t.setTexture2DArray(e[l]||pf,o[l])}function FM(i){switch(i){case 5126:return mM;case 35664:return gM;case 35665:return _M;case 35666:return vM;case 35674:return yM;case 35675:return xM;case 35676:return SM;case 5124:case 35670:return MM;case 35667:case 35671:return bM;case 35668:case 35672:return wM;case 35669:case 35673:return EM;case 5125:return TM;case 36294:return AM;case 36295:return RM;case 36296:return CM;case 35678:case 36198:case 36298:case 36306:case 35682:return PM;case 35679:case 36299:case 36307:return IM;case 35680:case 36300:case 36308:case 36293:return DM;case 36289:case 36303:case 36311:case 36292:return LM}}var ph=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=pM(t.type)}},mh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=FM(t.type)}},gh=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let o=0,l=s.length;o!==l;++o){let h=s[o];h.setValue(e,t[h.id],n)}}},dh=/(\w+)(\])?(\[|\.)?/g;function Yd(i,e){i.seq.push(e),i.map[e.id]=e}function NM(i,e,t){let n=i.name,s=n.length;for(dh.lastIndex=0;;){let o=dh.exec(n),l=dh.lastIndex,h=o[1],f=o[2]==="]",d=o[3];if(f&&(h=h|0),d===void 0||d==="["&&l+2===s){Yd(t,d===void 0?new ph(h,i,e):new mh(h,i,e));break}else{let y=t.map[h];y===void 0&&(y=new gh(h),Yd(t,y)),t=y}}}var es=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let l=0;l<n;++l){let h=e.getActiveUniform(t,l),f=e.getUniformLocation(t,h.name);NM(h,f,this)}let s=[],o=[];for(let l of this.seq)l.type===e.SAMPLER_2D_SHADOW||l.type===e.SAMPLER_CUBE_SHADOW||l.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(l):o.push(l);s.length>0&&(this.seq=s.concat(o))}setValue(e,t,n,s){let o=this.map[t];o!==void 0&&o.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let o=0,l=t.length;o!==l;++o){let h=t[o],f=n[h.id];f.needsUpdate!==!1&&h.setValue(e,f.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,o=e.length;s!==o;++s){let l=e[s];l.id in t&&n.push(l)}return n}};function jd(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var UM=37297,OM=0;function BM(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),o=Math.min(e+6,t.length);for(let l=s;l<o;l++){let h=l+1;n.push(`${h===e?">":" "} ${h}: ${t[l]}`)}return n.join(`
`)}var Zd=new ct;function kM(i){St._getMatrix(Zd,St.workingColorSpace,i);let e=`mat3( ${Zd.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case bs:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Jd(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),o=(i.getShaderInfoLog(e)||"").trim();if(n&&o==="")return"";let l=/ERROR: 0:(\d+)/.exec(o);if(l){let h=parseInt(l[1]);return t.toUpperCase()+`

`+o+`

`+BM(i.getShaderSource(e),h)}else return o}function zM(i,e){let t=kM(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var GM={[zc]:"Linear",[Gc]:"Reinhard",[Vc]:"Cineon",[Hc]:"ACESFilmic",[Xc]:"AgX",[Zs]:"Neutral",[Wc]:"Custom"};function VM(i,e){let t=GM[e];return t===void 0?(Qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Rl=new j;function HM(){St.getLuminanceCoefficients(Rl);let i=Rl.x.toFixed(4),e=Rl.y.toFixed(4),t=Rl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function WM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(aa).join(`
`)}function XM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function $M(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let o=i.getActiveAttrib(e,s),l=o.name,h=1;o.type===i.FLOAT_MAT2&&(h=2),o.type===i.FLOAT_MAT3&&(h=3),o.type===i.FLOAT_MAT4&&(h=4),t[l]={type:o.type,location:i.getAttribLocation(e,l),locationSize:h}}return t}function aa(i){return i!==""}function Kd(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Qd(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var qM=/^[ \t]*#include +<([\w\d./]+)>/gm;function _h(i){return i.replace(qM,YM)}function YM(i,e){let t=_t[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return _h(t)}var jM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function ef(i){return i.replace(jM,ZM)}function ZM(i,e,t,n){let s="";for(let o=parseInt(e);o<parseInt(t);o++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+o+" ]").replace(/UNROLLED_LOOP_INDEX/g,o);return s}function tf(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var JM={[dr]:"SHADOWMAP_TYPE_PCF",[jr]:"SHADOWMAP_TYPE_VSM"};function KM(i){return JM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var QM={[Jr]:"ENVMAP_MODE_REFRACTION"};function eb(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":QM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var tb={[zo]:"ENVMAP_BLENDING_MULTIPLY",[_d]:"ENVMAP_BLENDING_MIX",[vd]:"ENVMAP_BLENDING_ADD"};function nb(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":tb[i.combine]||"ENVMAP_BLENDING_NONE"}function ib(i,e,t,n){let s=i.getContext(),o=t.defines,l=t.vertexShader,h=t.fragmentShader,f=KM(t),d=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",m=eb(t),y=nb(t),g=WM(t),x=XM(o),E=s.createProgram(),C,S,v=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(C=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x].filter(aa).join(`
`),C.length>0&&(C+=`
`),S=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x].filter(aa).join(`
`),S.length>0&&(S+=`
`)):(C=[tf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+m:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(aa).join(`
`),S=[tf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+d:"",t.envMap?"#define "+m:"",t.envMap?"#define "+y:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==pi?"#define TONE_MAPPING":"",t.toneMapping!==pi?_t.tonemapping_pars_fragment:"",t.toneMapping!==pi?VM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",_t.colorspace_pars_fragment,zM("linearToOutputTexel",t.outputColorSpace),HM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(aa).join(`
`)),l=_h(l),l=Kd(l,t),l=Qd(l,t),h=_h(h),h=Kd(h,t),h=Qd(h,t),l=ef(l),h=ef(h),t.isRawShaderMaterial!==!0&&(v=`#version 300 es
`,C=[g,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+C,S=["#define varying in",t.glslVersion===nh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===nh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+S);let P=v+C+l,U=v+S+h,I=jd(s,s.VERTEX_SHADER,P),O=jd(s,s.FRAGMENT_SHADER,U);s.attachShader(E,I),s.attachShader(E,O),t.index0AttributeName!==void 0?s.bindAttribLocation(E,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(E,0,"position"),s.linkProgram(E);function N(k){if(i.debug.checkShaderErrors){let Y=s.getProgramInfoLog(E)||"",J=s.getShaderInfoLog(I)||"",ee=s.getShaderInfoLog(O)||"",z=Y.trim(),ie=J.trim(),G=ee.trim(),ne=!0,Se=!0;if(s.getProgramParameter(E,s.LINK_STATUS)===!1)if(ne=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,E,I,O);else{let re=Jd(s,I,"vertex"),H=Jd(s,O,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(E,s.VALIDATE_STATUS)+`

Material Name: `+k.name+`
Material Type: `+k.type+`

Program Info Log: `+z+`
`+re+`
`+H)}else z!==""?Qe("WebGLProgram: Program Info Log:",z):(ie===""||G==="")&&(Se=!1);Se&&(k.diagnostics={runnable:ne,programLog:z,vertexShader:{log:ie,prefix:C},fragmentShader:{log:G,prefix:S}})}s.deleteShader(I),s.deleteShader(O),b=new es(s,E),D=$M(s,E)}let b;this.getUniforms=function(){return b===void 0&&N(this),b};let D;this.getAttributes=function(){return D===void 0&&N(this),D};let q=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return q===!1&&(q=s.getProgramParameter(E,UM)),q},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(E),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=OM++,this.cacheKey=e,this.usedTimes=1,this.program=E,this.vertexShader=I,this.fragmentShader=O,this}var rb=0,vh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new yh(e),t.set(e,n)),n}},yh=class{constructor(e){this.id=rb++,this.code=e,this.usedTimes=0}};function sb(i){return i===ji||i===na||i===ia}function ab(i,e,t,n,s,o){let l=new Wr,h=new vh,f=new Set,d=[],m=new Map,y=n.logarithmicDepthBuffer,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(b){return f.add(b),b===0?"uv":`uv${b}`}function E(b,D,q,k,Y,J){let ee=k.fog,z=Y.geometry,ie=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?k.environment:null,G=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,ne=e.get(b.envMap||ie,G),Se=g[b.type],re=n.precision;b.precision!==null&&(re=n.getMaxPrecision(b.precision),re!==b.precision&&Qe("WebGLProgram.getParameters:",b.precision,"not supported, using",re,"instead."));let H=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,ge=H!==void 0?H.length:0,We=0;z.morphAttributes.position!==void 0&&(We=1),z.morphAttributes.normal!==void 0&&(We=2),z.morphAttributes.color!==void 0&&(We=3);let rt,ue,Fe,Pe;if(Se){let Oe=gi[Se];rt=Oe.vertexShader,ue=Oe.fragmentShader}else{rt=b.vertexShader,ue=b.fragmentShader;let Oe=h.getVertexShaderStage(b),Tt=h.getFragmentShaderStage(b);h.update(b,Oe,Tt),Fe=Oe.id,Pe=Tt.id}let je=i.getRenderTarget(),Ue=i.state.buffers.depth.getReversed(),ot=Y.isInstancedMesh===!0,Vt=Y.isBatchedMesh===!0,Ke=!!b.map,Et=!!b.matcap,Rt=!!ne,mt=Rt&&ne.isPMREMTexture===!0,Ht=!!b.aoMap,pt=!!b.lightMap,It=!!b.bumpMap&&b.wireframe===!1,Mt=!!b.normalMap,rn=!!b.displacementMap,De=!!b.emissiveMap,$e=!!b.metalnessMap,hn=!!b.roughnessMap,sn=b.anisotropy>0,W=b.clearcoat>0,vn=b.diffuseRoughness>0,Ct=b.dispersion>0,Ut=b.retroreflectivity>0,Le=b.iridescence>0,$t=b.sheen>0,Ze=b.transmission>0,Je=sn&&!!b.anisotropyMap,L=W&&!!b.clearcoatMap,T=W&&!!b.clearcoatNormalMap,Z=W&&!!b.clearcoatRoughnessMap,ve=vn&&!!b.diffuseRoughnessMap,de=Le&&!!b.iridescenceMap,pe=Le&&!!b.iridescenceThicknessMap,Me=$t&&!!b.sheenColorMap,ae=$t&&!!b.sheenRoughnessMap,le=!!b.specularMap,Re=!!b.specularColorMap,B=!!b.specularIntensityMap,he=Ze&&!!b.transmissionMap,se=Ze&&!!b.thicknessMap,Ce=!!b.gradientMap,Ee=!!b.alphaMap,Ae=b.alphaTest>0,Xe=!!b.alphaHash,ut=!!b.extensions,we=pi;b.toneMapped&&(je===null||je.isXRRenderTarget===!0)&&(we=i.toneMapping);let qe=mt?ne.isCompressedCubeTexture?ne.image[0].mipmaps:ne.mipmaps:null,dt={shaderID:Se,shaderType:b.type,shaderName:b.name,vertexShader:rt,fragmentShader:ue,defines:b.defines,customVertexShaderID:Fe,customFragmentShaderID:Pe,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:re,batching:Vt,batchingColor:Vt&&Y._colorsTexture!==null,instancing:ot,instancingColor:ot&&Y.instanceColor!==null,instancingMorph:ot&&Y.morphTexture!==null,outputColorSpace:je===null?i.outputColorSpace:je.isXRRenderTarget===!0?je.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:Ke,matcap:Et,envMap:Rt,envMapMode:Rt&&ne.mapping,envMapPMREM:mt,envMapMaxLod:mt?qe.length-1:null,envMapSize:mt?qe[0].width:null,aoMap:Ht,lightMap:pt,bumpMap:It,normalMap:Mt,displacementMap:rn,emissiveMap:De,normalMapObjectSpace:Mt&&b.normalMapType===Sd,normalMapTangentSpace:Mt&&b.normalMapType===ra,packedNormalMap:Mt&&b.normalMapType===ra&&sb(b.normalMap.format),metalnessMap:$e,roughnessMap:hn,anisotropy:sn,anisotropyMap:Je,clearcoat:W,clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:Z,diffuseRoughness:vn,diffuseRoughnessMap:ve,dispersion:Ct,retroreflection:Ut,iridescence:Le,iridescenceMap:de,iridescenceThicknessMap:pe,sheen:$t,sheenColorMap:Me,sheenRoughnessMap:ae,specularMap:le,specularColorMap:Re,specularIntensityMap:B,transmission:Ze,transmissionMap:he,thicknessMap:se,gradientMap:Ce,opaque:b.transparent===!1&&b.blending===Zr&&b.alphaToCoverage===!1,alphaMap:Ee,alphaTest:Ae,alphaHash:Xe,combine:b.combine,mapUv:Ke&&x(b.map.channel),aoMapUv:Ht&&x(b.aoMap.channel),lightMapUv:pt&&x(b.lightMap.channel),bumpMapUv:It&&x(b.bumpMap.channel),normalMapUv:Mt&&x(b.normalMap.channel),displacementMapUv:rn&&x(b.displacementMap.channel),emissiveMapUv:De&&x(b.emissiveMap.channel),metalnessMapUv:$e&&x(b.metalnessMap.channel),roughnessMapUv:hn&&x(b.roughnessMap.channel),anisotropyMapUv:Je&&x(b.anisotropyMap.channel),clearcoatMapUv:L&&x(b.clearcoatMap.channel),clearcoatNormalMapUv:T&&x(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&x(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ve&&x(b.diffuseRoughnessMap.channel),iridescenceMapUv:de&&x(b.iridescenceMap.channel),iridescenceThicknessMapUv:pe&&x(b.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&x(b.sheenColorMap.channel),sheenRoughnessMapUv:ae&&x(b.sheenRoughnessMap.channel),specularMapUv:le&&x(b.specularMap.channel),specularColorMapUv:Re&&x(b.specularColorMap.channel),specularIntensityMapUv:B&&x(b.specularIntensityMap.channel),transmissionMapUv:he&&x(b.transmissionMap.channel),thicknessMapUv:se&&x(b.thicknessMap.channel),alphaMapUv:Ee&&x(b.alphaMap.channel),vertexTangents:!!z.attributes.tangent&&(Mt||sn),vertexNormals:!!z.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,pointsUvs:Y.isPoints===!0&&!!z.attributes.uv&&(Ke||Ee),fog:!!ee,useFog:b.fog===!0,fogExp2:!!ee&&ee.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||z.attributes.normal===void 0&&Mt===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:y,reversedDepthBuffer:Ue,skinning:Y.isSkinnedMesh===!0,hasPositionAttribute:z.attributes.position!==void 0,morphTargets:z.morphAttributes.position!==void 0,morphNormals:z.morphAttributes.normal!==void 0,morphColors:z.morphAttributes.color!==void 0,morphTargetsCount:ge,morphTextureStride:We,numSunLights:D.sun.length,numDirLights:D.directional.length,numPointLights:D.point.length,numSpotLights:D.spot.length,numSpotLightMaps:D.spotLightMap.length,numRectAreaLights:D.rectArea.length,numHemiLights:D.hemi.length,numSunLightShadows:D.sunShadowMap.length,numDirLightShadows:D.directionalShadowMap.length,numPointLightShadows:D.pointShadowMap.length,numSpotLightShadows:D.spotShadowMap.length,numSpotLightShadowsWithMaps:D.numSpotLightShadowsWithMaps,numLightProbes:D.numLightProbes,numLightProbeGrids:J.filter(Oe=>Oe.texture!==null).length,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&q.length>0,shadowMapType:i.shadowMap.type,toneMapping:we,decodeVideoTexture:Ke&&b.map.isVideoTexture===!0&&St.getTransfer(b.map.colorSpace)===Pt,decodeVideoTextureEmissive:De&&b.emissiveMap.isVideoTexture===!0&&St.getTransfer(b.emissiveMap.colorSpace)===Pt,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===fi,flipSided:b.side===dn,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:ut&&b.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ut&&b.extensions.multiDraw===!0||Vt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return dt.vertexUv1s=f.has(1),dt.vertexUv2s=f.has(2),dt.vertexUv3s=f.has(3),f.clear(),dt}function C(b){let D=[];if(b.shaderID?D.push(b.shaderID):(D.push(b.customVertexShaderID),D.push(b.customFragmentShaderID)),b.defines!==void 0)for(let q in b.defines)D.push(q),D.push(b.defines[q]);return b.isRawShaderMaterial===!1&&(S(D,b),v(D,b),D.push(i.outputColorSpace)),D.push(b.customProgramCacheKey),D.join()}function S(b,D){b.push(D.precision),b.push(D.outputColorSpace),b.push(D.envMapMode),b.push(D.envMapPMREM),b.push(D.envMapMaxLod),b.push(D.envMapSize),b.push(D.mapUv),b.push(D.alphaMapUv),b.push(D.lightMapUv),b.push(D.aoMapUv),b.push(D.bumpMapUv),b.push(D.normalMapUv),b.push(D.displacementMapUv),b.push(D.emissiveMapUv),b.push(D.metalnessMapUv),b.push(D.roughnessMapUv),b.push(D.anisotropyMapUv),b.push(D.clearcoatMapUv),b.push(D.clearcoatNormalMapUv),b.push(D.clearcoatRoughnessMapUv),b.push(D.diffuseRoughnessMapUv),b.push(D.iridescenceMapUv),b.push(D.iridescenceThicknessMapUv),b.push(D.sheenColorMapUv),b.push(D.sheenRoughnessMapUv),b.push(D.specularMapUv),b.push(D.specularColorMapUv),b.push(D.specularIntensityMapUv),b.push(D.transmissionMapUv),b.push(D.thicknessMapUv),b.push(D.combine),b.push(D.fogExp2),b.push(D.sizeAttenuation),b.push(D.morphTargetsCount),b.push(D.numSunLights),b.push(D.numDirLights),b.push(D.numPointLights),b.push(D.numSpotLights),b.push(D.numSpotLightMaps),b.push(D.numHemiLights),b.push(D.numRectAreaLights),b.push(D.numSunLightShadows),b.push(D.numDirLightShadows),b.push(D.numPointLightShadows),b.push(D.numSpotLightShadows),b.push(D.numSpotLightShadowsWithMaps),b.push(D.numLightProbes),b.push(D.numLightProbeGrids),b.push(D.shadowMapType),b.push(D.toneMapping),b.push(D.numClippingPlanes),b.push(D.numClipIntersection),b.push(D.depthPacking)}function v(b,D){l.disableAll(),D.instancing&&l.enable(0),D.instancingColor&&l.enable(1),D.instancingMorph&&l.enable(2),D.matcap&&l.enable(3),D.envMap&&l.enable(4),D.normalMapObjectSpace&&l.enable(5),D.normalMapTangentSpace&&l.enable(6),D.clearcoat&&l.enable(7),D.iridescence&&l.enable(8),D.alphaTest&&l.enable(9),D.vertexColors&&l.enable(10),D.vertexAlphas&&l.enable(11),D.vertexUv1s&&l.enable(12),D.vertexUv2s&&l.enable(13),D.vertexUv3s&&l.enable(14),D.vertexTangents&&l.enable(15),D.anisotropy&&l.enable(16),D.alphaHash&&l.enable(17),D.batching&&l.enable(18),D.dispersion&&l.enable(19),D.retroreflection&&l.enable(24),D.diffuseRoughness&&l.enable(25),D.batchingColor&&l.enable(20),D.gradientMap&&l.enable(21),D.packedNormalMap&&l.enable(22),D.vertexNormals&&l.enable(23),b.push(l.mask),l.disableAll(),D.fog&&l.enable(0),D.useFog&&l.enable(1),D.flatShading&&l.enable(2),D.logarithmicDepthBuffer&&l.enable(3),D.reversedDepthBuffer&&l.enable(4),D.skinning&&l.enable(5),D.morphTargets&&l.enable(6),D.morphNormals&&l.enable(7),D.morphColors&&l.enable(8),D.premultipliedAlpha&&l.enable(9),D.shadowMapEnabled&&l.enable(10),D.doubleSided&&l.enable(11),D.flipSided&&l.enable(12),D.useDepthPacking&&l.enable(13),D.dithering&&l.enable(14),D.transmission&&l.enable(15),D.sheen&&l.enable(16),D.opaque&&l.enable(17),D.pointsUvs&&l.enable(18),D.decodeVideoTexture&&l.enable(19),D.decodeVideoTextureEmissive&&l.enable(20),D.alphaToCoverage&&l.enable(21),D.numLightProbeGrids>0&&l.enable(22),D.hasPositionAttribute&&l.enable(23),b.push(l.mask)}function P(b){let D=g[b.type],q;if(D){let k=gi[D];q=Ud.clone(k.uniforms)}else q=b.uniforms;return q}function U(b,D){let q=m.get(D);return q!==void 0?++q.usedTimes:(q=new ib(i,D,b,s),d.push(q),m.set(D,q)),q}function I(b){if(--b.usedTimes===0){let D=d.indexOf(b);d[D]=d[d.length-1],d.pop(),m.delete(b.cacheKey),b.destroy()}}function O(b){h.remove(b)}function N(){h.dispose()}return{getParameters:E,getProgramCacheKey:C,getUniforms:P,acquireProgram:U,releaseProgram:I,releaseShaderCache:O,programs:d,dispose:N}}function ob(){let i=new WeakMap;function e(l){return i.has(l)}function t(l){let h=i.get(l);return h===void 0&&(h={},i.set(l,h)),h}function n(l){i.delete(l)}function s(l,h,f){i.get(l)[h]=f}function o(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:o}}function lb(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function nf(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function rf(){let i=[],e=0,t=[],n=[],s=[];function o(){e=0,t.length=0,n.length=0,s.length=0}function l(g){let x=0;return g.isInstancedMesh&&(x+=2),g.isSkinnedMesh&&(x+=1),x}function h(g,x,E,C,S,v){let P=i[e];return P===void 0?(P={id:g.id,object:g,geometry:x,material:E,materialVariant:l(g),groupOrder:C,renderOrder:g.renderOrder,z:S,group:v},i[e]=P):(P.id=g.id,P.object=g,P.geometry=x,P.material=E,P.materialVariant=l(g),P.groupOrder=C,P.renderOrder=g.renderOrder,P.z=S,P.group=v),e++,P}function f(g,x,E,C,S,v,P){P.reversedDepth===!0&&(S=-S);let U=h(g,x,E,C,S,v);E.transmission>0?n.push(U):E.transparent===!0?s.push(U):t.push(U)}function d(g,x,E,C,S,v){let P=h(g,x,E,C,S,v);E.transmission>0?n.unshift(P):E.transparent===!0?s.unshift(P):t.unshift(P)}function m(g,x){t.length>1&&t.sort(g||lb),n.length>1&&n.sort(x||nf),s.length>1&&s.sort(x||nf)}function y(){for(let g=e,x=i.length;g<x;g++){let E=i[g];if(E.id===null)break;E.id=null,E.object=null,E.geometry=null,E.material=null,E.group=null}}return{opaque:t,transmissive:n,transparent:s,init:o,push:f,unshift:d,finish:y,sort:m}}function cb(){let i=new WeakMap;function e(n,s){let o=i.get(n),l;return o===void 0?(l=new rf,i.set(n,[l])):s>=o.length?(l=new rf,o.push(l)):l=o[s],l}function t(){i=new WeakMap}return{get:e,dispose:t}}function hb(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new j,color:new ht};break;case"SpotLight":t={position:new j,direction:new j,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new j,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new j,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new j,halfWidth:new j,halfHeight:new j};break}return i[e.id]=t,t}}}function ub(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var db=0;function fb(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function pb(i){let e=new hb,t=ub(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let d=0;d<9;d++)n.probe.push(new j);let s=new j,o=new Lt,l=new Lt;function h(d){let m=0,y=0,g=0;for(let J=0;J<9;J++)n.probe[J].set(0,0,0);let x=0,E=0,C=0,S=0,v=0,P=0,U=0,I=0,O=0,N=0,b=0,D=0,q=0,k=0;d.sort(fb);for(let J=0,ee=d.length;J<ee;J++){let z=d[J],ie=z.color,G=z.intensity,ne=z.distance,Se=null;if(z.shadow&&z.shadow.map&&(z.shadow.map.texture.format===ji?Se=z.shadow.map.texture:Se=z.shadow.map.depthTexture||z.shadow.map.texture),z.isAmbientLight)m+=ie.r*G,y+=ie.g*G,g+=ie.b*G;else if(z.isLightProbe){for(let re=0;re<9;re++)n.probe[re].addScaledVector(z.sh.coefficients[re],G);k++}else if(z.isSunLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize.copy(H.mapSize).multiply(H.getFrameExtents()),n.sunShadow[E]=ge,n.sunShadowMap[E]=Se;let We=H.getViewportCount();for(let rt=0;rt<We;rt++)n.sunShadowMatrix[C+rt]=H.getMatrix(rt),n.sunShadowCascade[C+rt]=H._cascadeData[rt];C+=We,E++}n.sun[x]=re,x++}else if(z.isDirectionalLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.directionalShadow[S]=ge,n.directionalShadowMap[S]=Se,n.directionalShadowMatrix[S]=z.shadow.matrix,O++}n.directional[S]=re,S++}else if(z.isSpotLight){let re=e.get(z);re.position.setFromMatrixPosition(z.matrixWorld),re.color.copy(ie).multiplyScalar(G),re.distance=ne,re.coneCos=Math.cos(z.angle),re.penumbraCos=Math.cos(z.angle*(1-z.penumbra)),re.decay=z.decay,n.spot[P]=re;let H=z.shadow;if(z.map&&(n.spotLightMap[D]=z.map,D++,H.updateMatrices(z),z.castShadow&&q++),n.spotLightMatrix[P]=H.matrix,z.castShadow){let ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.spotShadow[P]=ge,n.spotShadowMap[P]=Se,b++}P++}else if(z.isRectAreaLight){let re=e.get(z);re.color.copy(ie).multiplyScalar(G),re.halfWidth.set(z.width*.5,0,0),re.halfHeight.set(0,z.height*.5,0),n.rectArea[U]=re,U++}else if(z.isPointLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),re.distance=z.distance,re.decay=z.decay,z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,ge.shadowCameraNear=H.camera.near,ge.shadowCameraFar=H.camera.far,n.pointShadow[v]=ge,n.pointShadowMap[v]=Se,n.pointShadowMatrix[v]=z.shadow.matrix,N++}n.point[v]=re,v++}else if(z.isHemisphereLight){let re=e.get(z);re.skyColor.copy(z.color).multiplyScalar(G),re.groundColor.copy(z.groundColor).multiplyScalar(G),n.hemi[I]=re,I++}}U>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Be.LTC_FLOAT_1,n.rectAreaLTC2=Be.LTC_FLOAT_2):(n.rectAreaLTC1=Be.LTC_HALF_1,n.rectAreaLTC2=Be.LTC_HALF_2)),n.ambient[0]=m,n.ambient[1]=y,n.ambient[2]=g;let Y=n.hash;(Y.sunLength!==x||Y.directionalLength!==S||Y.pointLength!==v||Y.spotLength!==P||Y.rectAreaLength!==U||Y.hemiLength!==I||Y.numSunShadows!==E||Y.numDirectionalShadows!==O||Y.numPointShadows!==N||Y.numSpotShadows!==b||Y.numSpotMaps!==D||Y.numLightProbes!==k)&&(n.sun.length=x,n.directional.length=S,n.spot.length=P,n.rectArea.length=U,n.point.length=v,n.hemi.length=I,n.sunShadow.length=E,n.sunShadowMap.length=E,n.sunShadowMatrix.length=C,n.sunShadowCascade.length=C,n.directionalShadow.length=O,n.directionalShadowMap.length=O,n.directionalShadowMatrix.length=O,n.pointShadow.length=N,n.pointShadowMap.length=N,n.pointShadowMatrix.length=N,n.spotShadow.length=b,n.spotShadowMap.length=b,n.spotLightMatrix.length=b+D-q,n.spotLightMap.length=D,n.numSpotLightShadowsWithMaps=q,n.numLightProbes=k,Y.sunLength=x,Y.directionalLength=S,Y.pointLength=v,Y.spotLength=P,Y.rectAreaLength=U,Y.hemiLength=I,Y.numSunShadows=E,Y.numDirectionalShadows=O,Y.numPointShadows=N,Y.numSpotShadows=b,Y.numSpotMaps=D,Y.numLightProbes=k,n.version=db++)}function f(d,m){let y=0,g=0,x=0,E=0,C=0,S=0,v=m.matrixWorldInverse;for(let P=0,U=d.length;P<U;P++){let I=d[P];if(I.isSunLight){let O=n.sun[y];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(v),y++}else if(I.isDirectionalLight){let O=n.directional[g];O.direction.setFromMatrixPosition(I.matrixWorld),s.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(s),O.direction.transformDirection(v),g++}else if(I.isSpotLight){let O=n.spot[E];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(v),O.direction.setFromMatrixPosition(I.matrixWorld),s.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(s),O.direction.transformDirection(v),E++}else if(I.isRectAreaLight){let O=n.rectArea[C];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(v),l.identity(),o.copy(I.matrixWorld),o.premultiply(v),l.extractRotation(o),O.halfWidth.set(I.width*.5,0,0),O.halfHeight.set(0,I.height*.5,0),O.halfWidth.applyMatrix4(l),O.halfHeight.applyMatrix4(l),C++}else if(I.isPointLight){let O=n.point[x];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(v),x++}else if(I.isHemisphereLight){let O=n.hemi[S];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(v),S++}}}return{setup:h,setupView:f,state:n}}function sf(i){let e=new pb(i),t=[],n=[],s=[];function o(y){m.camera=y,t.length=0,n.length=0,s.length=0}function l(y){y.isLightProbeGrid?s.push(y):t.push(y)}function h(y){n.push(y)}function f(){e.setup(t),s.sort((y,g)=>y.priority-g.priority||y.id-g.id)}function d(y){e.setupView(t,y)}let m={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:o,state:m,setupLights:f,setupLightsView:d,pushLight:l,pushShadow:h}}function mb(i){let e=new WeakMap;function t(s,o=0){let l=e.get(s),h;return l===void 0?(h=new sf(i),e.set(s,[h])):o>=l.length?(h=new sf(i),l.push(h)):h=l[o],h}function n(){e=new WeakMap}return{get:t,dispose:n}}var gb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,_b=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,vb=[new j(1,0,0),new j(-1,0,0),new j(0,1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1)],yb=[new j(0,-1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1),new j(0,-1,0),new j(0,-1,0)],af=new Lt,sa=new j,fh=new j;function xb(i,e,t){let n=new Gi,s=new et,o=new et,l=new Gt,h=new Ao,f=new Ro,d={},m=t.maxTextureSize,y={[Yi]:dn,[dn]:Yi,[fi]:fi},g=new di({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new et},radius:{value:4}},vertexShader:gb,fragmentShader:_b}),x=g.clone();x.defines.HORIZONTAL_PASS=1;let E=new wn;E.setAttribute("position",new En(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let C=new Ot(E,g),S=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=dr;let v=this.type;this.render=function(N,b,D){if(S.enabled===!1||S.autoUpdate===!1&&S.needsUpdate===!1||N.length===0)return;this.type===Ku&&(Qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=dr);let q=i.getRenderTarget(),k=i.getActiveCubeFace(),Y=i.getActiveMipmapLevel(),J=i.state;J.setBlending(fr),J.buffers.depth.getReversed()===!0?J.buffers.color.setClear(0,0,0,0):J.buffers.color.setClear(1,1,1,1),J.buffers.depth.setTest(!0),J.setScissorTest(!1);let ee=v!==this.type;ee&&b.traverse(function(z){z.material&&(Array.isArray(z.material)?z.material.forEach(ie=>ie.needsUpdate=!0):z.material.needsUpdate=!0)});for(let z=0,ie=N.length;z<ie;z++){let G=N[z],ne=G.shadow;if(ne===void 0){Qe("WebGLShadowMap:",G,"has no shadow.");continue}if(ne.autoUpdate===!1&&ne.needsUpdate===!1)continue;s.copy(ne.mapSize);let Se=ne.getFrameExtents();s.multiply(Se),o.copy(ne.mapSize),(s.x>m||s.y>m)&&(s.x>m&&(o.x=Math.floor(m/Se.x),s.x=o.x*Se.x,ne.mapSize.x=o.x),s.y>m&&(o.y=Math.floor(m/Se.y),s.y=o.y*Se.y,ne.mapSize.y=o.y));let re=i.state.buffers.depth.getReversed();if(ne.camera._reversedDepth=re,ne.map===null||ee===!0){if(ne.map!==null&&(ne.map.depthTexture!==null&&(ne.map.depthTexture.dispose(),ne.map.depthTexture=null),ne.map.dispose()),this.type===jr){if(G.isPointLight){Qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}ne.map=new Dn(s.x,s.y,{format:ji,type:Jn,minFilter:Sn,magFilter:Sn,generateMipmaps:!1}),ne.map.texture.name=G.name+".shadowMap",ne.map.depthTexture=new Ai(s.x,s.y,zn),ne.map.depthTexture.name=G.name+".shadowMapDepth",ne.map.depthTexture.format=Ei,ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn}else G.isPointLight?(ne.map=new oa(s.x),ne.map.depthTexture=new Us(s.x,Zn)):(ne.map=new Dn(s.x,s.y),ne.map.depthTexture=new Ai(s.x,s.y,Zn)),ne.map.depthTexture.name=G.name+".shadowMap",ne.map.depthTexture.format=Ei,this.type===dr?(ne.map.depthTexture.compareFunction=re?eh:Qc,ne.map.depthTexture.minFilter=Sn,ne.map.depthTexture.magFilter=Sn):(ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn);ne.camera.updateProjectionMatrix()}ne.map.isWebGLCubeRenderTarget!==!0&&(ne.map.width!==s.x||ne.map.height!==s.y)&&ne.map.setSize(s.x,s.y);let H=ne.map.isWebGLCubeRenderTarget?6:ne.getViewportCount();G.isPointLight!==!0&&ne.updateMatrices(G,D);let ge=(ne.camera.layers.mask&4294967294)!==0?ne.camera.layers:D.layers;for(let We=0;We<H;We++){let rt=ne.getCamera(We);if(G.isPointLight){let ue=ne.camera,Fe=ne.matrix,Pe=G.distance||ue.far;Pe!==ue.far&&(ue.far=Pe,ue.updateProjectionMatrix()),sa.setFromMatrixPosition(G.matrixWorld),ue.position.copy(sa),fh.copy(ue.position),fh.add(vb[We]),ue.up.copy(yb[We]),ue.lookAt(fh),ue.updateMatrixWorld(),Fe.makeTranslation(-sa.x,-sa.y,-sa.z),af.multiplyMatrices(ue.projectionMatrix,ue.matrixWorldInverse),ne._frustum.setFromProjectionMatrix(af,ue.coordinateSystem,ue.reversedDepth)}if(ne.map.isWebGLCubeRenderTarget)i.setRenderTarget(ne.map,We),i.clear();else{We===0&&(i.setRenderTarget(ne.map),i.clear());let ue=ne.getViewport(We);l.set(o.x*ue.x,o.y*ue.y,o.x*ue.z,o.y*ue.w),J.viewport(l)}n=ne.getFrustum(We),I(b,D,rt,G,ge,this.type)}ne.isPointLightShadow!==!0&&this.type===jr&&P(ne,D),ne.needsUpdate=!1}v=this.type,S.needsUpdate=!1,i.setRenderTarget(q,k,Y)};function P(N,b){let D=e.update(C);g.defines.VSM_SAMPLES!==N.blurSamples&&(g.defines.VSM_SAMPLES=N.blurSamples,x.defines.VSM_SAMPLES=N.blurSamples,g.needsUpdate=!0,x.needsUpdate=!0),N.mapPass===null?N.mapPass=new Dn(s.x,s.y,{format:ji,type:Jn}):(N.mapPass.width!==N.map.width||N.mapPass.height!==N.map.height)&&N.mapPass.setSize(N.map.width,N.map.height),g.uniforms.shadow_pass.value=N.map.depthTexture,g.uniforms.resolution.value.set(N.map.width,N.map.height),g.uniforms.radius.value=N.radius,i.setRenderTarget(N.mapPass),i.clear(),i.renderBufferDirect(b,null,D,g,C,null),x.uniforms.shadow_pass.value=N.mapPass.texture,x.uniforms.resolution.value.set(N.map.width,N.map.height),x.uniforms.radius.value=N.radius,i.setRenderTarget(N.map),i.clear(),i.renderBufferDirect(b,null,D,x,C,null)}function U(N,b,D,q){let k=null,Y=D.isPointLight===!0?N.customDistanceMaterial:N.customDepthMaterial;if(Y!==void 0)k=Y;else if(k=D.isPointLight===!0?f:h,i.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let J=k.uuid,ee=b.uuid,z=d[J];z===void 0&&(z={},d[J]=z);let ie=z[ee];ie===void 0&&(ie=k.clone(),z[ee]=ie,b.addEventListener("dispose",O)),k=ie}if(k.visible=b.visible,k.wireframe=b.wireframe,q===jr?k.side=b.shadowSide!==null?b.shadowSide:b.side:k.side=b.shadowSide!==null?b.shadowSide:y[b.side],k.alphaMap=b.alphaMap,k.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,k.map=b.map,k.clipShadows=b.clipShadows,k.clippingPlanes=b.clippingPlanes,k.clipIntersection=b.clipIntersection,k.displacementMap=b.displacementMap,k.displacementScale=b.displacementScale,k.displacementBias=b.displacementBias,k.wireframeLinewidth=b.wireframeLinewidth,k.linewidth=b.linewidth,D.isPointLight===!0&&k.isMeshDistanceMaterial===!0){let J=i.properties.get(k);J.light=D}return k}function I(N,b,D,q,k,Y){if(N.visible===!1)return;if(N.layers.test(k)&&(N.isMesh||N.isLine||N.isPoints)&&(N.castShadow||N.receiveShadow&&Y===jr)&&(!N.frustumCulled||N.intersectsFrustum(n))){N.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,N.matrixWorld);let z=e.update(N),ie=N.material;if(Array.isArray(ie)){let G=z.groups;for(let ne=0,Se=G.length;ne<Se;ne++){let re=G[ne],H=ie[re.materialIndex];if(H&&H.visible){let ge=U(N,H,q,Y);N.onBeforeShadow(i,N,b,D,z,ge,re),i.renderBufferDirect(D,null,z,ge,N,re),N.onAfterShadow(i,N,b,D,z,ge,re)}}}else if(ie.visible){let G=U(N,ie,q,Y);N.onBeforeShadow(i,N,b,D,z,G,null),i.renderBufferDirect(D,null,z,G,N,null),N.onAfterShadow(i,N,b,D,z,G,null)}}let ee=N.children;for(let z=0,ie=ee.length;z<ie;z++)I(ee[z],b,D,q,k,Y)}function O(N){N.target.removeEventListener("dispose",O);for(let D in d){let q=d[D],k=N.target.uuid;k in q&&(q[k].dispose(),delete q[k])}}}function Sb(i,e){function t(){let B=!1,he=new Gt,se=null,Ce=new Gt(0,0,0,0);return{setMask:function(Ee){se!==Ee&&!B&&(i.colorMask(Ee,Ee,Ee,Ee),se=Ee)},setLocked:function(Ee){B=Ee},setClear:function(Ee,Ae,Xe,ut,we){we===!0&&(Ee*=ut,Ae*=ut,Xe*=ut),he.set(Ee,Ae,Xe,ut),Ce.equals(he)===!1&&(i.clearColor(Ee,Ae,Xe,ut),Ce.copy(he))},reset:function(){B=!1,se=null,Ce.set(-1,0,0,0)}}}function n(){let B=!1,he=!1,se=null,Ce=null,Ee=null;return{setReversed:function(Ae){if(he!==Ae){let Xe=e.get("EXT_clip_control");Ae?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),he=Ae;let ut=Ee;Ee=null,this.setClear(ut)}},getReversed:function(){return he},setTest:function(Ae){Ae?Ue(i.DEPTH_TEST):ot(i.DEPTH_TEST)},setMask:function(Ae){se!==Ae&&!B&&(i.depthMask(Ae),se=Ae)},setFunc:function(Ae){if(he&&(Ae=Dd[Ae]),Ce!==Ae){switch(Ae){case lo:i.depthFunc(i.NEVER);break;case co:i.depthFunc(i.ALWAYS);break;case ho:i.depthFunc(i.LESS);break;case Br:i.depthFunc(i.LEQUAL);break;case uo:i.depthFunc(i.EQUAL);break;case fo:i.depthFunc(i.GEQUAL);break;case po:i.depthFunc(i.GREATER);break;case mo:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ce=Ae}},setLocked:function(Ae){B=Ae},setClear:function(Ae){Ee!==Ae&&(Ee=Ae,he&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){B=!1,se=null,Ce=null,Ee=null,he=!1}}}function s(){let B=!1,he=null,se=null,Ce=null,Ee=null,Ae=null,Xe=null,ut=null,we=null;return{setTest:function(qe){B||(qe?Ue(i.STENCIL_TEST):ot(i.STENCIL_TEST))},setMask:function(qe){he!==qe&&!B&&(i.stencilMask(qe),he=qe)},setFunc:function(qe,dt,Oe){(se!==qe||Ce!==dt||Ee!==Oe)&&(i.stencilFunc(qe,dt,Oe),se=qe,Ce=dt,Ee=Oe)},setOp:function(qe,dt,Oe){(Ae!==qe||Xe!==dt||ut!==Oe)&&(i.stencilOp(qe,dt,Oe),Ae=qe,Xe=dt,ut=Oe)},setLocked:function(qe){B=qe},setClear:function(qe){we!==qe&&(i.clearStencil(qe),we=qe)},reset:function(){B=!1,he=null,se=null,Ce=null,Ee=null,Ae=null,Xe=null,ut=null,we=null}}}let o=new t,l=new n,h=new s,f={},d=new WeakMap,m={},y={},g={},x=new WeakMap,E=[],C=null,S=!1,v=null,P=null,U=null,I=null,O=null,N=null,b=null,D=new ht(0,0,0),q=0,k=!1,Y=null,J=null,ee=null,z=null,ie=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),ne=!1,Se=0,re=i.getParameter(i.VERSION);re.indexOf("WebGL")!==-1?(Se=parseFloat(/^WebGL (\d)/.exec(re)[1]),ne=Se>=1):re.indexOf("OpenGL ES")!==-1&&(Se=parseFloat(/^OpenGL ES (\d)/.exec(re)[1]),ne=Se>=2);let H=null,ge={},We=i.getParameter(i.SCISSOR_BOX),rt=i.getParameter(i.VIEWPORT),ue=new Gt().fromArray(We),Fe=new Gt().fromArray(rt);function Pe(B,he,se,Ce){let Ee=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(B,Ae),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xe=0;Xe<se;Xe++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(he,0,i.RGBA,1,1,Ce,0,i.RGBA,i.UNSIGNED_BYTE,Ee):i.texImage2D(he+Xe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Ee);return Ae}let je={};je[i.TEXTURE_2D]=Pe(i.TEXTURE_2D,i.TEXTURE_2D,1),je[i.TEXTURE_CUBE_MAP]=Pe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),je[i.TEXTURE_2D_ARRAY]=Pe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),je[i.TEXTURE_3D]=Pe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),o.setClear(0,0,0,1),l.setClear(1),h.setClear(0),Ue(i.DEPTH_TEST),l.setFunc(Br),It(!1),Mt(Fc),Ue(i.CULL_FACE),Ht(fr);function Ue(B){m[B]!==!0&&(i.enable(B),m[B]=!0)}function ot(B){m[B]!==!1&&(i.disable(B),m[B]=!1)}function Vt(B,he){return g[B]!==he?(i.bindFramebuffer(B,he),g[B]=he,B===i.DRAW_FRAMEBUFFER&&(g[i.FRAMEBUFFER]=he),B===i.FRAMEBUFFER&&(g[i.DRAW_FRAMEBUFFER]=he),!0):!1}function Ke(B,he){let se=E,Ce=!1;if(B){se=x.get(he),se===void 0&&(se=[],x.set(he,se));let Ee=B.textures;if(se.length!==Ee.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Xe=Ee.length;Ae<Xe;Ae++)se[Ae]=i.COLOR_ATTACHMENT0+Ae;se.length=Ee.length,Ce=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,Ce=!0);Ce&&i.drawBuffers(se)}function Et(B){return C!==B?(i.useProgram(B),C=B,!0):!1}let Rt={[pr]:i.FUNC_ADD,[ed]:i.FUNC_SUBTRACT,[td]:i.FUNC_REVERSE_SUBTRACT};Rt[nd]=i.MIN,Rt[id]=i.MAX;let mt={[rd]:i.ZERO,[sd]:i.ONE,[ad]:i.SRC_COLOR,[Bc]:i.SRC_ALPHA,[dd]:i.SRC_ALPHA_SATURATE,[hd]:i.DST_COLOR,[ld]:i.DST_ALPHA,[od]:i.ONE_MINUS_SRC_COLOR,[kc]:i.ONE_MINUS_SRC_ALPHA,[ud]:i.ONE_MINUS_DST_COLOR,[cd]:i.ONE_MINUS_DST_ALPHA,[fd]:i.CONSTANT_COLOR,[pd]:i.ONE_MINUS_CONSTANT_COLOR,[md]:i.CONSTANT_ALPHA,[gd]:i.ONE_MINUS_CONSTANT_ALPHA};function Ht(B,he,se,Ce,Ee,Ae,Xe,ut,we,qe){if(B===fr){S===!0&&(ot(i.BLEND),S=!1);return}if(S===!1&&(Ue(i.BLEND),S=!0),B!==Qu){if(B!==v||qe!==k){if((P!==pr||O!==pr)&&(i.blendEquation(i.FUNC_ADD),P=pr,O=pr),qe)switch(B){case Zr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nc:i.blendFunc(i.ONE,i.ONE);break;case Uc:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Oc:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:it("WebGLState: Invalid blending: ",B);break}else switch(B){case Zr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nc:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Uc:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Oc:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",B);break}U=null,I=null,N=null,b=null,D.set(0,0,0),q=0,v=B,k=qe}return}Ee=Ee||he,Ae=Ae||se,Xe=Xe||Ce,(he!==P||Ee!==O)&&(i.blendEquationSeparate(Rt[he],Rt[Ee]),P=he,O=Ee),(se!==U||Ce!==I||Ae!==N||Xe!==b)&&(i.blendFuncSeparate(mt[se],mt[Ce],mt[Ae],mt[Xe]),U=se,I=Ce,N=Ae,b=Xe),(ut.equals(D)===!1||we!==q)&&(i.blendColor(ut.r,ut.g,ut.b,we),D.copy(ut),q=we),v=B,k=!1}function pt(B,he){B.side===fi?ot(i.CULL_FACE):Ue(i.CULL_FACE);let se=B.side===dn;he&&(se=!se),It(se),B.blending===Zr&&B.transparent===!1?Ht(fr):Ht(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),l.setFunc(B.depthFunc),l.setTest(B.depthTest),l.setMask(B.depthWrite),o.setMask(B.colorWrite);let Ce=B.stencilWrite;h.setTest(Ce),Ce&&(h.setMask(B.stencilWriteMask),h.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),h.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),De(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Ue(i.SAMPLE_ALPHA_TO_COVERAGE):ot(i.SAMPLE_ALPHA_TO_COVERAGE)}function It(B){Y!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),Y=B)}function Mt(B){B!==Zu?(Ue(i.CULL_FACE),B!==J&&(B===Fc?i.cullFace(i.BACK):B===Ju?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):ot(i.CULL_FACE),J=B}function rn(B){B!==ee&&(ne&&i.lineWidth(B),ee=B)}function De(B,he,se){B?(Ue(i.POLYGON_OFFSET_FILL),(z!==he||ie!==se)&&(z=he,ie=se,l.getReversed()&&(he=-he,se=-se),i.polygonOffset(he,se))):ot(i.POLYGON_OFFSET_FILL)}function $e(B){B?Ue(i.SCISSOR_TEST):ot(i.SCISSOR_TEST)}function hn(B){B===void 0&&(B=i.TEXTURE0+G-1),H!==B&&(i.activeTexture(B),H=B)}function sn(B,he,se){se===void 0&&(H===null?se=i.TEXTURE0+G-1:se=H);let Ce=ge[se];Ce===void 0&&(Ce={type:void 0,texture:void 0},ge[se]=Ce),(Ce.type!==B||Ce.texture!==he)&&(H!==se&&(i.activeTexture(se),H=se),i.bindTexture(B,he||je[B]),Ce.type=B,Ce.texture=he)}function W(){let B=ge[H];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function vn(){try{i.compressedTexImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function Ct(){try{i.compressedTexImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function Ut(){try{i.texSubImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function Le(){try{i.texSubImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function $t(){try{i.compressedTexSubImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function Ze(){try{i.compressedTexSubImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function Je(){try{i.texStorage2D(...arguments)}catch(B){it("WebGLState:",B)}}function L(){try{i.texStorage3D(...arguments)}catch(B){it("WebGLState:",B)}}function T(){try{i.texImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function Z(){try{i.texImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function ve(B){return y[B]!==void 0?y[B]:i.getParameter(B)}function de(B,he){y[B]!==he&&(i.pixelStorei(B,he),y[B]=he)}function pe(B){ue.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),ue.copy(B))}function Me(B){Fe.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),Fe.copy(B))}function ae(B,he){let se=d.get(he);se===void 0&&(se=new WeakMap,d.set(he,se));let Ce=se.get(B);Ce===void 0&&(Ce=i.getUniformBlockIndex(he,B.name),i.uniformBlockBinding(he,Ce,Ce),se.set(B,Ce))}function le(B,he,se){let Ee=d.get(he).get(B);f[Ee]!==se&&(i.bindBufferBase(i.UNIFORM_BUFFER,Ee,se),f[Ee]=se)}function Re(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),l.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),m={},y={},H=null,ge={},g={},f={},x=new WeakMap,E=[],C=null,S=!1,v=null,P=null,U=null,I=null,O=null,N=null,b=null,D=new ht(0,0,0),q=0,k=!1,Y=null,J=null,ee=null,z=null,ie=null,ue.set(0,0,i.canvas.width,i.canvas.height),Fe.set(0,0,i.canvas.width,i.canvas.height),o.reset(),l.reset(),h.reset()}return{buffers:{color:o,depth:l,stencil:h},enable:Ue,disable:ot,bindFramebuffer:Vt,drawBuffers:Ke,useProgram:Et,setBlending:Ht,setMaterial:pt,setFlipSided:It,setCullFace:Mt,setLineWidth:rn,setPolygonOffset:De,setScissorTest:$e,activeTexture:hn,bindTexture:sn,unbindTexture:W,compressedTexImage2D:vn,compressedTexImage3D:Ct,texImage2D:T,texImage3D:Z,pixelStorei:de,getParameter:ve,updateUBOMapping:ae,uniformBlockBinding:le,texStorage2D:Je,texStorage3D:L,texSubImage2D:Ut,texSubImage3D:Le,compressedTexSubImage2D:$t,compressedTexSubImage3D:Ze,scissor:pe,viewport:Me,reset:Re}}function Mb(i,e,t,n,s,o,l){let h=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,f=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),d=new et,m=new WeakMap,y=new Set,g,x=new WeakMap,E=new Set,C=new FinalizationRegistry(L=>E.delete(L)),S=!1;try{S=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(L,T){return S?new OffscreenCanvas(L,T):ws("canvas")}function P(L,T,Z){let ve=1,de=Je(L);if((de.width>Z||de.height>Z)&&(ve=Z/Math.max(de.width,de.height)),ve<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let pe=Math.floor(ve*de.width),Me=Math.floor(ve*de.height);g===void 0&&(g=v(pe,Me));let ae=T?v(pe,Me):g;return ae.width=pe,ae.height=Me,ae.getContext("2d").drawImage(L,0,0,pe,Me),Qe("WebGLRenderer: Texture has been resized from ("+de.width+"x"+de.height+") to ("+pe+"x"+Me+")."),ae}else return"data"in L&&Qe("WebGLRenderer: Image in DataTexture is too big ("+de.width+"x"+de.height+")."),L;return L}function U(L){return L.generateMipmaps}function I(L){i.generateMipmap(L)}function O(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function N(L,T,Z,ve,de,pe=!1){if(L!==null){if(i[L]!==void 0)return i[L];Qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let Me;ve&&(Me=e.get("EXT_texture_norm16"),Me||Qe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ae=T;if(T===i.RED&&(Z===i.FLOAT&&(ae=i.R32F),Z===i.HALF_FLOAT&&(ae=i.R16F),Z===i.UNSIGNED_BYTE&&(ae=i.R8),Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.R16_EXT),Z===i.SHORT&&Me&&(ae=Me.R16_SNORM_EXT)),T===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.R8UI),Z===i.UNSIGNED_SHORT&&(ae=i.R16UI),Z===i.UNSIGNED_INT&&(ae=i.R32UI),Z===i.BYTE&&(ae=i.R8I),Z===i.SHORT&&(ae=i.R16I),Z===i.INT&&(ae=i.R32I)),T===i.RG&&(Z===i.FLOAT&&(ae=i.RG32F),Z===i.HALF_FLOAT&&(ae=i.RG16F),Z===i.UNSIGNED_BYTE&&(ae=i.RG8),Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.RG16_EXT),Z===i.SHORT&&Me&&(ae=Me.RG16_SNORM_EXT)),T===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.RG8UI),Z===i.UNSIGNED_SHORT&&(ae=i.RG16UI),Z===i.UNSIGNED_INT&&(ae=i.RG32UI),Z===i.BYTE&&(ae=i.RG8I),Z===i.SHORT&&(ae=i.RG16I),Z===i.INT&&(ae=i.RG32I)),T===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(ae=i.RGB16UI),Z===i.UNSIGNED_INT&&(ae=i.RGB32UI),Z===i.BYTE&&(ae=i.RGB8I),Z===i.SHORT&&(ae=i.RGB16I),Z===i.INT&&(ae=i.RGB32I)),T===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(ae=i.RGBA16UI),Z===i.UNSIGNED_INT&&(ae=i.RGBA32UI),Z===i.BYTE&&(ae=i.RGBA8I),Z===i.SHORT&&(ae=i.RGBA16I),Z===i.INT&&(ae=i.RGBA32I)),T===i.RGB&&(Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGB16_EXT),Z===i.SHORT&&Me&&(ae=Me.RGB16_SNORM_EXT),Z===i.UNSIGNED_INT_5_9_9_9_REV&&(ae=i.RGB9_E5),Z===i.UNSIGNED_INT_10F_11F_11F_REV&&(ae=i.R11F_G11F_B10F)),T===i.RGBA){let le=pe?bs:St.getTransfer(de);Z===i.FLOAT&&(ae=i.RGBA32F),Z===i.HALF_FLOAT&&(ae=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(ae=le===Pt?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGBA16_EXT),Z===i.SHORT&&Me&&(ae=Me.RGBA16_SNORM_EXT),Z===i.UNSIGNED_SHORT_4_4_4_4&&(ae=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(ae=i.RGB5_A1)}return(ae===i.R16F||ae===i.R32F||ae===i.RG16F||ae===i.RG32F||ae===i.RGBA16F||ae===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ae}function b(L,T){let Z;return L?T===null||T===Zn||T===gr?Z=i.DEPTH24_STENCIL8:T===zn?Z=i.DEPTH32F_STENCIL8:T===Kr&&(Z=i.DEPTH24_STENCIL8,Qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Zn||T===gr?Z=i.DEPTH_COMPONENT24:T===zn?Z=i.DEPTH_COMPONENT32F:T===Kr&&(Z=i.DEPTH_COMPONENT16),Z}function D(L,T){return U(L)===!0||L.isFramebufferTexture&&L.minFilter!==cn&&L.minFilter!==Sn?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?T.mipmaps.length:1}function q(L){let T=new WeakRef(L);n.get(L).__ref=T,E.add(T),C.register(L,T,T)}function k(L){let T=n.get(L).__ref;T!==void 0&&(E.delete(T),C.unregister(T))}function Y(L){ee(L.target)}function J(L){z(L.target)}function ee(L){L.removeEventListener("dispose",Y),k(L),G(L),L.isVideoTexture&&m.delete(L),L.isHTMLTexture&&y.delete(L)}function z(L){L.removeEventListener("dispose",J),k(L),Se(L)}function ie(){for(let L of E){let T=L.deref();T!==void 0&&(T.isRenderTarget===!0?z(T):ee(T))}E.clear(),y.clear()}function G(L){let T=n.get(L);if(T.__webglInit===void 0)return;let Z=L.source,ve=x.get(Z);if(ve){let de=ve[T.__cacheKey];de.usedTimes--,de.usedTimes===0&&ne(L),Object.keys(ve).length===0&&x.delete(Z)}n.remove(L)}function ne(L){let T=n.get(L);i.deleteTexture(T.__webglTexture);let Z=L.source,ve=x.get(Z);delete ve[T.__cacheKey],l.memory.textures--}function Se(L){let T=n.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let Z=L.depthTexture;if(Z&&Z.renderTarget===L&&ee(Z),L.isWebGLCubeRenderTarget)for(let de=0;de<6;de++){if(Array.isArray(T.__webglFramebuffer[de]))for(let pe=0;pe<T.__webglFramebuffer[de].length;pe++)i.deleteFramebuffer(T.__webglFramebuffer[de][pe]);else i.deleteFramebuffer(T.__webglFramebuffer[de]);T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer[de])}else{if(Array.isArray(T.__webglFramebuffer))for(let de=0;de<T.__webglFramebuffer.length;de++)i.deleteFramebuffer(T.__webglFramebuffer[de]);else i.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&i.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let de=0;de<T.__webglColorRenderbuffer.length;de++)T.__webglColorRenderbuffer[de]&&i.deleteRenderbuffer(T.__webglColorRenderbuffer[de]);T.__webglDepthRenderbuffer&&i.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ve=L.textures;for(let de=0,pe=ve.length;de<pe;de++){let Me=n.get(ve[de]);Me.__webglTexture&&(i.deleteTexture(Me.__webglTexture),l.memory.textures--),n.remove(ve[de])}n.remove(L)}let re=0;function H(){re=0}function ge(){return re}function We(L){re=L}function rt(){let L=re;return L>=s.maxTextures&&Qe("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),re+=1,L}function ue(L){let T=[];return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.join()}function Fe(L,T){let Z=n.get(L);if(L.isVideoTexture&&$t(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Z.__version!==L.version){let ve=L.image;if(ve===null)Qe("WebGLRenderer: Texture marked for update but no image data found.");else if(ve.complete===!1)Qe("WebGLRenderer: Texture marked for update but image is incomplete");else{pt(Z,L,T);return}}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+T)}function Pe(L,T){let Z=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){pt(Z,L,T);return}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+T)}function je(L,T){let Z=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){pt(Z,L,T);return}t.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+T)}function Ue(L,T){let Z=n.get(L);if(L.version>0&&Z.__version!==L.version){It(Z,L,T);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+T)}let ot={[kr]:i.REPEAT,[oi]:i.CLAMP_TO_EDGE,[go]:i.MIRRORED_REPEAT},Vt={[cn]:i.NEAREST,[yd]:i.NEAREST_MIPMAP_NEAREST,[Js]:i.NEAREST_MIPMAP_LINEAR,[Sn]:i.LINEAR,[Ho]:i.LINEAR_MIPMAP_NEAREST,[Ci]:i.LINEAR_MIPMAP_LINEAR},Ke={[bd]:i.NEVER,[th]:i.ALWAYS,[wd]:i.LESS,[Qc]:i.LEQUAL,[Ed]:i.EQUAL,[eh]:i.GEQUAL,[Td]:i.GREATER,[Ad]:i.NOTEQUAL};function Et(L,T){if(T.type===zn&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===Sn||T.magFilter===Ho||T.magFilter===Js||T.magFilter===Ci||T.minFilter===Sn||T.minFilter===Ho||T.minFilter===Js||T.minFilter===Ci)&&Qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,ot[T.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,ot[T.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,ot[T.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,Vt[T.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,Vt[T.minFilter]),T.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Ke[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===cn||T.minFilter!==Js&&T.minFilter!==Ci||T.type===zn&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let Z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function Rt(L,T){let Z=!1;L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",Y),q(T));let ve=T.source,de=x.get(ve);de===void 0&&(de={},x.set(ve,de));let pe=ue(T);if(pe!==L.__cacheKey){de[pe]===void 0&&(de[pe]={texture:i.createTexture(),usedTimes:0},l.memory.textures++,Z=!0),de[pe].usedTimes++;let Me=de[L.__cacheKey];Me!==void 0&&(de[L.__cacheKey].usedTimes--,Me.usedTimes===0&&ne(T)),L.__cacheKey=pe,L.__webglTexture=de[pe].texture}return Z}function mt(L,T,Z){return Math.floor(Math.floor(L/Z)/T)}function Ht(L,T,Z,ve){let pe=L.updateRanges;if(pe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,T.width,T.height,Z,ve,T.data);else{pe.sort((B,he)=>B.start-he.start);let Me=0;for(let B=1;B<pe.length;B++){let he=pe[Me],se=pe[B],Ce=he.start+he.count,Ee=mt(se.start,T.width,4),Ae=mt(he.start,T.width,4);se.start<=Ce+1&&Ee===Ae&&mt(se.start+se.count-1,T.width,4)===Ee?he.count=Math.max(he.count,se.start+se.count-he.start):(++Me,pe[Me]=se)}pe.length=Me+1;let ae=t.getParameter(i.UNPACK_ROW_LENGTH),le=t.getParameter(i.UNPACK_SKIP_PIXELS),Re=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,T.width);for(let B=0,he=pe.length;B<he;B++){let se=pe[B],Ce=Math.floor(se.start/4),Ee=Math.ceil(se.count/4),Ae=Ce%T.width,Xe=Math.floor(Ce/T.width),ut=Ee,we=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Xe,ut,we,Z,ve,T.data)}L.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ae),t.pixelStorei(i.UNPACK_SKIP_PIXELS,le),t.pixelStorei(i.UNPACK_SKIP_ROWS,Re)}}function pt(L,T,Z){let ve=i.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ve=i.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ve=i.TEXTURE_3D);let de=Rt(L,T),pe=T.source;t.bindTexture(ve,L.__webglTexture,i.TEXTURE0+Z);let Me=n.get(pe);if(pe.version!==Me.__version||de===!0){if(t.activeTexture(i.TEXTURE0+Z),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let we=St.getPrimaries(St.workingColorSpace),qe=T.colorSpace===Ii?null:St.getPrimaries(T.colorSpace),dt=T.colorSpace===Ii||we===qe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,dt)}t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment);let le=P(T.image,!1,s.maxTextureSize);le=Ze(T,le);let Re=o.convert(T.format,T.colorSpace),B=o.convert(T.type),he=N(T.internalFormat,Re,B,T.normalized,T.colorSpace,T.isVideoTexture);Et(ve,T);let se,Ce=T.mipmaps,Ee=T.isVideoTexture!==!0,Ae=Me.__version===void 0||de===!0,Xe=pe.dataReady,ut=D(T,le);if(T.isDepthTexture)he=b(T.format===Pi,T.type),Ae&&(Ee?t.texStorage2D(i.TEXTURE_2D,1,he,le.width,le.height):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Re,B,null));else if(T.isDataTexture)if(Ce.length>0){Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Ce[0].width,Ce[0].height);for(let we=0,qe=Ce.length;we<qe;we++)se=Ce[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Re,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Re,B,se.data);T.generateMipmaps=!1}else Ee?(Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height),Xe&&Ht(T,le,Re,B)):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Re,B,le.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){Ee&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,Ce[0].width,Ce[0].height,le.depth);for(let we=0,qe=Ce.length;we<qe;we++)if(se=Ce[we],T.format!==Kn)if(Re!==null)if(Ee){if(Xe)if(T.layerUpdates.size>0){let dt=uh(se.width,se.height,T.format,T.type);for(let Oe of T.layerUpdates){let Tt=se.data.subarray(Oe*dt/se.data.BYTES_PER_ELEMENT,(Oe+1)*dt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,Oe,se.width,se.height,1,Re,Tt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Re,se.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,se.data,0,0);else Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ee?Xe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Re,B,se.data):t.texImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,Re,B,se.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Ce[0].width,Ce[0].height);for(let we=0,qe=Ce.length;we<qe;we++)se=Ce[we],T.format!==Kn?Re!==null?Ee?Xe&&t.compressedTexSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Re,se.data):t.compressedTexImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,se.data):Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Re,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Re,B,se.data)}else if(T.isDataArrayTexture)if(Ee){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,le.width,le.height,le.depth),Xe)if(T.layerUpdates.size>0){let we=uh(le.width,le.height,T.format,T.type);for(let qe of T.layerUpdates){let dt=le.data.subarray(qe*we/le.data.BYTES_PER_ELEMENT,(qe+1)*we/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,qe,le.width,le.height,1,Re,B,dt)}T.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,Re,B,le.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,he,le.width,le.height,le.depth,0,Re,B,le.data);else if(T.isData3DTexture)Ee?(Ae&&t.texStorage3D(i.TEXTURE_3D,ut,he,le.width,le.height,le.depth),Xe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,Re,B,le.data)):t.texImage3D(i.TEXTURE_3D,0,he,le.width,le.height,le.depth,0,Re,B,le.data);else if(T.isFramebufferTexture){if(Ae)if(Ee)t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height);else{let we=le.width,qe=le.height;for(let dt=0;dt<ut;dt++)t.texImage2D(i.TEXTURE_2D,dt,he,we,qe,0,Re,B,null),we>>=1,qe>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in i){let we=i.canvas;if(we.hasAttribute("layoutsubtree")||we.setAttribute("layoutsubtree","true"),le.parentNode!==we){we.appendChild(le),y.add(T),we.onpaint=qe=>{let dt=qe.changedElements;for(let Oe of y)dt.includes(Oe.image)&&(Oe.needsUpdate=!0)},we.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,le);else{let dt=i.RGBA,Oe=i.RGBA,Tt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,dt,Oe,Tt,le)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ce.length>0){if(Ee&&Ae){let we=Je(Ce[0]);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}for(let we=0,qe=Ce.length;we<qe;we++)se=Ce[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,Re,B,se):t.texImage2D(i.TEXTURE_2D,we,he,Re,B,se);T.generateMipmaps=!1}else if(Ee){if(Ae){let we=Je(le);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}Xe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Re,B,le)}else t.texImage2D(i.TEXTURE_2D,0,he,Re,B,le);U(T)&&T.mipmapsAutoUpdate===!0&&I(ve),Me.__version=pe.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function It(L,T,Z){if(T.image.length!==6)return;let ve=Rt(L,T),de=T.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+Z);let pe=n.get(de);if(de.version!==pe.__version||ve===!0){t.activeTexture(i.TEXTURE0+Z);let Me=St.getPrimaries(St.workingColorSpace),ae=T.colorSpace===Ii?null:St.getPrimaries(T.colorSpace),le=T.colorSpace===Ii||Me===ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,le);let Re=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,he=[];for(let Oe=0;Oe<6;Oe++)!Re&&!B?he[Oe]=P(T.image[Oe],!0,s.maxCubemapSize):he[Oe]=B?T.image[Oe].image:T.image[Oe],he[Oe]=Ze(T,he[Oe]);let se=he[0],Ce=o.convert(T.format,T.colorSpace),Ee=o.convert(T.type),Ae=N(T.internalFormat,Ce,Ee,T.normalized,T.colorSpace),Xe=T.isVideoTexture!==!0,ut=pe.__version===void 0||ve===!0,we=de.dataReady,qe=D(T,se);Et(i.TEXTURE_CUBE_MAP,T);let dt;if(T.isDepthTexture){if(Ae=b(T.format===Pi,T.type),ut)if(Xe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,se.width,se.height);else for(let Oe=0;Oe<6;Oe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,se.width,se.height,0,Ce,Ee,null)}else if(Re){Xe&&ut&&t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ae,se.width,se.height);for(let Oe=0;Oe<6;Oe++){dt=he[Oe].mipmaps;for(let Tt=0;Tt<dt.length;Tt++){let Bt=dt[Tt];T.format!==Kn?Ce!==null?Xe?we&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Bt.width,Bt.height,Ce,Bt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Bt.width,Bt.height,0,Bt.data):Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Bt.width,Bt.height,Ce,Ee,Bt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Bt.width,Bt.height,0,Ce,Ee,Bt.data)}}}else{if(dt=T.mipmaps,Xe&&ut){dt.length>0&&qe++;let Oe=Je(he[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ae,Oe.width,Oe.height)}for(let Oe=0;Oe<6;Oe++)if(B){Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,he[Oe].width,he[Oe].height,Ce,Ee,he[Oe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,he[Oe].width,he[Oe].height,0,Ce,Ee,he[Oe].data);for(let Tt=0;Tt<dt.length;Tt++){let _i=dt[Tt].image[Oe].image;Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,_i.width,_i.height,Ce,Ee,_i.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,_i.width,_i.height,0,Ce,Ee,_i.data)}}else{Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,Ce,Ee,he[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,Ce,Ee,he[Oe]);for(let Tt=0;Tt<dt.length;Tt++){let Bt=dt[Tt];Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,Ce,Ee,Bt.image[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,Ce,Ee,Bt.image[Oe])}}}U(T)&&T.mipmapsAutoUpdate===!0&&I(i.TEXTURE_CUBE_MAP),pe.__version=de.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Mt(L,T,Z,ve,de,pe){let Me=o.convert(Z.format,Z.colorSpace),ae=o.convert(Z.type),le=N(Z.internalFormat,Me,ae,Z.normalized,Z.colorSpace),Re=n.get(T),B=n.get(Z);if(B.__renderTarget=T,!Re.__hasExternalTextures){let he=Math.max(1,T.width>>pe),se=Math.max(1,T.height>>pe);de===i.TEXTURE_3D||de===i.TEXTURE_2D_ARRAY?t.texImage3D(de,pe,le,he,se,T.depth,0,Me,ae,null):t.texImage2D(de,pe,le,he,se,0,Me,ae,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,de,B.__webglTexture,0,Ut(T)):(de===i.TEXTURE_2D||de>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&de<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ve,de,B.__webglTexture,pe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(L,T,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,L),T.depthBuffer){let ve=T.depthTexture,de=ve&&ve.isDepthTexture?ve.type:null,pe=b(T.stencilBuffer,de),Me=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Le(T)?h.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,pe,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Me,i.RENDERBUFFER,L)}else{let ve=T.textures;for(let de=0;de<ve.length;de++){let pe=ve[de],Me=o.convert(pe.format,pe.colorSpace),ae=o.convert(pe.type),le=N(pe.internalFormat,Me,ae,pe.normalized,pe.colorSpace);Le(T)?h.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),le,T.width,T.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),le,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,le,T.width,T.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function De(L,T,Z){let ve=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let de=n.get(T.depthTexture);de.__renderTarget=T;let pe=ve?T.depthTexture.image[0]:T.depthTexture.image;(!de.__webglTexture||pe.width!==T.width||pe.height!==T.height)&&(pe.width=T.width,pe.height=T.height,T.depthTexture.needsUpdate=!0),ve?Ue(T.depthTexture,0):Fe(T.depthTexture,0);let Me=de.__webglTexture,ae=Ut(T),le=ve?i.TEXTURE_CUBE_MAP_POSITIVE_X+Z:i.TEXTURE_2D,Re=T.depthTexture.format===Pi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(T.depthTexture.format===Ei)Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Re,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Re,le,Me,0);else if(T.depthTexture.format===Pi)Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Re,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Re,le,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function $e(L){let T=n.get(L),Z=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==L.depthTexture){let ve=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ve){let de=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ve.removeEventListener("dispose",de)};ve.addEventListener("dispose",de),T.__depthDisposeCallback=de}T.__boundDepthTexture=ve}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)if(Z)for(let ve=0;ve<6;ve++)De(T.__webglFramebuffer[ve],L,ve);else L.texture.mipmaps.length>0?De(T.__webglFramebuffer[0],L,0):De(T.__webglFramebuffer,L,0);else if(Z){T.__webglDepthbuffer=[];for(let ve=0;ve<6;ve++)if(t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[ve]),T.__webglDepthbuffer[ve]===void 0)T.__webglDepthbuffer[ve]=i.createRenderbuffer(),rn(T.__webglDepthbuffer[ve],L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer[ve];i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=i.createRenderbuffer(),rn(T.__webglDepthbuffer,L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function hn(L,T,Z){let ve=n.get(L);T!==void 0&&Mt(ve.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&$e(L)}function sn(L){let T=L.texture,Z=n.get(L),ve=n.get(T);L.addEventListener("dispose",J),q(L);let de=L.textures,pe=L.isWebGLCubeRenderTarget===!0,Me=de.length>1;if(Me||(ve.__webglTexture===void 0&&(ve.__webglTexture=i.createTexture()),ve.__version=T.version,l.memory.textures++),pe){Z.__webglFramebuffer=[];for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0){Z.__webglFramebuffer[ae]=[];for(let le=0;le<T.mipmaps.length;le++)Z.__webglFramebuffer[ae][le]=i.createFramebuffer()}else Z.__webglFramebuffer[ae]=i.createFramebuffer()}else{if(T.mipmaps.length>0){Z.__webglFramebuffer=[];for(let ae=0;ae<T.mipmaps.length;ae++)Z.__webglFramebuffer[ae]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(Me)for(let ae=0,le=de.length;ae<le;ae++){let Re=n.get(de[ae]);Re.__webglTexture===void 0&&(Re.__webglTexture=i.createTexture(),l.memory.textures++)}if(L.samples>0&&Le(L)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let ae=0;ae<de.length;ae++){let le=de[ae];Z.__webglColorRenderbuffer[ae]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[ae]);let Re=o.convert(le.format,le.colorSpace),B=o.convert(le.type),he=N(le.internalFormat,Re,B,le.normalized,le.colorSpace,L.isXRRenderTarget===!0),se=Ut(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,se,he,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,Z.__webglColorRenderbuffer[ae])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),rn(Z.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(pe){t.bindTexture(i.TEXTURE_CUBE_MAP,ve.__webglTexture),Et(i.TEXTURE_CUBE_MAP,T);for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(Z.__webglFramebuffer[ae][le],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,le);else Mt(Z.__webglFramebuffer[ae],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0);U(T)?I(i.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let ae=0,le=de.length;ae<le;ae++){let Re=de[ae],B=n.get(Re),he=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(he=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(he,B.__webglTexture),Et(he,Re),Mt(Z.__webglFramebuffer,L,Re,i.COLOR_ATTACHMENT0+ae,he,0),U(Re)&&I(he)}t.unbindTexture()}else{let ae=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ae=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,ve.__webglTexture),Et(ae,T),T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(Z.__webglFramebuffer[le],L,T,i.COLOR_ATTACHMENT0,ae,le);else Mt(Z.__webglFramebuffer,L,T,i.COLOR_ATTACHMENT0,ae,0);U(T)?I(ae):T.mipmaps.length>0&&i.texParameteri(ae,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&$e(L)}function W(L){let T=L.textures;for(let Z=0,ve=T.length;Z<ve;Z++){let de=T[Z];if(U(de)&&de.mipmapsAutoUpdate===!0){let pe=O(L),Me=n.get(de).__webglTexture;t.bindTexture(pe,Me),I(pe),t.unbindTexture()}}}let vn=[];function Ct(L){if(L.samples>0){if(Le(L)===!1){let T=L.textures,Z=L.width,ve=L.height,de=i.COLOR_BUFFER_BIT,pe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=n.get(L),ae=T.length>1;if(ae)for(let Re=0;Re<T.length;Re++)t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let Re=0;Re<T.length;Re++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(de|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(de|=i.STENCIL_BUFFER_BIT)),ae){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Re]);let B=n.get(T[Re]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,Z,ve,0,0,Z,ve,de,i.NEAREST),f===!0&&(vn.length=0,vn.push(i.COLOR_ATTACHMENT0+Re),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&vn.push(pe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,vn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ae)for(let Re=0;Re<T.length;Re++){t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Re]);let B=n.get(T[Re]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&f){let T=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[T])}}}function Ut(L){return Math.min(s.maxSamples,L.samples)}function Le(L){let T=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function $t(L){let T=l.render.frame;m.get(L)!==T&&(m.set(L,T),L.update())}function Ze(L,T){let Z=L.colorSpace,ve=L.format,de=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Z!==Ms&&Z!==Ii&&(St.getTransfer(Z)===Pt?(ve!==Kn||de!==Tn)&&Qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",Z)),T}function Je(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(d.width=L.naturalWidth||L.width,d.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(d.width=L.displayWidth,d.height=L.displayHeight):(d.width=L.width,d.height=L.height),d}this.allocateTextureUnit=rt,this.resetTextureUnits=H,this.getTextureUnits=ge,this.setTextureUnits=We,this.setTexture2D=Fe,this.setTexture2DArray=Pe,this.setTexture3D=je,this.setTextureCube=Ue,this.rebindTextures=hn,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=Ct,this.setupDepthRenderbuffer=$e,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=Le,this.dispose=ie}function bb(i,e){function t(n,s=Ii){let o,l=St.getTransfer(s);if(n===Tn)return i.UNSIGNED_BYTE;if(n===Xo)return i.UNSIGNED_SHORT_4_4_4_4;if(n===$o)return i.UNSIGNED_SHORT_5_5_5_1;if(n===jc)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Zc)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===qc)return i.BYTE;if(n===Yc)return i.SHORT;if(n===Kr)return i.UNSIGNED_SHORT;if(n===Wo)return i.INT;if(n===Zn)return i.UNSIGNED_INT;if(n===zn)return i.FLOAT;if(n===Jn)return i.HALF_FLOAT;if(n===Jc)return i.ALPHA;if(n===Kc)return i.RGB;if(n===Kn)return i.RGBA;if(n===Ei)return i.DEPTH_COMPONENT;if(n===Pi)return i.DEPTH_STENCIL;if(n===qo)return i.RED;if(n===Yo)return i.RED_INTEGER;if(n===ji)return i.RG;if(n===jo)return i.RG_INTEGER;if(n===Zo)return i.RGBA_INTEGER;if(n===Ks||n===Qs||n===ea||n===ta)if(l===Pt)if(o=e.get("WEBGL_compressed_texture_s3tc_srgb"),o!==null){if(n===Ks)return o.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Qs)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ea)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ta)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(o=e.get("WEBGL_compressed_texture_s3tc"),o!==null){if(n===Ks)return o.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Qs)return o.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ea)return o.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ta)return o.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Jo||n===Ko||n===Qo||n===el)if(o=e.get("WEBGL_compressed_texture_pvrtc"),o!==null){if(n===Jo)return o.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ko)return o.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Qo)return o.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===el)return o.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===tl||n===nl||n===il||n===rl||n===sl||n===na||n===al)if(o=e.get("WEBGL_compressed_texture_etc"),o!==null){if(n===tl||n===nl)return l===Pt?o.COMPRESSED_SRGB8_ETC2:o.COMPRESSED_RGB8_ETC2;if(n===il)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:o.COMPRESSED_RGBA8_ETC2_EAC;if(n===rl)return o.COMPRESSED_R11_EAC;if(n===sl)return o.COMPRESSED_SIGNED_R11_EAC;if(n===na)return o.COMPRESSED_RG11_EAC;if(n===al)return o.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ol||n===ll||n===cl||n===hl||n===ul||n===dl||n===fl||n===pl||n===ml||n===gl||n===_l||n===vl||n===yl||n===xl)if(o=e.get("WEBGL_compressed_texture_astc"),o!==null){if(n===ol)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:o.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ll)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:o.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===cl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:o.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===hl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:o.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ul)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:o.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===dl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:o.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===fl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:o.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===pl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:o.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ml)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:o.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===gl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:o.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===_l)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:o.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===vl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:o.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===yl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:o.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===xl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:o.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Sl||n===Ml||n===bl)if(o=e.get("EXT_texture_compression_bptc"),o!==null){if(n===Sl)return l===Pt?o.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:o.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ml)return o.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===bl)return o.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===wl||n===El||n===ia||n===Tl)if(o=e.get("EXT_texture_compression_rgtc"),o!==null){if(n===wl)return o.COMPRESSED_RED_RGTC1_EXT;if(n===El)return o.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ia)return o.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Tl)return o.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===gr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var wb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Eb=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,xh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Os(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new di({vertexShader:wb,fragmentShader:Eb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ot(new Vi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Sh=class extends jn{constructor(e,t){super();let n=this,s=null,o=1,l=null,h="local-floor",f=1,d=null,m=null,y=null,g=null,x=null,E=null,C=typeof XRWebGLBinding<"u",S=new xh,v={},P=t.getContextAttributes(),U=null,I=null,O=[],N=[],b=new et,D=null,q=null,k=new gn;k.viewport=new Gt;let Y=new gn;Y.viewport=new Gt;let J=[k,Y],ee=new ko,z=null,ie=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Xr,O[ue]=Fe),Fe.getTargetRaySpace()},this.getControllerGrip=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Xr,O[ue]=Fe),Fe.getGripSpace()},this.getHand=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Xr,O[ue]=Fe),Fe.getHandSpace()};function G(ue){let Fe=N.indexOf(ue.inputSource);if(Fe===-1)return;let Pe=O[Fe];Pe!==void 0&&(Pe.update(ue.inputSource,ue.frame,d||l),Pe.dispatchEvent({type:ue.type,data:ue.inputSource}))}function ne(){s.removeEventListener("select",G),s.removeEventListener("selectstart",G),s.removeEventListener("selectend",G),s.removeEventListener("squeeze",G),s.removeEventListener("squeezestart",G),s.removeEventListener("squeezeend",G),s.removeEventListener("end",ne),s.removeEventListener("inputsourceschange",Se);for(let ue=0;ue<O.length;ue++){let Fe=N[ue];Fe!==null&&(N[ue]=null,O[ue].disconnect(Fe))}z=null,ie=null,S.reset();for(let ue in v)delete v[ue];if(e.setRenderTarget(U),x=null,g=null,y=null,s=null,I=null,rt.stop(),n.isPresenting=!1,e.setPixelRatio(D),e.setSize(b.width,b.height,!1),q!==null){let ue=q.camera;ue.fov=q.fov,ue.zoom=q.zoom,ue.updateProjectionMatrix(),q=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ue){o=ue,n.isPresenting===!0&&Qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ue){h=ue,n.isPresenting===!0&&Qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return d||l},this.setReferenceSpace=function(ue){d=ue},this.getBaseLayer=function(){return g!==null?g:x},this.getBinding=function(){return y===null&&C&&(y=new XRWebGLBinding(s,t)),y},this.getFrame=function(){return E},this.getSession=function(){return s},this.setSession=async function(ue){if(s=ue,s!==null){if(U=e.getRenderTarget(),s.addEventListener("select",G),s.addEventListener("selectstart",G),s.addEventListener("selectend",G),s.addEventListener("squeeze",G),s.addEventListener("squeezestart",G),s.addEventListener("squeezeend",G),s.addEventListener("end",ne),s.addEventListener("inputsourceschange",Se),P.xrCompatible!==!0&&await t.makeXRCompatible(),D=e.getPixelRatio(),e.getSize(b),C&&"createProjectionLayer"in XRWebGLBinding.prototype){let Pe=null,je=null,Ue=null;P.depth&&(Ue=P.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Pe=P.stencil?Pi:Ei,je=P.stencil?gr:Zn);let ot={colorFormat:t.RGBA8,depthFormat:Ue,scaleFactor:o};y=this.getBinding(),g=y.createProjectionLayer(ot),s.updateRenderState({layers:[g]}),e.setPixelRatio(1),e.setSize(g.textureWidth,g.textureHeight,!1),I=new Dn(g.textureWidth,g.textureHeight,{format:Kn,type:Tn,depthTexture:new Ai(g.textureWidth,g.textureHeight,je,void 0,void 0,void 0,void 0,void 0,void 0,Pe),stencilBuffer:P.stencil,colorSpace:e.outputColorSpace,samples:P.antialias?4:0,resolveDepthBuffer:g.ignoreDepthValues===!1,resolveStencilBuffer:g.ignoreDepthValues===!1,storeMultisampledDepthBuffer:g.ignoreDepthValues===!1,storeMultisampledStencilBuffer:g.ignoreDepthValues===!1})}else{let Pe={antialias:P.antialias,alpha:!0,depth:P.depth,stencil:P.stencil,framebufferScaleFactor:o};x=new XRWebGLLayer(s,t,Pe),s.updateRenderState({baseLayer:x}),e.setPixelRatio(1),e.setSize(x.framebufferWidth,x.framebufferHeight,!1),I=new Dn(x.framebufferWidth,x.framebufferHeight,{format:Kn,type:Tn,colorSpace:e.outputColorSpace,stencilBuffer:P.stencil,resolveDepthBuffer:x.ignoreDepthValues===!1,resolveStencilBuffer:x.ignoreDepthValues===!1,storeMultisampledDepthBuffer:x.ignoreDepthValues===!1,storeMultisampledStencilBuffer:x.ignoreDepthValues===!1})}I.isXRRenderTarget=!0,this.setFoveation(f),d=null,l=await s.requestReferenceSpace(h),rt.setContext(s),rt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return S.getDepthTexture()};function Se(ue){for(let Fe=0;Fe<ue.removed.length;Fe++){let Pe=ue.removed[Fe],je=N.indexOf(Pe);je>=0&&(N[je]=null,O[je].disconnect(Pe))}for(let Fe=0;Fe<ue.added.length;Fe++){let Pe=ue.added[Fe],je=N.indexOf(Pe);if(je===-1){for(let ot=0;ot<O.length;ot++)if(ot>=N.length){N.push(Pe),je=ot;break}else if(N[ot]===null){N[ot]=Pe,je=ot;break}if(je===-1)break}let Ue=O[je];Ue&&Ue.connect(Pe)}}function re(ue,Fe){Fe===null?ue.matrixWorld.copy(ue.matrix):ue.matrixWorld.multiplyMatrices(Fe.matrixWorld,ue.matrix),ue.matrixWorldInverse.copy(ue.matrixWorld).invert()}this.updateCamera=function(ue){if(s===null)return;let Fe=ue.near,Pe=ue.far;S.texture!==null&&(S.depthNear>0&&(Fe=S.depthNear),S.depthFar>0&&(Pe=S.depthFar)),ee.near=Y.near=k.near=Fe,ee.far=Y.far=k.far=Pe,(z!==ee.near||ie!==ee.far)&&(s.updateRenderState({depthNear:ee.near,depthFar:ee.far}),z=ee.near,ie=ee.far),ee.layers.mask=ue.layers.mask|6,k.layers.mask=ee.layers.mask&-5,Y.layers.mask=ee.layers.mask&-3;let je=ue.parent,Ue=ee.cameras;re(ee,je);for(let ot=0;ot<Ue.length;ot++)re(Ue[ot],je);ee.projectionMatrix.copy(k.projectionMatrix),ee.projectionMatrixInverse.copy(k.projectionMatrixInverse),q===null&&ue.isPerspectiveCamera&&(q={camera:ue,fov:ue.fov,zoom:ue.zoom}),H(ue,ee,je)};function H(ue,Fe,Pe){Pe===null?ue.matrix.copy(Fe.matrixWorld):(ue.matrix.copy(Pe.matrixWorld),ue.matrix.invert(),ue.matrix.multiply(Fe.matrixWorld)),ue.matrix.decompose(ue.position,ue.quaternion,ue.scale),ue.updateMatrixWorld(!0),ue.projectionMatrix.copy(Fe.projectionMatrix),ue.projectionMatrixInverse.copy(Fe.projectionMatrixInverse),ue.isPerspectiveCamera&&(ue.fov=Vr*2*Math.atan(1/ue.projectionMatrix.elements[5]),ue.zoom=1)}this.getCamera=function(){return ee},this.getFoveation=function(){if(!(g===null&&x===null))return f},this.setFoveation=function(ue){f=ue,g!==null&&(g.fixedFoveation=ue),x!==null&&x.fixedFoveation!==void 0&&(x.fixedFoveation=ue)},this.hasDepthSensing=function(){return S.texture!==null},this.getDepthSensingMesh=function(){return S.getMesh(ee)},this.getCameraTexture=function(ue){return v[ue]};let ge=null;function We(ue,Fe){if(m=Fe.getViewerPose(d||l),E=Fe,m!==null){let Pe=m.views;x!==null&&(e.setRenderTargetFramebuffer(I,x.framebuffer),e.setRenderTarget(I));let je=!1;Pe.length!==ee.cameras.length&&(ee.cameras.length=0,je=!0);for(let Ke=0;Ke<Pe.length;Ke++){let Et=Pe[Ke],Rt=null;if(x!==null)Rt=x.getViewport(Et);else{let Ht=y.getViewSubImage(g,Et);Rt=Ht.viewport,Ke===0&&(e.setRenderTargetTextures(I,Ht.colorTexture,Ht.depthStencilTexture),e.setRenderTarget(I))}let mt=J[Ke];mt===void 0&&(mt=new gn,mt.layers.enable(Ke),mt.viewport=new Gt,J[Ke]=mt),mt.matrix.fromArray(Et.transform.matrix),mt.matrix.decompose(mt.position,mt.quaternion,mt.scale),mt.projectionMatrix.fromArray(Et.projectionMatrix),mt.projectionMatrixInverse.copy(mt.projectionMatrix).invert(),mt.viewport.set(Rt.x,Rt.y,Rt.width,Rt.height),Ke===0&&(ee.matrix.copy(mt.matrix),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale)),je===!0&&ee.cameras.push(mt)}let Ue=s.enabledFeatures;if(Ue&&Ue.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&C){y=n.getBinding();let Ke=y.getDepthInformation(Pe[0]);Ke&&Ke.isValid&&Ke.texture&&S.init(Ke,s.renderState)}if(Ue&&Ue.includes("camera-access")&&C){e.state.unbindTexture(),y=n.getBinding();for(let Ke=0;Ke<Pe.length;Ke++){let Et=Pe[Ke].camera;if(Et){let Rt=v[Et];Rt||(Rt=new Os,v[Et]=Rt);let mt=y.getCameraImage(Et);Rt.sourceTexture=mt}}}}for(let Pe=0;Pe<O.length;Pe++){let je=N[Pe],Ue=O[Pe];je!==null&&Ue!==void 0&&Ue.update(je,Fe,d||l)}ge&&ge(ue,Fe),Fe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Fe}),E=null}let rt=new of;rt.setAnimationLoop(We),this.setAnimationLoop=function(ue){ge=ue},this.dispose=function(){}}},Tb=new Lt,_f=new ct;_f.set(-1,0,0,0,1,0,0,0,1);function Ab(i,e){function t(S,v){S.matrixAutoUpdate===!0&&S.updateMatrix(),v.value.copy(S.matrix)}function n(S,v){v.color.getRGB(S.fogColor.value,lh(i)),v.isFog?(S.fogNear.value=v.near,S.fogFar.value=v.far):v.isFogExp2&&(S.fogDensity.value=v.density)}function s(S,v,P,U,I){v.isNodeMaterial?v.uniformsNeedUpdate=!1:v.isMeshBasicMaterial?o(S,v):v.isMeshLambertMaterial?(o(S,v),v.envMap&&(S.envMapIntensity.value=v.envMapIntensity)):v.isMeshToonMaterial?(o(S,v),y(S,v)):v.isMeshPhongMaterial?(o(S,v),m(S,v),v.envMap&&(S.envMapIntensity.value=v.envMapIntensity)):v.isMeshStandardMaterial?(o(S,v),g(S,v),v.isMeshPhysicalMaterial&&x(S,v,I)):v.isMeshMatcapMaterial?(o(S,v),E(S,v)):v.isMeshDepthMaterial?o(S,v):v.isMeshDistanceMaterial?(o(S,v),C(S,v)):v.isMeshNormalMaterial?o(S,v):v.isLineBasicMaterial?(l(S,v),v.isLineDashedMaterial&&h(S,v)):v.isPointsMaterial?f(S,v,P,U):v.isSpriteMaterial?d(S,v):v.isShadowMaterial?(S.color.value.copy(v.color),S.opacity.value=v.opacity):v.isShaderMaterial&&(v.uniformsNeedUpdate=!1)}function o(S,v){S.opacity.value=v.opacity,v.color&&S.diffuse.value.copy(v.color),v.emissive&&S.emissive.value.copy(v.emissive).multiplyScalar(v.emissiveIntensity),v.map&&(S.map.value=v.map,t(v.map,S.mapTransform)),v.alphaMap&&(S.alphaMap.value=v.alphaMap,t(v.alphaMap,S.alphaMapTransform)),v.bumpMap&&(S.bumpMap.value=v.bumpMap,t(v.bumpMap,S.bumpMapTransform),S.bumpScale.value=v.bumpScale,v.side===dn&&(S.bumpScale.value*=-1)),v.normalMap&&(S.normalMap.value=v.normalMap,t(v.normalMap,S.normalMapTransform),S.normalScale.value.copy(v.normalScale),v.side===dn&&S.normalScale.value.negate()),v.displacementMap&&(S.displacementMap.value=v.displacementMap,t(v.displacementMap,S.displacementMapTransform),S.displacementScale.value=v.displacementScale,S.displacementBias.value=v.displacementBias),v.emissiveMap&&(S.emissiveMap.value=v.emissiveMap,t(v.emissiveMap,S.emissiveMapTransform)),v.specularMap&&(S.specularMap.value=v.specularMap,t(v.specularMap,S.specularMapTransform)),v.alphaTest>0&&(S.alphaTest.value=v.alphaTest);let P=e.get(v),U=P.envMap,I=P.envMapRotation;U&&(S.envMap.value=U,S.envMapRotation.value.setFromMatrix4(Tb.makeRotationFromEuler(I)).transpose(),U.isCubeTexture&&U.isRenderTargetTexture===!1&&S.envMapRotation.value.premultiply(_f),S.reflectivity.value=v.reflectivity,S.ior.value=v.ior,S.refractionRatio.value=v.refractionRatio),v.lightMap&&(S.lightMap.value=v.lightMap,S.lightMapIntensity.value=v.lightMapIntensity,t(v.lightMap,S.lightMapTransform)),v.aoMap&&(S.aoMap.value=v.aoMap,S.aoMapIntensity.value=v.aoMapIntensity,t(v.aoMap,S.aoMapTransform))}function l(S,v){S.diffuse.value.copy(v.color),S.opacity.value=v.opacity,v.map&&(S.map.value=v.map,t(v.map,S.mapTransform))}function h(S,v){S.dashSize.value=v.dashSize,S.totalSize.value=v.dashSize+v.gapSize,S.scale.value=v.scale}function f(S,v,P,U){S.diffuse.value.copy(v.color),S.opacity.value=v.opacity,S.size.value=v.size*P,S.scale.value=U*.5,v.map&&(S.map.value=v.map,t(v.map,S.uvTransform)),v.alphaMap&&(S.alphaMap.value=v.alphaMap,t(v.alphaMap,S.alphaMapTransform)),v.alphaTest>0&&(S.alphaTest.value=v.alphaTest)}function d(S,v){S.diffuse.value.copy(v.color),S.opacity.value=v.opacity,S.rotation.value=v.rotation,v.map&&(S.map.value=v.map,t(v.map,S.mapTransform)),v.alphaMap&&(S.alphaMap.value=v.alphaMap,t(v.alphaMap,S.alphaMapTransform)),v.alphaTest>0&&(S.alphaTest.value=v.alphaTest)}function m(S,v){S.specular.value.copy(v.specular),S.shininess.value=Math.max(v.shininess,1e-4)}function y(S,v){v.gradientMap&&(S.gradientMap.value=v.gradientMap)}function g(S,v){S.metalness.value=v.metalness,v.metalnessMap&&(S.metalnessMap.value=v.metalnessMap,t(v.metalnessMap,S.metalnessMapTransform)),S.roughness.value=v.roughness,v.roughnessMap&&(S.roughnessMap.value=v.roughnessMap,t(v.roughnessMap,S.roughnessMapTransform)),v.envMap&&(S.envMapIntensity.value=v.envMapIntensity)}function x(S,v,P){S.ior.value=v.ior,v.diffuseRoughness>0&&(S.diffuseRoughness.value=v.diffuseRoughness,v.diffuseRoughnessMap&&(S.diffuseRoughnessMap.value=v.diffuseRoughnessMap,t(v.diffuseRoughnessMap,S.diffuseRoughnessMapTransform))),v.sheen>0&&(S.sheenColor.value.copy(v.sheenColor).multiplyScalar(v.sheen),S.sheenRoughness.value=v.sheenRoughness,v.sheenColorMap&&(S.sheenColorMap.value=v.sheenColorMap,t(v.sheenColorMap,S.sheenColorMapTransform)),v.sheenRoughnessMap&&(S.sheenRoughnessMap.value=v.sheenRoughnessMap,t(v.sheenRoughnessMap,S.sheenRoughnessMapTransform))),v.clearcoat>0&&(S.clearcoat.value=v.clearcoat,S.clearcoatRoughness.value=v.clearcoatRoughness,v.clearcoatMap&&(S.clearcoatMap.value=v.clearcoatMap,t(v.clearcoatMap,S.clearcoatMapTransform)),v.clearcoatRoughnessMap&&(S.clearcoatRoughnessMap.value=v.clearcoatRoughnessMap,t(v.clearcoatRoughnessMap,S.clearcoatRoughnessMapTransform)),v.clearcoatNormalMap&&(S.clearcoatNormalMap.value=v.clearcoatNormalMap,t(v.clearcoatNormalMap,S.clearcoatNormalMapTransform),S.clearcoatNormalScale.value.copy(v.clearcoatNormalScale),v.side===dn&&S.clearcoatNormalScale.value.negate())),v.dispersion>0&&(S.dispersion.value=v.dispersion),v.retroreflectivity>0&&(S.retroreflectivity.value=v.retroreflectivity),v.iridescence>0&&(S.iridescence.value=v.iridescence,S.iridescenceIOR.value=v.iridescenceIOR,S.iridescenceThicknessMinimum.value=v.iridescenceThicknessMinimum,S.iridescenceThicknessMaximum.value=v.iridescenceThicknessMaximum,v.iridescenceMap&&(S.iridescenceMap.value=v.iridescenceMap,t(v.iridescenceMap,S.iridescenceMapTransform)),v.iridescenceThicknessMap&&(S.iridescenceThicknessMap.value=v.iridescenceThicknessMap,t(v.iridescenceThicknessMap,S.iridescenceThicknessMapTransform))),v.transmission>0&&(S.transmission.value=v.transmission,S.transmissionSamplerMap.value=P.texture,S.transmissionSamplerSize.value.set(P.width,P.height),v.transmissionMap&&(S.transmissionMap.value=v.transmissionMap,t(v.transmissionMap,S.transmissionMapTransform)),S.thickness.value=v.thickness,v.thicknessMap&&(S.thicknessMap.value=v.thicknessMap,t(v.thicknessMap,S.thicknessMapTransform)),S.attenuationDistance.value=v.attenuationDistance,S.attenuationColor.value.copy(v.attenuationColor)),v.anisotropy>0&&(S.anisotropyVector.value.set(v.anisotropy*Math.cos(v.anisotropyRotation),v.anisotropy*Math.sin(v.anisotropyRotation)),v.anisotropyMap&&(S.anisotropyMap.value=v.anisotropyMap,t(v.anisotropyMap,S.anisotropyMapTransform))),S.specularIntensity.value=v.specularIntensity,S.specularColor.value.copy(v.specularColor),v.specularColorMap&&(S.specularColorMap.value=v.specularColorMap,t(v.specularColorMap,S.specularColorMapTransform)),v.specularIntensityMap&&(S.specularIntensityMap.value=v.specularIntensityMap,t(v.specularIntensityMap,S.specularIntensityMapTransform))}function E(S,v){v.matcap&&(S.matcap.value=v.matcap)}function C(S,v){let P=e.get(v).light;S.referencePosition.value.setFromMatrixPosition(P.matrixWorld),S.nearDistance.value=P.shadow.camera.near,S.farDistance.value=P.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Rb(i,e,t,n){let s={},o={};function l(P,U){let I=U.program;n.uniformBlockBinding(P,I,s[P.id])}function h(P,U){let I=s[P.id];I===void 0&&(E(P),I=f(P),s[P.id]=I,P.addEventListener("dispose",S));let O=U.program;n.updateUBOMapping(P,O);let N=e.render.frame;o[P.id]!==N&&(d(P),o[P.id]=N)}function f(P){let U=i.createBuffer(),I=P.__size,O=P.usage;return i.bindBuffer(i.UNIFORM_BUFFER,U),i.bufferData(i.UNIFORM_BUFFER,I,O),i.bindBuffer(i.UNIFORM_BUFFER,null),U}function d(P){let U=s[P.id],I=P.uniforms,O=P.__cache;i.bindBuffer(i.UNIFORM_BUFFER,U);for(let N=0,b=I.length;N<b;N++){let D=I[N];if(Array.isArray(D))for(let q=0,k=D.length;q<k;q++)m(D[q],N,q,O);else m(D,N,0,O)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(P,U,I,O){if(g(P,U,I,O)===!0){let N=P.__offset,b=P.value;if(Array.isArray(b)){let D=0;for(let q=0;q<b.length;q++){let k=b[q],Y=C(k,!0);y(k,P.__data,D),D+=Y.storage/Float32Array.BYTES_PER_ELEMENT}}else y(b,P.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,N,P.__data)}}function y(P,U,I){typeof P=="number"||typeof P=="boolean"?U[I]=P:P.isMatrix3?(U[I]=P.elements[0],U[I+1]=P.elements[1],U[I+2]=P.elements[2],U[I+3]=0,U[I+4]=P.elements[3],U[I+5]=P.elements[4],U[I+6]=P.elements[5],U[I+7]=0,U[I+8]=P.elements[6],U[I+9]=P.elements[7],U[I+10]=P.elements[8],U[I+11]=0):ArrayBuffer.isView(P)?U.set(P.subarray(0,U.length-I),I):P.toArray(U,I)}function g(P,U,I,O){let N=P.value,b=U+"_"+I;if(Array.isArray(N)){O[b]===void 0&&(O[b]=[]);let D=O[b],q=!1;for(let k=0;k<N.length;k++)x(N[k],D,k)===!0&&(q=!0);return q}return x(N,O,b)}function x(P,U,I){if(U[I]===void 0)return typeof P=="number"||typeof P=="boolean"?U[I]=P:ArrayBuffer.isView(P)?U[I]=P.slice():U[I]=P.clone(),!0;{let O=U[I];if(typeof P=="number"||typeof P=="boolean"){if(O!==P)return U[I]=P,!0}else{if(ArrayBuffer.isView(P))return!0;if(O.equals(P)===!1)return O.copy(P),!0}}return!1}function E(P){let U=P.uniforms,I=0,O=16;for(let b=0,D=U.length;b<D;b++){let q=Array.isArray(U[b])?U[b]:[U[b]];for(let k=0,Y=q.length;k<Y;k++){let J=q[k],ee=Array.isArray(J.value)?J.value:[J.value],z=Array.isArray(U[b])||Array.isArray(J.value),ie=I;for(let ne=0,Se=ee.length;ne<Se;ne++){let re=ee[ne],H=C(re,z),ge=I%O,We=ge%H.boundary,rt=ge+We;I+=We,rt!==0&&O-rt<H.storage&&(I+=O-rt),ne===0&&(ie=I),I+=H.storage}let G=J.type==="int"?Int32Array:J.type==="uint"?Uint32Array:Float32Array;J.__data=new G((I-ie)/Float32Array.BYTES_PER_ELEMENT),J.__offset=ie}}let N=I%O;return N>0&&(I+=O-N),P.__size=I,P.__cache={},this}function C(P,U){let I={boundary:0,storage:0};return typeof P=="number"||typeof P=="boolean"?(I.boundary=4,I.storage=4):P.isVector2?(I.boundary=8,I.storage=8):P.isVector3||P.isColor?(I.boundary=16,I.storage=12):P.isVector4?(I.boundary=16,I.storage=16):P.isMatrix3?(I.boundary=16,I.storage=48):P.isMatrix4?(I.boundary=16,I.storage=64):P.isTexture?Qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(P)?(I.boundary=16,I.storage=P.byteLength):Qe("WebGLRenderer: Unsupported uniform value type.",P),U===!0&&(I.boundary=16,I.storage=Math.ceil(I.storage/16)*16),I}function S(P){let U=P.target;U.removeEventListener("dispose",S),i.deleteBuffer(s[U.id]),delete s[U.id],delete o[U.id]}function v(){for(let P in s)i.deleteBuffer(s[P]);s={},o={}}return{bind:l,update:h,dispose:v}}var Cb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),mi=null;function Pb(){return mi===null&&(mi=new Ps(Cb,16,16,ji,Jn),mi.name="DFG_LUT",mi.minFilter=Sn,mi.magFilter=Sn,mi.wrapS=oi,mi.wrapT=oi,mi.generateMipmaps=!1,mi.needsUpdate=!0),mi}var Cl=class{constructor(e={}){let{canvas:t=Cd(),context:n=null,depth:s=!0,stencil:o=!1,alpha:l=!1,antialias:h=!1,premultipliedAlpha:f=!0,preserveDrawingBuffer:d=!1,powerPreference:m="default",failIfMajorPerformanceCaveat:y=!1,reversedDepthBuffer:g=!1,outputBufferType:x=Tn}=e;this.isWebGLRenderer=!0;let E;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");E=n.getContextAttributes().alpha}else E=l;let C=x,S=new Set([Zo,jo,Yo]),v=new Set([Tn,Zn,Kr,gr,Xo,$o]),P=new Uint32Array(4),U=new Int32Array(4),I={textures:[],min:[],max:[],resolution:[]},O=null,N=null,b=[],D=[],q=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=pi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let k=this,Y=!1,J=null,ee=null,z=null,ie=null;this._outputColorSpace=mn;let G=0,ne=0,Se=null,re=-1,H=null,ge=new Gt,We=new Gt,rt=null,ue=new ht(0),Fe=0,Pe=t.width,je=t.height,Ue=1,ot=null,Vt=null,Ke=new Gt(0,0,Pe,je),Et=new Gt(0,0,Pe,je),Rt=!1,mt=new Gi,Ht=new So,pt=!1,It=!1,Mt=new Lt,rn=new j,De=new Gt,$e={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},hn=!1;function sn(){return Se===null?Ue:1}let W=n;function vn(R,V){return t.getContext(R,V)}let Ct,Ut,Le,$t,Ze,Je,L,T,Z,ve,de,pe,Me,ae,le,Re,B,he,se,Ce,Ee,Ae,Xe;try{let R={alpha:!0,depth:s,stencil:o,antialias:h,premultipliedAlpha:f,preserveDrawingBuffer:d,powerPreference:m,failIfMajorPerformanceCaveat:y};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",qe,!1),t.addEventListener("webglcontextrestored",dt,!1),t.addEventListener("webglcontextcreationerror",Oe,!1),W===null){let V="webgl2";if(W=vn(V,R),W===null)throw vn(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ut()}catch(R){throw t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),it("WebGLRenderer: "+R.message),R}function ut(){Ct=new GS(W),Ct.init(),Ee=new bb(W,Ct),Ut=new PS(W,Ct,e,Ee),Le=new Sb(W,Ct),Ut.reversedDepthBuffer&&g&&Le.buffers.depth.setReversed(!0),ee=W.createFramebuffer(),z=W.createFramebuffer(),ie=W.createFramebuffer(),$t=new WS(W),Ze=new ob,Je=new Mb(W,Ct,Le,Ze,Ut,Ee,$t),L=new zS(k),T=new $v(W),Ae=new RS(W,T),Z=new VS(W,T,$t,Ae),ve=new $S(W,Z,T,Ae,$t),he=new XS(W,Ut,Je),le=new IS(Ze),de=new ab(k,L,Ct,Ut,Ae,le),pe=new Ab(k,Ze),Me=new cb,ae=new mb(Ct),B=new AS(k,L,Le,ve,E,f),Re=new xb(k,ve,Ut),Xe=new Rb(W,$t,Ut,Le),se=new CS(W,Ct,$t),Ce=new HS(W,Ct,$t),$t.programs=de.programs,k.capabilities=Ut,k.extensions=Ct,k.properties=Ze,k.renderLists=Me,k.shadowMap=Re,k.state=Le,k.info=$t}C!==Tn&&(q=new YS(C,t.width,t.height,h,s,o));let we=new Sh(k,W);this.xr=we,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let R=Ct.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Ct.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return Ue},this.setPixelRatio=function(R){R!==void 0&&(Ue=R,this.setSize(Pe,je,!1))},this.getSize=function(R){return R.set(Pe,je)},this.setSize=function(R,V,te=!0){if(we.isPresenting){Qe("WebGLRenderer: Can't change size while VR device is presenting.");return}Pe=R,je=V,t.width=Math.floor(R*Ue),t.height=Math.floor(V*Ue),te===!0&&(t.style.width=R+"px",t.style.height=V+"px"),q!==null&&q.setSize(t.width,t.height),this.setViewport(0,0,R,V)},this.getDrawingBufferSize=function(R){return R.set(Pe*Ue,je*Ue).floor()},this.setDrawingBufferSize=function(R,V,te){Pe=R,je=V,Ue=te,t.width=Math.floor(R*te),t.height=Math.floor(V*te),this.setViewport(0,0,R,V)},this.setEffects=function(R){if(C===Tn){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let V=0;V<R.length;V++)if(R[V].isOutputPass===!0){Qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}q.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(ge)},this.getViewport=function(R){return R.copy(Ke)},this.setViewport=function(R,V,te,K){R.isVector4?Ke.set(R.x,R.y,R.z,R.w):Ke.set(R,V,te,K),Le.viewport(ge.copy(Ke).multiplyScalar(sn()).round())},this.getScissor=function(R){return R.copy(Et)},this.setScissor=function(R,V,te,K){R.isVector4?Et.set(R.x,R.y,R.z,R.w):Et.set(R,V,te,K),Le.scissor(We.copy(Et).multiplyScalar(sn()).round())},this.getScissorTest=function(){return Rt},this.setScissorTest=function(R){Le.setScissorTest(Rt=R)},this.setOpaqueSort=function(R){ot=R},this.setTransparentSort=function(R){Vt=R},this.getClearColor=function(R){return R.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(R=!0,V=!0,te=!0){let K=0;if(R){let $=!1;if(Se!==null){let Ie=Se.texture.format;$=S.has(Ie)}if($){let Ie=Se.texture.type,ze=v.has(Ie),Te=B.getClearColor(),Ne=B.getClearAlpha(),Ge=Te.r,st=Te.g,gt=Te.b;ze?(P[0]=Ge,P[1]=st,P[2]=gt,P[3]=Ne,W.clearBufferuiv(W.COLOR,0,P)):(U[0]=Ge,U[1]=st,U[2]=gt,U[3]=Ne,W.clearBufferiv(W.COLOR,0,U))}else K|=W.COLOR_BUFFER_BIT}V&&(K|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(K|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&W.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),J=R},this.dispose=function(){t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),B.dispose(),Me.dispose(),ae.dispose(),Je.dispose(),Ze.dispose(),L.dispose(),ve.dispose(),Z.dispose(),Ae.dispose(),Xe.dispose(),de.dispose(),we.dispose(),we.removeEventListener("sessionstart",rs),we.removeEventListener("sessionend",vi),un.stop()};function qe(R){R.preventDefault(),ih("WebGLRenderer: Context Lost."),Y=!0}function dt(){ih("WebGLRenderer: Context Restored."),Y=!1;let R=$t.autoReset,V=Re.enabled,te=Re.autoUpdate,K=Re.needsUpdate,$=Re.type;ut(),$t.autoReset=R,Re.enabled=V,Re.autoUpdate=te,Re.needsUpdate=K,Re.type=$}function Oe(R){it("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function Tt(R){let V=R.target;V.removeEventListener("dispose",Tt),Bt(V)}function Bt(R){_i(R),Ze.remove(R)}function _i(R){let V=Ze.get(R).programs;V!==void 0&&(V.forEach(function(te){de.releaseProgram(te)}),R.isShaderMaterial&&de.releaseShaderCache(R))}this.renderBufferDirect=function(R,V,te,K,$,Ie){V===null&&(V=$e);let ze=$.isMesh&&$.matrixWorld.determinantAffine()<0,Te=Ol(R,V,te,K,$);Le.setMaterial(K,ze);let Ne=te.index,Ge=1;if(K.wireframe===!0){if(Ne=Z.getWireframeAttribute(te),Ne===void 0)return;Ge=2}let st=te.drawRange,gt=te.attributes.position,Ve=st.start*Ge,lt=(st.start+st.count)*Ge;Ie!==null&&(Ve=Math.max(Ve,Ie.start*Ge),lt=Math.min(lt,(Ie.start+Ie.count)*Ge)),Ne!==null?(Ve=Math.max(Ve,0),lt=Math.min(lt,Ne.count)):gt!=null&&(Ve=Math.max(Ve,0),lt=Math.min(lt,gt.count));let Wt=lt-Ve;if(Wt<0||Wt===1/0)return;Ae.setup($,K,Te,te,Ne);let ke,Dt=se;if(Ne!==null&&(ke=T.get(Ne),Dt=Ce,Dt.setIndex(ke)),$.isMesh)K.wireframe===!0?(Le.setLineWidth(K.wireframeLinewidth*sn()),Dt.setMode(W.LINES)):Dt.setMode(W.TRIANGLES);else if($.isLine){let jt=K.linewidth;jt===void 0&&(jt=1),Le.setLineWidth(jt*sn()),$.isLineSegments?Dt.setMode(W.LINES):$.isLineLoop?Dt.setMode(W.LINE_LOOP):Dt.setMode(W.LINE_STRIP)}else $.isPoints?Dt.setMode(W.POINTS):$.isSprite&&Dt.setMode(W.TRIANGLES);if($.isBatchedMesh)if(Ct.get("WEBGL_multi_draw"))Dt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let jt=$._multiDrawStarts,He=$._multiDrawCounts,an=$._multiDrawCount,wt=Ne?T.get(Ne).bytesPerElement:1,ei=Ze.get(K).currentProgram.getUniforms();for(let on=0;on<an;on++)ei.setValue(W,"_gl_DrawID",on),Dt.render(jt[on]/wt,He[on])}else if($.isInstancedMesh)Dt.renderInstances(Ve,Wt,$.count);else if(te.isInstancedBufferGeometry){let jt=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,He=Math.min(te.instanceCount,jt);Dt.renderInstances(Ve,Wt,He)}else Dt.render(Ve,Wt)};function ye(R,V,te,K){J!==null&&R.isNodeMaterial&&J.setObject(K,R),pt===!0&&le.setState(R,te,!1),R.transparent===!0&&R.side===fi&&R.forceSinglePass===!1?(R.side=dn,R.needsUpdate=!0,Ji(R,V,K),R.side=Yi,R.needsUpdate=!0,Ji(R,V,K),R.side=fi):Ji(R,V,K)}this.compile=function(R,V,te=null){te===null&&(te=R),J!==null&&J.renderStart(R,V,te),N=ae.get(te),N.init(V),D.push(N),te.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(N.pushLight($),$.castShadow&&N.pushShadow($))}),R!==te&&R.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(N.pushLight($),$.castShadow&&N.pushShadow($))}),N.setupLights(),J!==null&&J.updateLights(N.state.lightsArray),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),pt===!0&&le.setGlobalState(this.clippingPlanes,V),J!==null&&Re.render(N.state.shadowsArray,te,V);let K=new Set;return R.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Ie=$.material;if(Ie)if(Array.isArray(Ie))for(let ze=0;ze<Ie.length;ze++){let Te=Ie[ze];ye(Te,te,V,$),K.add(Te)}else ye(Ie,te,V,$),K.add(Ie)}),N=D.pop(),J!==null&&J.renderEnd(),K},this.compileAsync=function(R,V,te=null){let K=this.compile(R,V,te);return new Promise($=>{function Ie(){if(K.forEach(function(ze){let Ne=Ze.get(ze).currentProgram;(Ne===void 0||Ne.isReady())&&K.delete(ze)}),K.size===0){$(R);return}setTimeout(Ie,10)}Ct.get("KHR_parallel_shader_compile")!==null?Ie():setTimeout(Ie,10)})};let _e=null;function Qn(R){_e&&_e(R)}function rs(){un.stop()}function vi(){un.start()}let un=new of;un.setAnimationLoop(Qn),typeof self<"u"&&un.setContext(self),this.setAnimationLoop=function(R){_e=R,we.setAnimationLoop(R),R===null?un.stop():un.start()},we.addEventListener("sessionstart",rs),we.addEventListener("sessionend",vi),this.render=function(R,V){if(V!==void 0&&V.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(Y===!0)return;J!==null&&J.renderStart(R,V);let te=we.enabled===!0&&we.isPresenting===!0,K=q!==null&&(Se===null||te)&&q.begin(k,Se);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),we.enabled===!0&&we.isPresenting===!0&&(q===null||q.isCompositing()===!1)&&(we.cameraAutoUpdate===!0&&we.updateCamera(V),V=we.getCamera()),R.isScene===!0&&R.onBeforeRender(k,R,V,Se),N=ae.get(R,D.length),N.init(V),N.state.textureUnits=Je.getTextureUnits(),D.push(N),Mt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Ht.setFromArrayCamera(V):mt.setFromProjectionMatrix(Mt,Bn,V.reversedDepth),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),O=Me.get(R,b.length),O.init(),b.push(O),this.info.render.frame++,we.enabled===!0&&we.isPresenting===!0){let ze=k.xr.getDepthSensingMesh();ze!==null&&ss(ze,V,-1/0,k.sortObjects)}ss(R,V,0,k.sortObjects),O.finish(),J!==null&&J.updateLights(N.state.lightsArray),k.sortObjects===!0&&O.sort(ot,Vt),hn=we.enabled===!1||we.isPresenting===!1||we.hasDepthSensing()===!1,hn&&B.addToRenderList(O,R),this.info.autoReset===!0&&this.info.reset(),pt===!0&&le.beginShadows();let $=N.state.shadowsArray;if(Re.render($,R,V),pt===!0&&le.endShadows(),(K&&q.hasRenderPass())===!1){let ze=O.opaque,Te=O.transmissive;if(N.setupLights(),V.isArrayCamera){let Ne=V.cameras;if(Te.length>0)for(let Ge=0,st=Ne.length;Ge<st;Ge++){let gt=Ne[Ge];Zi(ze,Te,R,gt)}hn&&B.render(R);for(let Ge=0,st=Ne.length;Ge<st;Ge++){let gt=Ne[Ge];Fn(O,R,gt,gt.viewport)}}else Te.length>0&&Zi(ze,Te,R,V),hn&&B.render(R),Fn(O,R,V)}Se!==null&&ne===0&&(Je.updateMultisampleRenderTarget(Se),Je.updateRenderTargetMipmap(Se)),K&&q.end(k),R.isScene===!0&&R.onAfterRender(k,R,V),Ae.resetDefaultState(),re=-1,H=null,D.pop(),D.length>0?(N=D[D.length-1],Je.setTextureUnits(N.state.textureUnits),pt===!0&&le.setGlobalState(k.clippingPlanes,N.state.camera)):N=null,b.pop(),b.length>0?O=b[b.length-1]:O=null,J!==null&&J.renderEnd()};function ss(R,V,te,K){if(R.visible===!1)return;if(R.layers.test(V.layers)){if(R.isGroup)te=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(V);else if(R.isLight)N.pushLight(R),R.castShadow&&N.pushShadow(R);else if(R.isSprite){let ze=V.isArrayCamera?Ht:mt;if(!R.frustumCulled||R.intersectsFrustum(ze)){K&&De.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Mt);let Te=ve.update(R),Ne=R.material;Ne.visible&&O.push(R,Te,Ne,te,De.z,null,V)}}else if(R.isMesh||R.isLine||R.isPoints){let ze=V.isArrayCamera?Ht:mt;if(!R.frustumCulled||R.intersectsFrustum(ze)){let Te=ve.update(R),Ne=R.material;if(K&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),De.copy(R.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),De.copy(Te.boundingSphere.center)),De.applyMatrix4(R.matrixWorld).applyMatrix4(Mt)),Array.isArray(Ne)){let Ge=Te.groups;for(let st=0,gt=Ge.length;st<gt;st++){let Ve=Ge[st],lt=Ne[Ve.materialIndex];lt&&lt.visible&&O.push(R,Te,lt,te,De.z,Ve,V)}}else Ne.visible&&O.push(R,Te,Ne,te,De.z,null,V)}}}let Ie=R.children;for(let ze=0,Te=Ie.length;ze<Te;ze++)ss(Ie[ze],V,te,K)}function Fn(R,V,te,K){let{opaque:$,transmissive:Ie,transparent:ze}=R;N.setupLightsView(te),pt===!0&&le.setGlobalState(k.clippingPlanes,te),K&&Le.viewport(ge.copy(K)),$.length>0&&yr($,V,te),Ie.length>0&&yr(Ie,V,te),ze.length>0&&yr(ze,V,te),Le.buffers.depth.setTest(!0),Le.buffers.depth.setMask(!0),Le.buffers.color.setMask(!0),Le.setPolygonOffset(!1)}function Zi(R,V,te,K){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(N.state.transmissionRenderTarget[K.id]===void 0){let Ve=Ct.has("EXT_color_buffer_half_float")||Ct.has("EXT_color_buffer_float");N.state.transmissionRenderTarget[K.id]=new Dn(1,1,{generateMipmaps:!0,type:Ve?Jn:Tn,minFilter:Ci,samples:Math.max(4,Ut.samples),stencilBuffer:o,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ie=N.state.transmissionRenderTarget[K.id],ze=K.viewport||ge;Ie.setSize(ze.z*k.transmissionResolutionScale,ze.w*k.transmissionResolutionScale);let Te=k.getRenderTarget(),Ne=k.getActiveCubeFace(),Ge=k.getActiveMipmapLevel();k.setRenderTarget(Ie),k.getClearColor(ue),Fe=k.getClearAlpha(),Fe<1&&k.setClearColor(16777215,.5),k.clear(),hn&&B.render(te);let st=k.toneMapping;k.toneMapping=pi;let gt=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),N.setupLightsView(K),pt===!0&&le.setGlobalState(k.clippingPlanes,K),yr(R,te,K),Je.updateMultisampleRenderTarget(Ie),Je.updateRenderTargetMipmap(Ie),Ct.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let lt=0,Wt=V.length;lt<Wt;lt++){let ke=V[lt],{object:Dt,geometry:jt,material:He,group:an}=ke;if(He.side===fi&&Dt.layers.test(K.layers)){let wt=He.side;He.side=dn,He.needsUpdate=!0,fa(Dt,te,K,jt,He,an),He.side=wt,He.needsUpdate=!0,Ve=!0}}Ve===!0&&(Je.updateMultisampleRenderTarget(Ie),Je.updateRenderTargetMipmap(Ie))}k.setRenderTarget(Te,Ne,Ge),k.setClearColor(ue,Fe),gt!==void 0&&(K.viewport=gt),k.toneMapping=st}function yr(R,V,te){let K=V.isScene===!0?V.overrideMaterial:null;for(let $=0,Ie=R.length;$<Ie;$++){let ze=R[$],{object:Te,geometry:Ne,group:Ge}=ze,st=ze.material;st.allowOverride===!0&&K!==null&&(st=K),Te.layers.test(te.layers)&&fa(Te,V,te,Ne,st,Ge)}}function fa(R,V,te,K,$,Ie){J!==null&&$.isNodeMaterial&&J.setObject(R,$),R.onBeforeRender(k,V,te,K,$,Ie),R.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),$.onBeforeRender(k,V,te,K,R,Ie),$.transparent===!0&&$.side===fi&&$.forceSinglePass===!1?($.side=dn,$.needsUpdate=!0,k.renderBufferDirect(te,V,K,$,R,Ie),$.side=Yi,$.needsUpdate=!0,k.renderBufferDirect(te,V,K,$,R,Ie),$.side=fi):k.renderBufferDirect(te,V,K,$,R,Ie),R.onAfterRender(k,V,te,K,$,Ie)}function Nn(R){let V=0;for(let te of R)te.texture!==null&&V++;return V}function Ji(R,V,te){V.isScene!==!0&&(V=$e);let K=Ze.get(R),$=N.state.lights,Ie=N.state.shadowsArray,ze=$.state.version,Te=de.getParameters(R,$.state,Ie,V,te,N.state.lightProbeGridArray),Ne=de.getProgramCacheKey(Te),Ge=K.programs;K.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?V.environment:null,K.fog=V.fog;let st=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;K.envMap=L.get(R.envMap||K.environment,st),K.envMapRotation=K.environment!==null&&R.envMap===null?V.environmentRotation:R.envMapRotation,Ge===void 0&&(R.addEventListener("dispose",Tt),Ge=new Map,K.programs=Ge,K.programVariants=new Map);let gt=Ge.get(Ne);if(gt!==void 0){if(K.currentProgram===gt&&K.lightsStateVersion===ze)return Sr(R,Te),gt}else Te.uniforms=de.getUniforms(R),J!==null&&R.isNodeMaterial&&J.build(R,te,Te),R.onBeforeCompile(Te,k),gt=de.acquireProgram(Te,Ne),Ge.set(Ne,gt),K.uniforms=Te.uniforms;let Ve=K.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ve.clippingPlanes=le.uniform),Sr(R,Te),K.needsLights=kl(R),K.lightsStateVersion=ze,K.needsLights&&(Ve.ambientLightColor.value=$.state.ambient,Ve.lightProbe.value=$.state.probe,Ve.sunLights.value=$.state.sun,Ve.sunLightShadows.value=$.state.sunShadow,Ve.directionalLights.value=$.state.directional,Ve.directionalLightShadows.value=$.state.directionalShadow,Ve.spotLights.value=$.state.spot,Ve.spotLightShadows.value=$.state.spotShadow,Ve.rectAreaLights.value=$.state.rectArea,Ve.ltc_1.value=$.state.rectAreaLTC1,Ve.ltc_2.value=$.state.rectAreaLTC2,Ve.pointLights.value=$.state.point,Ve.pointLightShadows.value=$.state.pointShadow,Ve.hemisphereLights.value=$.state.hemi,Ve.sunShadowMatrix.value=$.state.sunShadowMatrix,Ve.sunShadowCascade.value=$.state.sunShadowCascade,Ve.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Ve.spotLightMatrix.value=$.state.spotLightMatrix,Ve.spotLightMap.value=$.state.spotLightMap,Ve.pointShadowMatrix.value=$.state.pointShadowMatrix),K.numLightProbeGrids=Nn(N.state.lightProbeGridArray),K.currentProgram=gt,K.uniformsList=null,gt}function xr(R,V,te,K,$){let Ie=Ze.get(R),ze=Ie.currentProgram.id+","+K+","+$,Te=Ie.programVariants.get(ze);return Te===void 0?(Te=Ji(R,V,te),Ie.programVariants.set(ze,Te)):(Ie.currentProgram=Te,Ie.uniformsList=null,Ie.outputColorSpace=K,Ie.toneMapping=$),Te}function Ki(R){if(R.uniformsList===null){let V=R.currentProgram.getUniforms();R.uniformsList=es.seqWithValue(V.seq,R.uniforms)}return R.uniformsList}function Sr(R,V){let te=Ze.get(R);te.outputColorSpace=V.outputColorSpace,te.batching=V.batching,te.batchingColor=V.batchingColor,te.instancing=V.instancing,te.instancingColor=V.instancingColor,te.instancingMorph=V.instancingMorph,te.skinning=V.skinning,te.morphTargets=V.morphTargets,te.morphNormals=V.morphNormals,te.morphColors=V.morphColors,te.morphTargetsCount=V.morphTargetsCount,te.numClippingPlanes=V.numClippingPlanes,te.numIntersection=V.numClipIntersection,te.vertexAlphas=V.vertexAlphas,te.vertexTangents=V.vertexTangents,te.toneMapping=V.toneMapping}function Ol(R,V,te,K,$){V.isScene!==!0&&(V=$e),Je.resetTextureUnits();let Ie=V.fog,ze=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?V.environment:null,Te=Se===null?k.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:St.workingColorSpace,Ne=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ge=L.get(K.envMap||ze,Ne),st=K.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,gt=!!te.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),Ve=!!te.morphAttributes.position,lt=!!te.morphAttributes.normal,Wt=!!te.morphAttributes.color,ke=pi;K.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ke=k.toneMapping);let Dt=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,jt=Dt!==void 0?Dt.length:0,He=Ze.get(K),an=N.state.lights;if(pt===!0&&(It===!0||R!==H)){let Ft=R===H&&K.id===re;le.setState(K,R,Ft)}let wt=!1,ei=!1;K.version===He.__version?He.needsLights&&He.lightsStateVersion!==an.state.version||$.isBatchedMesh&&He.batching===!1||!$.isBatchedMesh&&He.batching===!0||$.isBatchedMesh&&He.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&He.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&He.instancing===!1||!$.isInstancedMesh&&He.instancing===!0||$.isSkinnedMesh&&He.skinning===!1||!$.isSkinnedMesh&&He.skinning===!0||$.isInstancedMesh&&He.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&He.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&He.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&He.instancingMorph===!1&&$.morphTexture!==null||He.envMap!==Ge||K.fog===!0&&He.fog!==Ie||He.numClippingPlanes!==void 0&&(He.numClippingPlanes!==le.numPlanes||He.numIntersection!==le.numIntersection)||He.vertexAlphas!==st||He.vertexTangents!==gt||He.morphTargets!==Ve||He.morphNormals!==lt||He.morphColors!==Wt||He.morphTargetsCount!==jt||He.numLightProbeGrids!==Nn(N.state.lightProbeGridArray)?wt=!0:(He.outputColorSpace!==Te||He.toneMapping!==ke)&&(ei=!0):(wt=!0,He.__version=K.version);let on=He.currentProgram;(wt===!0||ei===!0)&&(on=ei===!0?xr(K,V,$,Te,ke):Ji(K,V,$),J&&K.isNodeMaterial&&J.onUpdateProgram(K,on,He));let Di=!1,ti=!1,ni=!1,M=on.getUniforms(),ft=He.uniforms;if(Le.useProgram(on.program)&&(Di=!0,ti=!0,ni=!0),K.id!==re&&(re=K.id,ti=!0),Di||H!==R){Le.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),M.setValue(W,"projectionMatrix",R.projectionMatrix),M.setValue(W,"viewMatrix",R.matrixWorldInverse);let kt=M.map.cameraPosition;kt!==void 0&&kt.setValue(W,rn.setFromMatrixPosition(R.matrixWorld)),Ut.logarithmicDepthBuffer&&M.setValue(W,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&M.setValue(W,"isOrthographic",R.isOrthographicCamera===!0),H!==R&&(H=R,ti=!0,ni=!0)}if(He.needsLights&&(an.state.sunShadowMap.length>0&&M.setValue(W,"sunShadowMap",an.state.sunShadowMap,Je),an.state.directionalShadowMap.length>0&&M.setValue(W,"directionalShadowMap",an.state.directionalShadowMap,Je),an.state.spotShadowMap.length>0&&M.setValue(W,"spotShadowMap",an.state.spotShadowMap,Je),an.state.pointShadowMap.length>0&&M.setValue(W,"pointShadowMap",an.state.pointShadowMap,Je)),$.isSkinnedMesh){M.setOptional(W,$,"bindMatrix"),M.setOptional(W,$,"bindMatrixInverse");let Ft=$.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),M.setValue(W,"boneTexture",Ft.boneTexture,Je))}$.isBatchedMesh&&(M.setOptional(W,$,"batchingTexture"),M.setValue(W,"batchingTexture",$._matricesTexture,Je),M.setOptional(W,$,"batchingIdTexture"),M.setValue(W,"batchingIdTexture",$._indirectTexture,Je),M.setOptional(W,$,"batchingColorTexture"),$._colorsTexture!==null&&M.setValue(W,"batchingColorTexture",$._colorsTexture,Je));let Rn=te.morphAttributes;if((Rn.position!==void 0||Rn.normal!==void 0||Rn.color!==void 0)&&he.update($,te,on),(ti||He.receiveShadow!==$.receiveShadow)&&(He.receiveShadow=$.receiveShadow,M.setValue(W,"receiveShadow",$.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&V.environment!==null&&(ft.envMapIntensity.value=V.environmentIntensity),ft.dfgLUT!==void 0&&(ft.dfgLUT.value=Pb()),ti){if(M.setValue(W,"toneMappingExposure",k.toneMappingExposure),He.needsLights&&Bl(ft,ni),Ie&&K.fog===!0&&pe.refreshFogUniforms(ft,Ie),pe.refreshMaterialUniforms(ft,K,Ue,je,N.state.transmissionRenderTarget[R.id]),He.needsLights&&He.numLightProbeGrids>0){let Ft=I,kt=0;for(let Vn of N.state.lightProbeGridArray)Vn.texture!==null&&(Ft.textures[kt]=Vn.texture,Ft.min[kt]=Vn.boundingBox.min,Ft.max[kt]=Vn.boundingBox.max,Ft.resolution[kt]=Vn.resolution,kt++);for(let Vn in Ft)Ft[Vn].length=kt;ft.probesSH.value=Ft.textures,ft.probesMin.value=Ft.min,ft.probesMax.value=Ft.max,ft.probesResolution.value=Ft.resolution}es.upload(W,Ki(He),ft,Je)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(es.upload(W,Ki(He),ft,Je),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&M.setValue(W,"center",$.center),M.setValue(W,"modelViewMatrix",$.modelViewMatrix),M.setValue(W,"normalMatrix",$.normalMatrix),M.setValue(W,"modelMatrix",$.matrixWorld),K.uniformsGroups!==void 0){let Ft=K.uniformsGroups;for(let kt=0,Vn=Ft.length;kt<Vn;kt++){let pa=Ft[kt];Xe.update(pa,on),Xe.bind(pa,on)}}return on}function Bl(R,V){R.ambientLightColor.needsUpdate=V,R.lightProbe.needsUpdate=V,R.sunLights.needsUpdate=V,R.sunLightShadows.needsUpdate=V,R.directionalLights.needsUpdate=V,R.directionalLightShadows.needsUpdate=V,R.pointLights.needsUpdate=V,R.pointLightShadows.needsUpdate=V,R.spotLights.needsUpdate=V,R.spotLightShadows.needsUpdate=V,R.rectAreaLights.needsUpdate=V,R.hemisphereLights.needsUpdate=V}function kl(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return ne},this.getRenderTarget=function(){return Se},this.setRenderTargetTextures=function(R,V,te){let K=Ze.get(R);K.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Ze.get(R.texture).__webglTexture=V,Ze.get(R.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:te,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,V){let te=Ze.get(R);te.__webglFramebuffer=V,te.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(R,V=0,te=0){Se=R,G=V,ne=te;let K=null,$=!1,Ie=!1;if(R){let Te=Ze.get(R);if(Te.__useDefaultFramebuffer!==void 0){Le.bindFramebuffer(W.FRAMEBUFFER,Te.__webglFramebuffer),ge.copy(R.viewport),We.copy(R.scissor),rt=R.scissorTest,Le.viewport(ge),Le.scissor(We),Le.setScissorTest(rt),re=-1;return}else if(Te.__webglFramebuffer===void 0)Je.setupRenderTarget(R);else if(Te.__hasExternalTextures)Je.rebindTextures(R,Ze.get(R.texture).__webglTexture,Ze.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let st=R.depthTexture;if(Te.__boundDepthTexture!==st){if(st!==null&&Ze.has(st)&&(R.width!==st.image.width||R.height!==st.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Je.setupDepthRenderbuffer(R)}}let Ne=R.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ie=!0);let Ge=Ze.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Ge[V])?K=Ge[V][te]:K=Ge[V],$=!0):R.samples>0&&Je.useMultisampledRTT(R)===!1?K=Ze.get(R).__webglMultisampledFramebuffer:Array.isArray(Ge)?K=Ge[te]:K=Ge,ge.copy(R.viewport),We.copy(R.scissor),rt=R.scissorTest}else ge.copy(Ke).multiplyScalar(Ue).floor(),We.copy(Et).multiplyScalar(Ue).floor(),rt=Rt;if(te!==0&&(K=ee),Le.bindFramebuffer(W.FRAMEBUFFER,K)&&Le.drawBuffers(R,K),Le.viewport(ge),Le.scissor(We),Le.setScissorTest(rt),$){let Te=Ze.get(R.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+V,Te.__webglTexture,te)}else if(Ie){let Te=V;for(let Ne=0;Ne<R.textures.length;Ne++){let Ge=Ze.get(R.textures[Ne]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,te,Te)}}else if(R!==null&&te!==0){let Te=Ze.get(R.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Te.__webglTexture,te)}re=-1};function as(R){let V=Ze.get(R);return(V.__readFormat!==R.format||V.__readType!==R.type)&&(V.__readFormat=R.format,V.__readType=R.type,V.__formatReadable=Ut.textureFormatReadable(R.format),V.__typeReadable=Ut.textureTypeReadable(R.type)),V}this.readRenderTargetPixels=function(R,V,te,K,$,Ie,ze,Te=0){if(!(R&&R.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ze.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);try{let Ge=R.textures[Te],st=Ge.format,gt=Ge.type;R.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=as(Ge);if(Ve.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=R.width-K&&te>=0&&te<=R.height-$&&W.readPixels(V,te,K,$,Ee.convert(st),Ee.convert(gt),Ie)}finally{let Ge=Se!==null?Ze.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(R,V,te,K,$,Ie,ze,Te=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ze.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(V>=0&&V<=R.width-K&&te>=0&&te<=R.height-$){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);let Ge=R.textures[Te],st=Ge.format,gt=Ge.type;R.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=as(Ge);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let lt=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.bufferData(W.PIXEL_PACK_BUFFER,Ie.byteLength,W.STREAM_READ),W.readPixels(V,te,K,$,Ee.convert(st),Ee.convert(gt),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let Wt=Se!==null?Ze.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Wt);let ke=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await Id(W,ke,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,Ie),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(lt),W.deleteSync(ke),Ie}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,V=null,te=0){let K=Math.pow(2,-te),$=Math.floor(R.image.width*K),Ie=Math.floor(R.image.height*K),ze=V!==null?V.x:0,Te=V!==null?V.y:0;Je.setTexture2D(R,0),W.copyTexSubImage2D(W.TEXTURE_2D,te,0,0,ze,Te,$,Ie),Le.unbindTexture()},this.copyTextureToTexture=function(R,V,te=null,K=null,$=0,Ie=0){let ze,Te,Ne,Ge,st,gt,Ve,lt,Wt,ke=R.isCompressedTexture?R.mipmaps[Ie]:R.image;if(te!==null)ze=te.max.x-te.min.x,Te=te.max.y-te.min.y,Ne=te.isBox3?te.max.z-te.min.z:1,Ge=te.min.x,st=te.min.y,gt=te.isBox3?te.min.z:0;else{let M=Math.pow(2,-$);ze=Math.floor(ke.width*M),Te=Math.floor(ke.height*M),R.isDataArrayTexture?Ne=ke.depth:R.isData3DTexture?Ne=Math.floor(ke.depth*M):Ne=1,Ge=0,st=0,gt=0}K!==null?(Ve=K.x,lt=K.y,Wt=K.z):(Ve=0,lt=0,Wt=0);let Dt=Ee.convert(V.format),jt=Ee.convert(V.type),He;V.isData3DTexture?(Je.setTexture3D(V,0),He=W.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Je.setTexture2DArray(V,0),He=W.TEXTURE_2D_ARRAY):(Je.setTexture2D(V,0),He=W.TEXTURE_2D),Le.activeTexture(W.TEXTURE0),Le.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,V.flipY),Le.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Le.pixelStorei(W.UNPACK_ALIGNMENT,V.unpackAlignment);let an=Le.getParameter(W.UNPACK_ROW_LENGTH),wt=Le.getParameter(W.UNPACK_IMAGE_HEIGHT),ei=Le.getParameter(W.UNPACK_SKIP_PIXELS),on=Le.getParameter(W.UNPACK_SKIP_ROWS),Di=Le.getParameter(W.UNPACK_SKIP_IMAGES);Le.pixelStorei(W.UNPACK_ROW_LENGTH,ke.width),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,ke.height),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,Ge),Le.pixelStorei(W.UNPACK_SKIP_ROWS,st),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,gt);let ti=R.isDataArrayTexture||R.isData3DTexture,ni=V.isDataArrayTexture||V.isData3DTexture;if(R.isDepthTexture){let M=Ze.get(R),ft=Ze.get(V),Rn=Ze.get(M.__renderTarget),Ft=Ze.get(ft.__renderTarget);Le.bindFramebuffer(W.READ_FRAMEBUFFER,Rn.__webglFramebuffer),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let kt=0;kt<Ne;kt++)ti&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Ze.get(R).__webglTexture,$,gt+kt),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Ze.get(V).__webglTexture,Ie,Wt+kt)),W.blitFramebuffer(Ge,st,Ge+ze,st+Te,Ve,lt,Ve+ze,lt+Te,W.DEPTH_BUFFER_BIT,W.NEAREST);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if($!==0||R.isRenderTargetTexture||Ze.has(R)){let M=Ze.get(R),ft=Ze.get(V);Le.bindFramebuffer(W.READ_FRAMEBUFFER,z),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,ie);for(let Rn=0;Rn<Ne;Rn++)ti?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,M.__webglTexture,$,gt+Rn):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,M.__webglTexture,$),ni?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,ft.__webglTexture,Ie,Wt+Rn):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,ft.__webglTexture,Ie),$!==0?W.blitFramebuffer(Ge,st,Ge+ze,st+Te,Ve,lt,Ve+ze,lt+Te,W.COLOR_BUFFER_BIT,W.NEAREST):ni?W.copyTexSubImage3D(He,Ie,Ve,lt,Wt+Rn,Ge,st,ze,Te):W.copyTexSubImage2D(He,Ie,Ve,lt,Ge,st,ze,Te);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else ni?R.isDataTexture||R.isData3DTexture?W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke.data):V.isCompressedArrayTexture?W.compressedTexSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,ke.data):W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke):R.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke.data):R.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ke.width,ke.height,Dt,ke.data):W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke);Le.pixelStorei(W.UNPACK_ROW_LENGTH,an),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,wt),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,ei),Le.pixelStorei(W.UNPACK_SKIP_ROWS,on),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,Di),Ie===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&W.generateMipmap(He),Le.unbindTexture()},this.initRenderTarget=function(R){Ze.get(R).__webglFramebuffer===void 0&&Je.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Je.setTextureCube(R,0):R.isData3DTexture?Je.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Je.setTexture2DArray(R,0):Je.setTexture2D(R,0),Le.unbindTexture()},this.resetState=function(){G=0,ne=0,Se=null,Le.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var vf={type:"change"},bh={type:"start"},xf={type:"end"},Dl=new zi,yf=new In,Db=Math.cos(70*oh.DEG2RAD),nn=new j,An=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Mh=1e-6,Ll=class extends js{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new j,this.cursor=new j,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:$i.ROTATE,MIDDLE:$i.DOLLY,RIGHT:$i.PAN},this.touches={ONE:qi.ROTATE,TWO:qi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new j,this._lastQuaternion=new Mn,this._lastTargetPosition=new j,this._quat=new Mn().setFromUnitVectors(e.up,new j(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Yr,this._sphericalDelta=new Yr,this._scale=1,this._panOffset=new j,this._rotateStart=new et,this._rotateEnd=new et,this._rotateDelta=new et,this._panStart=new et,this._panEnd=new et,this._panDelta=new et,this._dollyStart=new et,this._dollyEnd=new et,this._dollyDelta=new et,this._dollyDirection=new j,this._mouse=new et,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Fb.bind(this),this._onPointerDown=Lb.bind(this),this._onPointerUp=Nb.bind(this),this._onContextMenu=Vb.bind(this),this._onMouseWheel=Bb.bind(this),this._onKeyDown=kb.bind(this),this._onTouchStart=zb.bind(this),this._onTouchMove=Gb.bind(this),this._onMouseDown=Ub.bind(this),this._onMouseMove=Ob.bind(this),this._interceptControlDown=Hb.bind(this),this._interceptControlUp=Wb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(vf),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;nn.copy(t).sub(this.target),nn.applyQuaternion(this._quat),this._spherical.setFromVector3(nn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=An:n>Math.PI&&(n-=An),s<-Math.PI?s+=An:s>Math.PI&&(s-=An),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let o=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let l=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),o=l!=this._spherical.radius}if(nn.setFromSpherical(this._spherical),nn.applyQuaternion(this._quatInverse),t.copy(this.target).add(nn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let l=null;if(this.object.isPerspectiveCamera){let h=nn.length();l=this._clampDistance(h*this._scale);let f=h-l;this.object.position.addScaledVector(this._dollyDirection,f),this.object.updateMatrixWorld(),o=!!f}else if(this.object.isOrthographicCamera){let h=new j(this._mouse.x,this._mouse.y,0);h.unproject(this.object);let f=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),o=f!==this.object.zoom;let d=new j(this._mouse.x,this._mouse.y,0);d.unproject(this.object),this.object.position.sub(d).add(h),this.object.updateMatrixWorld(),l=nn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;l!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(l).add(this.object.position):(Dl.origin.copy(this.object.position),Dl.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Dl.direction))<Db?this.object.lookAt(this.target):(yf.setFromNormalAndCoplanarPoint(this.object.up,this.target),Dl.intersectPlane(yf,this.target))))}else if(this.object.isOrthographicCamera){let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),l!==this.object.zoom&&(this.object.updateProjectionMatrix(),o=!0)}return this._scale=1,this._performCursorZoom=!1,o||this._lastPosition.distanceToSquared(this.object.position)>Mh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Mh||this._lastTargetPosition.distanceToSquared(this.target)>Mh?(this.dispatchEvent(vf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?An/60*this.autoRotateSpeed*e:An/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){nn.setFromMatrixColumn(t,0),nn.multiplyScalar(-e),this._panOffset.add(nn)}_panUp(e,t){this.screenSpacePanning===!0?nn.setFromMatrixColumn(t,1):(nn.setFromMatrixColumn(t,0),nn.crossVectors(this.object.up,nn)),nn.multiplyScalar(e),this._panOffset.add(nn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;nn.copy(s).sub(this.target);let o=nn.length();o*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*o/n.clientHeight,this.object.matrix),this._panUp(2*t*o/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,o=t-n.top,l=n.width,h=n.height;this._mouse.x=s/l*2-1,this._mouse.y=-(o/h)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(An*this._rotateDelta.x/t.clientHeight),this._rotateUp(An*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,o=Math.sqrt(n*n+s*s);this._dollyStart.set(0,o)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),o=.5*(e.pageY+n.y);this._rotateEnd.set(s,o)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(An*this._rotateDelta.x/t.clientHeight),this._rotateUp(An*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,o=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,o),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let l=(e.pageX+t.x)*.5,h=(e.pageY+t.y)*.5;this._updateZoomParameters(l,h)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new et,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Lb(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Fb(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function Nb(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(xf),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Ub(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case $i.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=At.DOLLY;break;case $i.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}break;case $i.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(bh)}function Ob(i){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function Bb(i){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(i.preventDefault(),this.dispatchEvent(bh),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(xf))}function kb(i){this.enabled!==!1&&this._handleKeyDown(i)}function zb(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case qi.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(i),this.state=At.TOUCH_ROTATE;break;case qi.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(i),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case qi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=At.TOUCH_DOLLY_PAN;break;case qi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(bh)}function Gb(i){switch(this._trackPointer(i),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=At.NONE}}function Vb(i){this.enabled!==!1&&i.preventDefault()}function Hb(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Wb(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ca=new j;function Gn(i,e,t,n,s,o){let l=2*Math.PI*s/4,h=Math.max(o-2*s,0),f=Math.PI/4;ca.copy(e),ca[n]=0,ca.normalize();let d=.5*l/(l+h),m=1-ca.angleTo(i)/f;return Math.sign(ca[t])===1?m*d:h/(l+h)+d+d*(1-m)}var Fl=class i extends ui{constructor(e=1,t=1,n=1,s=2,o=.1){let l=s*2+1;if(o=Math.min(e/2,t/2,n/2,o),super(1,1,1,l,l,l),this.type="RoundedBoxGeometry",this.parameters={width:e,height:t,depth:n,segments:s,radius:o},l===1)return;let h=this.toNonIndexed();this.index=null,this.attributes.position=h.attributes.position,this.attributes.normal=h.attributes.normal,this.attributes.uv=h.attributes.uv;let f=new j,d=new j,m=new j(e,t,n).divideScalar(2).subScalar(o),y=this.attributes.position.array,g=this.attributes.normal.array,x=this.attributes.uv.array,E=y.length/6,C=new j,S=.5/l;for(let v=0,P=0;v<y.length;v+=3,P+=2)switch(f.fromArray(y,v),d.copy(f),d.x-=Math.sign(d.x)*S,d.y-=Math.sign(d.y)*S,d.z-=Math.sign(d.z)*S,d.normalize(),y[v+0]=m.x*Math.sign(f.x)+d.x*o,y[v+1]=m.y*Math.sign(f.y)+d.y*o,y[v+2]=m.z*Math.sign(f.z)+d.z*o,g[v+0]=d.x,g[v+1]=d.y,g[v+2]=d.z,Math.floor(v/E)){case 0:C.set(1,0,0),x[P+0]=Gn(C,d,"z","y",o,n),x[P+1]=1-Gn(C,d,"y","z",o,t);break;case 1:C.set(-1,0,0),x[P+0]=1-Gn(C,d,"z","y",o,n),x[P+1]=1-Gn(C,d,"y","z",o,t);break;case 2:C.set(0,1,0),x[P+0]=1-Gn(C,d,"x","z",o,e),x[P+1]=Gn(C,d,"z","x",o,n);break;case 3:C.set(0,-1,0),x[P+0]=1-Gn(C,d,"x","z",o,e),x[P+1]=1-Gn(C,d,"z","x",o,n);break;case 4:C.set(0,0,1),x[P+0]=1-Gn(C,d,"x","y",o,e),x[P+1]=1-Gn(C,d,"y","x",o,t);break;case 5:C.set(0,0,-1),x[P+0]=Gn(C,d,"x","y",o,e),x[P+1]=1-Gn(C,d,"y","x",o,t);break}}static fromJSON(e){return new i(e.width,e.height,e.depth,e.segments,e.radius)}};var Nl=class extends hr{constructor(){super(),this.name="RoomEnvironment",this.position.y=-3.5;let e=new ui;e.deleteAttribute("uv");let t=new Ri({side:dn}),n=new Ri,s=new Ws(16777215,900,28,2);s.position.set(.418,16.199,.3),this.add(s);let o=new Ot(e,t);o.position.set(-.757,13.219,.717),o.scale.set(31.713,28.305,28.591),this.add(o);let l=new Ds(e,n,6),h=new Qt;h.position.set(-10.906,2.009,1.846),h.rotation.set(0,-.195,0),h.scale.set(2.328,7.905,4.651),h.updateMatrix(),l.setMatrixAt(0,h.matrix),h.position.set(-5.607,-.754,-.758),h.rotation.set(0,.994,0),h.scale.set(1.97,1.534,3.955),h.updateMatrix(),l.setMatrixAt(1,h.matrix),h.position.set(6.167,.857,7.803),h.rotation.set(0,.561,0),h.scale.set(3.927,6.285,3.687),h.updateMatrix(),l.setMatrixAt(2,h.matrix),h.position.set(-2.017,.018,6.124),h.rotation.set(0,.333,0),h.scale.set(2.002,4.566,2.064),h.updateMatrix(),l.setMatrixAt(3,h.matrix),h.position.set(2.291,-.756,-2.621),h.rotation.set(0,-.286,0),h.scale.set(1.546,1.552,1.496),h.updateMatrix(),l.setMatrixAt(4,h.matrix),h.position.set(-2.193,-.369,-5.547),h.rotation.set(0,.516,0),h.scale.set(3.875,3.487,2.986),h.updateMatrix(),l.setMatrixAt(5,h.matrix),this.add(l);let f=new Ot(e,is(50));f.position.set(-16.116,14.37,8.208),f.scale.set(.1,2.428,2.739),this.add(f);let d=new Ot(e,is(50));d.position.set(-16.109,18.021,-8.207),d.scale.set(.1,2.425,2.751),this.add(d);let m=new Ot(e,is(17));m.position.set(14.904,12.198,-1.832),m.scale.set(.15,4.265,6.331),this.add(m);let y=new Ot(e,is(43));y.position.set(-.462,8.89,14.52),y.scale.set(4.38,5.441,.088),this.add(y);let g=new Ot(e,is(20));g.position.set(3.235,11.486,-12.541),g.scale.set(2.5,2,.1),this.add(g);let x=new Ot(e,is(100));x.position.set(0,20,0),x.scale.set(1,.1,1),this.add(x)}dispose(){let e=new Set;this.traverse(t=>{t.isMesh&&(e.add(t.geometry),e.add(t.material))});for(let t of e)t.dispose()}};function is(i){return new ks({color:0,emissive:16777215,emissiveIntensity:i})}var Sf=14477040,Xb=["#edf1f6","#cfd7e1"],$b=15113984,bf=.5,[qb,Yb,jb,Zb,Jb,Kb]=[2,3,4,5,6,7],Qb=3,Ul=class{constructor(e,t,n){let{scale:s}=t;Object.assign(this,{canvas:e,robot:t,scale:s,covered:n,follow:!0,robots:[]}),this.target=new j(0,0,t.height),this.renderer=new Cl({canvas:e,antialias:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=dr,this.renderer.toneMapping=Zs,this.scene=new hr,this.scene.background=new ht(Sf),this.scene.fog=new Ts(Sf,4*s,16*s),this.scene.environment=new ts(this.renderer).fromScene(new Nl,.04).texture,this.scene.environmentIntensity=.62,this.world=this.scene.add(new kn).children.at(-1),this.camera=new gn(38,1,.01*s,60*s),this.camera.up.set(0,0,1),this.orbit=new Ll(this.camera,e),Object.assign(this.orbit,{enableDamping:!0,enablePan:!1,minDistance:.3*s,maxDistance:6*s,maxPolarAngle:1.52}),this.resetCamera(),this.light=new $s(16777215,2.8),this.light.castShadow=!0,this.light.shadow.mapSize.set(1024,1024),Object.assign(this.light.shadow.camera,{left:-s,right:s,top:s,bottom:-s,near:.1,far:6*s}),Object.assign(this.light.shadow,{radius:4,bias:-5e-4,normalBias:.01*s}),this.scene.add(this.light,this.light.target);let o=new Ns(rw());o.colorSpace=mn,o.wrapS=o.wrapT=kr,o.anisotropy=this.renderer.capabilities.getMaxAnisotropy(),this.floor=new Ri({map:o,roughness:.95,envMapIntensity:.6}),this.arrow=new Ys(new j(1,0,0),new j,.3*s,$b,.12*s,.09*s),this.arrow.visible=!1,this.world.add(this.arrow),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;if(!e||!t)return;this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.fov=38*Math.min(1.5,Math.max(1,1/this.camera.aspect));let{top:n,right:s,bottom:o}=this.covered();this.camera.setViewOffset(e,t,s/2,(o-n)/2,e,t)}resetCamera(e=1){this.camera.position.copy(this.target).add(new j(.75,-1.25,.6).multiplyScalar(e*this.scale))}setTerrain(e){this.ground?.traverse(s=>s.geometry?.dispose()),this.ground?.removeFromParent(),this.ground=new kn;let t=80*this.scale,n=new Vi(t,t);if(Mf(n,this.scale),this.plane=new Ot(n,this.floor),this.plane.receiveShadow=!0,this.ground.add(this.plane),e.grid){let{shape:[s,o],extent:l,lowest:h,span:f}=e.grid,d=new Vi(...l,o-1,s-1),m=d.attributes.position;for(let g=0;g<m.count;g++){let x=s-1-Math.floor(g/o);m.setZ(g,h+f*e.heights[x*o+g%o])}Mf(d,this.scale),d.computeVertexNormals(),iw(d);let y=this.floor.clone();y.vertexColors=!0,this.ground.add(Object.assign(new Ot(d,y),{receiveShadow:!0})),this.plane.position.z=h-.01*this.scale}this.world.add(this.ground)}setSlope(e){this.world.rotation.y=-e}setRobots(e,t){for(let n of this.robots)n.group.removeFromParent();this.robots=e.map((n,s)=>new Eh(n,t[s],this.robot));for(let n of this.robots)this.world.add(n.group)}record(){for(let e of this.robots)e.record()}draw(e,t){for(let d of this.robots)d.place(e);let[n,s]=this.robots.map(d=>new j(...d.position(e))),{x:o,y:l}=n,h=this.world.localToWorld(n.clone());if(this.follow){let d=s?n.clone().add(s.sub(n).multiplyScalar(.4).clampLength(0,.35*this.scale)):n,m=this.world.localToWorld(d.clone()).sub(this.target);m.z*=Math.min(1,4*t),this.target.add(m),this.camera.position.add(m)}this.orbit.target.copy(this.target),this.orbit.update(),this.light.target.position.copy(h),this.light.position.copy(h).add(new j(.7,-.7,2.2).multiplyScalar(this.scale));let f=2*bf*this.scale;this.plane.position.setX(f*Math.round(o/f)).setY(f*Math.round(l/f)),this.arrow.visible&&(this.arrow.left-=t)<0&&(this.arrow.visible=!1),this.renderer.render(this.scene,this.camera)}showPush(e,t){let{scale:n}=this,[s,o,l]=this.robots[e].position(1),h=new j(...t).normalize();this.arrow.position.set(s,o,l).addScaledVector(h,-.5*n),this.arrow.setDirection(h),Object.assign(this.arrow,{visible:!0,left:.5})}pick(e,t){let n=new qs,{width:s,height:o}=this.canvas.getBoundingClientRect();n.setFromCamera(new et(2*e/s-1,1-2*t/o),this.camera);let[l]=n.intersectObjects(this.robots.map(d=>d.group));if(!l)return null;let h=this.robots.findIndex(d=>d.meshes.includes(l.object)),f=n.ray.direction.clone().applyQuaternion(this.world.quaternion.clone().invert()).setZ(0).normalize();return{index:h,direction:f.toArray()}}},Eh=class{constructor(e,t,n){this.simulation=e,this.group=new kn,this.meshes=[];let{model:s}=e;this.bodies=Array.from({length:s.nbody},()=>this.group.add(new kn).children.at(-1));for(let o=0;o<s.ngeom;o++){let l=s.geom_bodyid[o],h=l&&s.geom_group[o]<Qb?ew(s,o):null;if(!h)continue;let f=new Ot(h,nw(s,o,t));f.position.fromArray(s.geom_pos,3*o),f.quaternion.copy(wh(s.geom_quat,o)),f.castShadow=f.receiveShadow=!0,this.bodies[l].add(f),this.meshes.push(f)}for(let{site:o,colour:l}of t?[]:n.legs){let h=e.mujoco.mj_name2id(s,e.mujoco.mjtObj.mjOBJ_SITE.value,o),f=new Ot(new ur(1.06*n.foot_radius,32,16),wf(new ht(l)));f.position.fromArray(s.site_pos,3*h),f.castShadow=!0,this.bodies[s.site_bodyid[h]].add(f),this.meshes.push(f)}this.record()}record(){let{xpos:e,xquat:t}=this.simulation.data;this.before=this.now??{xpos:e.slice(),xquat:t.slice()},this.now={xpos:e.slice(),xquat:t.slice()}}place(e){this.bodies.forEach((t,n)=>{t.position.fromArray(this.before.xpos,3*n).lerp(new j().fromArray(this.now.xpos,3*n),e),t.quaternion.copy(wh(this.before.xquat,n)).slerp(wh(this.now.xquat,n),e)})}position(e){let t=3*this.simulation.base;return[0,1,2].map(n=>(1-e)*this.before.xpos[t+n]+e*this.now.xpos[t+n])}},wh=(i,e)=>new Mn(i[4*e+1],i[4*e+2],i[4*e+3],i[4*e]);function ew(i,e){let[t,n,s]=i.geom_size.slice(3*e,3*e+3);switch(i.geom_type[e]){case qb:return new ur(t,32,16);case Yb:return new Bs(t,2*n,8,24).rotateX(Math.PI/2);case jb:return new ur(1,32,16).scale(t,n,s);case Zb:return new $r(t,t,2*n,32).rotateX(Math.PI/2);case Jb:return new Fl(2*t,2*n,2*s,4,.2*Math.min(t,n,s));case Kb:return tw(i,i.geom_dataid[e]);default:return null}}function tw(i,e){let{mesh_vert:t,mesh_vertadr:n,mesh_vertnum:s,mesh_face:o,mesh_faceadr:l,mesh_facenum:h}=i,f=new wn,d=n[e],m=l[e];return f.setAttribute("position",new En(t.slice(3*d,3*(d+s[e])),3)),f.setIndex(Array.from(o.slice(3*m,3*(m+h[e])))),f.computeVertexNormals(),f}function nw(i,e,t){let n=i.geom_matid[e],[s,o,l]=n>=0?i.mat_rgba.slice(4*n,4*n+3):i.geom_rgba.slice(4*e,4*e+3),h=new ht().setRGB(s,o,l,mn);return t&&h.lerp(new ht(t.colour),t.share),wf(h)}var wf=i=>new Ri({color:i,roughness:.5,metalness:.05});function iw(i){let{position:e,normal:t}=i.attributes,n=new Float32Array(3*e.count);i.computeBoundingBox();let{min:{z:s},max:{z:o}}=i.boundingBox;for(let l=0;l<e.count;l++){let h=Math.min(1,16*(1-t.getZ(l))),f=(o-e.getZ(l))/(o-s),d=(1-.5*h)*(1-.2*f);n.set([d*(1-.06*f),d*(1-.02*f),d],3*l)}i.setAttribute("color",new En(n,3))}function Mf(i,e){let{position:t,uv:n}=i.attributes,s=2*bf*e;for(let o=0;o<t.count;o++)n.setXY(o,t.getX(o)/s,t.getY(o)/s)}function rw(){let i=document.createElement("canvas"),e=256,t=e/2;i.width=i.height=e;let n=i.getContext("2d");for(let[s,o]of Xb.entries())n.fillStyle=o,n.fillRect(0,s*t,t,t),n.fillRect(t,(1-s)*t,t,t);return i}var ha=class{constructor({name:e,xml:t,heights:n}){if(Object.assign(this,{name:e,xml:t,grid:n??null,heights:null}),n){let s=new Uint16Array(Uint8Array.from(atob(n.data),o=>o.charCodeAt(0)).buffer);this.heights=Float32Array.from(s,o=>o/65535)}}highest(e,t,n){if(!this.grid)return 0;let{shape:[s,o],extent:l,lowest:h,span:f}=this.grid,d=g=>(g+l[0]/2)/l[0]*(o-1),m=g=>(g+l[1]/2)/l[1]*(s-1),y=-1/0;for(let g=Math.max(0,Math.floor(m(t-n)));g<=Math.min(s-1,Math.ceil(m(t+n)));g++)for(let x=Math.max(0,Math.floor(d(e-n)));x<=Math.min(o-1,Math.ceil(d(e+n)));x++)y=Math.max(y,this.heights[g*o+x]);return y===-1/0?0:h+f*y}};var Th=2*Math.PI,sw="gait_swing",ua=class{constructor(e,t,n){Object.assign(this,{simulation:e,graph:t,control:n}),this.amplitude=this.frequency=1,this.reset()}reset(e,t=[0,0]){this.simulation.reset(e),this.command=Float64Array.from(t),this.requested=[...t],this.memory={last_action:new Float32Array(this.simulation.play.length),gait_phase:Float32Array.of(0),observation_history:new Float32Array(this.graph.inputs.observation_history?.length??0).fill(NaN)},this.time=0}step(){let{simulation:e,graph:t,memory:n,frequency:s}=this,o=t.run({projected_gravity:e.projectedGravity(),angular_velocity:e.reading("angular_velocity_b"),joint_position:e.reading("joint_position"),joint_velocity:e.reading("joint_velocity"),command:this.command,...n},{[sw]:this.amplitude});if(o.action&&n.last_action.set(o.action),o.next_observation_history&&n.observation_history.set(o.next_observation_history),o.next_gait_phase){let l=(o.next_gait_phase[0]-n.gait_phase[0]+Th)%Th;n.gait_phase[0]=s===1?o.next_gait_phase[0]:(n.gait_phase[0]+s*l)%Th}e.step(o.joint_target),this.control.command_rate.forEach((l,h)=>{let f=this.requested[h]-this.command[h],d=l*this.control.timestep;this.command[h]=Math.abs(f)<=d?this.requested[h]:this.command[h]+Math.sign(f)*d}),this.time+=this.control.timestep}};var aw=.56,ow=1.5,lw=.3,da=class{constructor(e,t){Object.assign(this,{mujoco:e,content:t,scale:t.robot.scale,walkers:[]}),this.terrains=t.terrains.map(n=>new ha(n)),this.settings=this.standard(),this.compare=!1,this.request=[0,0],this.rebuild()}standard(){return{terrain:this.content.terrain,slope:0,friction:null,payload:0,amplitude:1,frequency:1}}get terrain(){return this.terrains.find(({name:e})=>e===this.settings.terrain)}rebuild(){for(let{simulation:o}of this.walkers)o.delete();let{mujoco:e,content:t,terrain:n}=this,s=this.compare&&t.gait?[t.policy,t.gait]:[t.policy];this.walkers=s.map(o=>new ua(new hs(e,n,t.robot),new sr(o),t.control)),this.reset()}reset(){this.apply();let{height:e}=this.content.robot;this.walkers.forEach((t,n)=>{let s=this.walkers.length>1?(n-.5)*aw*this.scale:0,o=[...this.content.robot.start];o[1]=s,o[2]=e+this.terrain.highest(0,s,.2*this.scale),t.reset(o),Object.assign(t,{downFor:0,travelled:0,speed:0,rate:0,falls:0})}),this.time=0}apply(){let{slope:e,friction:t,payload:n,amplitude:s,frequency:o}=this.settings;for(let l of this.walkers)Object.assign(l,{amplitude:s,frequency:o}),l.simulation.setSlope(e),l.simulation.setPayload(n),t!==null&&l.simulation.setFriction(t)}step(){let{timestep:e}=this.content.control;this.time+=e;for(let t of this.walkers){let{simulation:n}=t,[s,o]=n.position();t.requested=[...this.request],t.step();let[l]=n.reading("linear_velocity_b"),h=n.position(),[,,f]=n.reading("angular_velocity_b"),d=e/lw;t.speed+=d*(l-t.speed),t.rate+=d*(f-t.rate),t.travelled+=Math.hypot(h[0]-s,h[1]-o),t.downFor=n.fallen()?t.downFor+e:0,t.downFor>ow&&this.standUp(t)}}standUp(e){let{simulation:t,travelled:n,falls:s}=e,o=[...this.content.robot.start],[l,h]=t.position(),f=t.yaw();Number.isFinite(l+h+f)&&([o[0],o[1],o[3],o[6]]=[l,h,Math.cos(f/2),Math.sin(f/2)],o[2]=this.content.robot.height+this.terrain.highest(l,h,.2*this.scale)),e.reset(o),Object.assign(e,{downFor:0,travelled:n,speed:0,rate:0,falls:s+1})}contacts(e=0){return Array.from(this.walkers[e].simulation.reading("foot_force"),t=>t>this.content.robot.contact)}};function Ef(i,e){let{start:t,command:n,steps:s,end:o}=e.reference,l=new ha(e.terrains.find(({heights:m})=>!m)),h=new hs(i,l,e.robot),f=new ua(h,new sr(e.policy),e.control);f.reset(t,n);let d=s;return m=>{for(;m>0&&d>0;m--,d--)f.step();if(d)return null;let[y,g]=[h.position(),o].map(([E,C])=>Math.hypot(E,C)),x={seconds:s*e.control.timestep,speed:n[0],here:y,there:g};return h.delete(),x}}var cw=.8,hw=.25,uw=.1,dw=4,fw={colour:13983232,share:.72},vr=i=>document.getElementById(i);function pw(){let i=vr("panel").getBoundingClientRect();if(i.left>innerWidth/2)return{top:0,right:innerWidth-i.left,bottom:0};let e=i.width?i:vr("stick").getBoundingClientRect();return{top:vr("hud").getBoundingClientRect().bottom,right:0,bottom:innerHeight-e.top}}var Ah=class{constructor(e,t){this.walk=new da(e,t),Object.assign(this,{language:La(),paused:!1,slow:!1,throttle:0,turn:0,checked:null}),this.view=new Ul(vr("view"),t.robot,pw),this.feet=new Na(vr("feet"),t.robot.legs,t.control.timestep),this.controls=new Fa(this),this.check=Ef(e,t),this.due=0,this.redraw(),this.controls.translate(),this.controls.steer(cw,0)}redraw(){let{walk:e,view:t,feet:n}=this;t.setTerrain(e.terrain),t.setSlope(e.settings.slope),t.setRobots(e.walkers.map(({simulation:s})=>s),[null,fw]),n.clear()}setPaused(e){this.paused=e,this.controls.showPaused(e)}setSlow(e){this.slow=e,this.controls.showSlow(e)}setLanguage(e){this.language=e,this.controls.translate()}set(e){Object.assign(this.walk.settings,e),this.walk.apply(),this.view.setSlope(this.walk.settings.slope)}setTerrain(e){this.walk.settings.terrain=e,this.walk.rebuild(),this.redraw()}setCompare(e){this.walk.compare=e,this.walk.rebuild(),this.redraw(),this.view.resetCamera(e?1.25:1)}reset(){this.walk.reset(),this.redraw(),this.view.resetCamera()}push(e,t){for(let n of t)this.walk.walkers[n].simulation.push(e.map(s=>s*this.strength));this.view.showPush(t[0],e)}pushSomewhere(){let e=2*Math.PI*Math.random();this.push([Math.cos(e),Math.sin(e),0],[...this.walk.walkers.keys()])}step(e=1){for(let t=0;t<e;t++)this.walk.step(),this.view.record(),this.feet.record(this.walk.contacts())}compare(e){this.checked||(this.checked=this.check(e),this.checked&&this.controls.showCheck())}frame(e){let{timestep:t}=this.walk.content.control;if(this.controls.pollGamepad(),!this.paused){this.due+=Math.min(e,uw)*(this.slow?hw:1);let n=Math.floor(this.due/t);this.step(n),this.due-=n*t}this.compare(dw),this.view.draw(this.due/t,e),this.feet.draw(),this.controls.show()}run(){let e=performance.now(),t=n=>{this.frame(Math.max(0,n-e)/1e3),e=n,requestAnimationFrame(t)};requestAnimationFrame(t)}};async function Tf(i){let e=Uint8Array.from(atob(vr(i).textContent.trim()),t=>t.charCodeAt(0));return new Uint8Array(await new Response(new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer())}var Af=vr("message");try{Object.assign(Af,{hidden:!1,textContent:Xn(La(),"loading")});let i=JSON.parse(new TextDecoder().decode(await Tf("document"))),e=new Ah(await vu(await Tf("wasm")),i);window.quadruped={page:e,walk:e.walk,Graph:sr,Walk:da},e.run()}catch(i){throw Object.assign(Af,{hidden:!1,textContent:Xn(La(),"failed",i.message??i)}),i}
