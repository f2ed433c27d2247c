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
var D0={en:"English",zh:"中文"},Jl={en:{title:"MiniQuadruped: a robot that learned to walk",tagline:"It learned to walk by trial and error. Drive it, push it, change its world: everything runs in this file.",other_language:"中文",loading:"Loading the physics …",failed:"The page cannot run here: {}",steer:"Steer",steer_hint:"Arrow keys, the stick below, or a gamepad. Forward speed stays, turning springs back.",speed_limit:"Speed limit",stop:"Stop",disturb:"Push",disturb_hint:"Click on the robot: it is pushed away from you.",push_strength:"Strength",push:"Push somewhere",ground:"Ground",terrain:"Terrain",slope:"Slope",friction:"Friction",robot:"Robot",payload:"Payload",amplitude:"Gait amplitude",frequency:"Gait frequency",gait_hint:"They change the scripted gait to which the policy adds.",compare:"Scripted gait beside it",compare_hint:"The orange robot repeats a fixed motion and feels nothing.",follow:"Camera follows",standard:"Reset all settings",pause:"Pause",resume:"Resume",reset:"Reset",slow:"Slow motion",settings:"Settings",close:"Close",speed:"Speed",commanded:"commanded",turning:"Turning",distance:"Distance",feet:"Feet on the ground",fell:"It fell. It stands up again in a moment.",keys:"↑ ↓ speed · ← → turn · 0 stop · space pause · P push · R reset · C scripted gait · M slow motion",engine:"MuJoCo {} (WebAssembly)",checking:"comparing with Python …",check:"{} s at {} m/s: {} m here, {} m in Python with MuJoCo {}. The difference is {} %.",about:"Policy “{}”, MiniQuadruped {}. Physics: MuJoCo (Google DeepMind, Apache-2.0). Drawing: three.js (MIT).",policy:"policy",gait:"scripted gait",terrains:{flat:"flat",rough:"rough",hills:"hills",slope:"slopes",steps:"blocks",stairs:"stairs",gaps:"trenches",wave:"waves"}},zh:{title:"MiniQuadruped：学会走路的机器人",tagline:"它通过反复试错学会了走路。驾驶它，推它，改变它的世界：一切都在这个文件里运行。",other_language:"English",loading:"正在加载物理引擎……",failed:"页面无法在此运行：{}",steer:"驾驶",steer_hint:"方向键、下面的摇杆或手柄。前进速度保持不变，松手后停止转向。",speed_limit:"限速",stop:"停止",disturb:"推",disturb_hint:"点击机器人，把它朝远离你的方向推。",push_strength:"力度",push:"随机推一下",ground:"地面",terrain:"地形",slope:"坡度",friction:"摩擦系数",robot:"机器人",payload:"负载",amplitude:"步态幅度",frequency:"步态频率",gait_hint:"它们改变脚本步态，策略在此基础上修正。",compare:"旁边显示脚本步态",compare_hint:"橙色机器人只重复固定的动作，没有任何感知。",follow:"镜头跟随",standard:"恢复全部设置",pause:"暂停",resume:"继续",reset:"重置",slow:"慢动作",settings:"设置",close:"关闭",speed:"速度",commanded:"指令",turning:"转向",distance:"距离",feet:"着地的脚",fell:"它摔倒了，马上会重新站起来。",keys:"↑ ↓ 速度 · ← → 转向 · 0 停止 · 空格 暂停 · P 推 · R 重置 · C 脚本步态 · M 慢动作",engine:"MuJoCo {}（WebAssembly）",checking:"正在与 Python 比较……",check:"以 {1} m/s 走 {0} 秒：这里 {2} m，Python（MuJoCo {4}）{3} m，相差 {5} %。",about:"策略“{}”，MiniQuadruped {}。物理：MuJoCo（Google DeepMind，Apache-2.0）。绘图：three.js（MIT）。",policy:"策略",gait:"脚本步态",terrains:{flat:"平地",rough:"崎岖",hills:"丘陵",slope:"斜坡",steps:"方块",stairs:"台阶",gaps:"沟壑",wave:"波浪"}}};function Ra(i=navigator.languages){return i.map(e=>e.slice(0,2)).find(e=>e in D0)??"en"}function ri(i,e,...t){let n=0;return Jl[i][e].replace(/\{(\d?)\}/g,(s,o)=>t[o===""?n++:Number(o)])}var at=i=>document.getElementById(i),L0=Math.PI/180,Kl=.15,Pa=class{constructor(e){Object.assign(this,{page:e,held:new Set,stick:null,gamepad:!1});let{control:t,robot:n,gait:s,policy:o}=e.walk.content,[l,h]=t.forward,{walk:f}=e;this.sliders={limit:[t.key_steps[0],h,h,d=>`${d.toFixed(2)} m/s`,d=>{e.limit=d,this.steer()}],strength:[.1,1.5,.6,d=>`${(d*Math.sqrt(f.scale)).toFixed(2)} m/s`,d=>{e.strength=d*Math.sqrt(f.scale)}],slope:[-12,12,0,d=>`${d.toFixed(0)}°`,d=>e.set({slope:d*L0})],friction:[.1,1.5,n.friction,d=>d.toFixed(2),d=>e.set({friction:d})],payload:[0,n.mass/2,0,d=>`${d.toFixed(n.mass<2?2:1)} kg`,d=>e.set({payload:d})],amplitude:[0,2,1,d=>`${d.toFixed(2)}×`,d=>e.set({amplitude:d})],frequency:[.5,1.5,1,d=>`${d.toFixed(2)}×`,d=>e.set({frequency:d})]};for(let[d,[m,y,g,S,E]]of Object.entries(this.sliders)){let R=at(d),x=R.closest("label").querySelector("output");Object.assign(R,{min:m,max:y,step:d==="slope"?1:(y-m)/100,value:g}),R.addEventListener("input",()=>{x.textContent=S(R.valueAsNumber),E(R.valueAsNumber)}),x.textContent=S(g)}e.limit=h,e.strength=this.sliders.strength[2]*Math.sqrt(f.scale),this.low=l,at("frequency").closest("label").hidden=!("gait_phase"in o.inputs),at("amplitude").closest("label").hidden=!o.nodes.some(([,,d])=>d==="gait_swing"),at("gait").hidden=at("frequency").closest("label").hidden&&at("amplitude").closest("label").hidden,at("beside").hidden=at("beside_hint").hidden=!s;for(let{name:d}of f.terrains)at("terrain").append(new Option(d,d,!1,d===f.settings.terrain));at("terrain").addEventListener("change",()=>e.setTerrain(at("terrain").value));for(let[d,m]of Object.entries({pause:()=>e.setPaused(!e.paused),slow:()=>e.setSlow(!e.slow),reset:()=>e.reset(),stop:()=>this.stop(),push:()=>e.pushSomewhere(),language:()=>e.setLanguage(e.language==="en"?"zh":"en"),standard:()=>this.standard(),open:()=>this.toggle()}))at(d).addEventListener("click",m);at("compare").addEventListener("change",()=>e.setCompare(at("compare").checked)),at("follow").addEventListener("change",()=>{e.view.follow=at("follow").checked}),this.addKeys(),this.addStick(),this.addClicks()}addKeys(){let e={ArrowUp:.2,ArrowDown:-.2},t={ArrowLeft:1,ArrowRight:-1},n={" ":()=>this.page.setPaused(!this.page.paused),r:()=>this.page.reset(),p:()=>this.page.pushSomewhere(),m:()=>this.page.setSlow(!this.page.slow),0:()=>this.stop(),c:()=>{at("beside").hidden||(at("compare").checked=!at("compare").checked,this.page.setCompare(at("compare").checked))}};addEventListener("keydown",s=>{let{key:o,target:l}=s;if(!(s.ctrlKey||s.metaKey||s.altKey||l.matches("select, input[type=range]"))&&!(o===" "&&l.matches("button, input"))){if(o in e)this.steer(Math.round(5*(this.page.throttle+e[o]))/5);else if(o in t)this.held.add(o),this.steer(void 0,this.heldTurn(t));else if(o.toLowerCase()in n)n[o.toLowerCase()]();else return;s.preventDefault()}}),addEventListener("keyup",({key:s})=>{this.held.delete(s)&&this.steer(void 0,this.heldTurn(t))}),addEventListener("blur",()=>{this.held.size&&(this.held.clear(),this.steer(void 0,0))})}heldTurn(e){return[...this.held].reduce((t,n)=>t+e[n],0)}addStick(){let e=at("stick"),t=n=>{let{left:s,top:o,width:l,height:h}=e.getBoundingClientRect(),f=.36,d=((n.clientX-s)/l-.5)/f,m=(.5-(n.clientY-o)/h)/f;this.steer(Math.abs(m)<Kl?0:m,Math.abs(d)<Kl?0:-d)};e.addEventListener("pointerdown",n=>{e.setPointerCapture(n.pointerId),t(n)}),e.addEventListener("pointermove",n=>{e.hasPointerCapture(n.pointerId)&&t(n)});for(let n of["pointerup","pointercancel"])e.addEventListener(n,()=>this.steer(void 0,0))}pollGamepad(){let e=navigator.getGamepads?.().find(o=>o?.connected);if(!e)return;let[t,n]=e.axes.map(o=>Math.abs(o)<Kl?0:o);(t||n||this.gamepad)&&this.steer(-n,-t),this.gamepad=!!(t||n);let s=e.buttons[0]?.pressed;s&&!this.pressed&&this.page.pushSomewhere(),this.pressed=s}steer(e=this.page.throttle,t=this.page.turn){let{page:n}=this,s=l=>Math.min(1,Math.max(-1,l));Object.assign(n,{throttle:s(e),turn:s(t)});let o=n.throttle<0?Math.max(n.throttle*n.limit,this.low):n.throttle*n.limit;n.walk.request=[o,n.turn*n.walk.content.control.turn[1]],at("knob").style.transform=`translate(${-36*n.turn}%, ${-36*n.throttle}%) translate(${-n.turn*30}px, ${-n.throttle*30}px)`}stop(){this.steer(0,0)}addClicks(){let e=at("view"),t=s=>{let{left:o,top:l}=e.getBoundingClientRect();return[s.clientX-o,s.clientY-l]},n=null;e.addEventListener("pointerdown",s=>{n=t(s)}),e.addEventListener("pointerup",s=>{let[o,l]=t(s);if(n&&Math.hypot(o-n[0],l-n[1])<6){let h=this.page.view.pick(o,l);h&&this.page.push(h.direction,[h.index])}n=null}),e.addEventListener("pointermove",s=>{s.buttons||e.classList.toggle("aim",this.page.view.pick(...t(s))!==null)})}standard(){for(let[e,[,,t,n,s]]of Object.entries(this.sliders))at(e).value=t,at(e).closest("label").querySelector("output").textContent=n(t),s(t);this.page.set({friction:null}),at("terrain").value=this.page.walk.content.terrain,this.page.setTerrain(at("terrain").value)}toggle(e=!at("panel").classList.contains("open")){at("panel").classList.toggle("open",e),at("open").setAttribute("aria-expanded",e),at("open").textContent=e?"✕":"⚙"}translate(){let{language:e,walk:t,paused:n}=this.page,s=(h,...f)=>ri(e,h,...f);document.documentElement.lang=e==="zh"?"zh-CN":"en",document.title=s("title");for(let h of document.querySelectorAll("[data-text]"))h.textContent=s(h.dataset.text);for(let h of document.querySelectorAll("[data-label]"))h.ariaLabel=h.title=s(h.dataset.label);for(let h of at("terrain").options)h.textContent=Jl[e].terrains[h.value]??h.value;let{name:o,versions:l}=t.content;at("engine").textContent=s("engine",t.mujoco.mj_versionString()),at("about").textContent=s("about",o,l.mini_quadruped),this.showPaused(n),this.showCheck()}showPaused(e){at("pause").textContent=e?"▶":"❚❚",at("pause").title=at("pause").ariaLabel=ri(this.page.language,e?"resume":"pause")}showSlow(e){at("slow").setAttribute("aria-pressed",e)}showCheck(){let{page:e}=this,{language:t,checked:n}=e;at("check").textContent=n?ri(t,"check",n.seconds,n.speed,n.here.toFixed(2),n.there.toFixed(2),e.walk.content.versions.mujoco,n.percent.toFixed(2)):ri(t,"checking")}tell(e,...t){at("message").hidden=!e,e&&(at("message").textContent=ri(this.page.language,e,...t))}show(){let{walk:e,language:t}=this.page,[n]=e.walkers,s=l=>l.toFixed(2).replace(/^-(?=0\.00$)/,""),o=l=>`${ri(t,"commanded")} ${s(l)}`;at("speed").textContent=`${s(n.speed)} m/s`,at("wanted").textContent=o(n.command[0]),at("rate").textContent=`${s(n.rate)} rad/s`,at("wanted_rate").textContent=o(n.command[1]),at("distance").textContent=`${n.travelled.toFixed(1)} m`,at("time").textContent=`${e.time.toFixed(1)} s`,n.downFor>.1?this.tell("fell"):this.tell(null)}};var F0="#57616d",N0="#e3e8ee",Ia=class{constructor(e,t,n){Object.assign(this,{canvas:e,legs:t,length:Math.round(2.5/n),history:[]})}clear(){this.history=[]}record(e){this.history.push(e),this.history.length>this.length&&this.history.shift()}draw(){let{canvas:e,legs:t,history:n,length:s}=this,o=devicePixelRatio||1,l=e.clientWidth,h=e.clientHeight;if(!l)return;e.width!==Math.round(l*o)&&([e.width,e.height]=[l*o,h*o].map(Math.round));let f=e.getContext("2d"),d=26,m=h/t.length,y=(l-d)/s;f.setTransform(o,0,0,o,0,0),f.clearRect(0,0,l,h),f.font="11px system-ui, sans-serif",f.textBaseline="middle",t.forEach(({name:g,colour:S},E)=>{let R=E*m+.18*m,x=.64*m,v=s-n.length;f.fillStyle=F0,f.fillText(g.slice(0,3),0,E*m+m/2),f.fillStyle=N0,f.fillRect(d,R,l-d,x),f.fillStyle=S;for(let P=0;P<n.length;P++){if(!n[P][E])continue;let U=P;for(;U+1<n.length&&n[U+1][E];)U++;f.fillRect(d+(v+P)*y,R,(U-P+1)*y,x),P=U}})}};var Di=i=>(e,t)=>{let n=new Float32Array(Math.max(e.length,t.length)),[s,o]=[e.length>1?1:0,t.length>1?1:0];return[n,()=>{for(let l=0;l<n.length;l++)n[l]=i(e[s*l],t[o*l])}]},xn=i=>e=>{let t=new Float32Array(e.length);return[t,()=>{for(let n=0;n<t.length;n++)t[n]=i(e[n])}]},uu=(i,e,t)=>{let n=i.length,s=e.length/n,o=new Float32Array(s),l=new Float64Array(s);return[o,()=>{t?l.set(t):l.fill(0);for(let h=0,f=0;h<n;h++){let d=i[h];for(let m=0;m<s;m++,f++)l[m]+=d*e[f]}o.set(l)}]},U0=i=>1/(1+Math.exp(-i)),O0=i=>Math.max(i,0)+Math.log1p(Math.exp(-Math.abs(i))),B0=i=>{let e=1/(1+.3275911*Math.abs(i)),t=e*(.254829592+e*(-.284496736+e*(1.421413741+e*(-1.453152027+e*1.061405429))));return Math.sign(i)*(1-t*Math.exp(-i*i))},du={Add:Di((i,e)=>i+e),Sub:Di((i,e)=>i-e),Mul:Di((i,e)=>i*e),Div:Di((i,e)=>i/e),Max:Di(Math.max),Min:Di(Math.min),Mod:Di((i,e)=>i%e),Greater:Di((i,e)=>+(i>e)),Abs:xn(Math.abs),Sign:xn(Math.sign),Sqrt:xn(Math.sqrt),Sin:xn(Math.sin),Cos:xn(Math.cos),Tanh:xn(Math.tanh),Erf:xn(B0),Sigmoid:xn(U0),Softplus:xn(O0),Relu:xn(i=>Math.max(i,0)),LeakyRelu:xn(i=>i<0?.01*i:i),Elu:xn(i=>i<0?Math.expm1(i):i),Selu:xn(i=>1.0507009873554805*(i<0?1.6732632423543772*Math.expm1(i):i)),Cast:xn(i=>i),IsNaN:xn(i=>Number(Number.isNaN(i))),MatMul:uu,Gemm:uu,Concat:(...i)=>{let e=new Float32Array(i.reduce((t,n)=>t+n.length,0));return[e,()=>{let t=0;for(let n of i)e.set(n,t),t+=n.length}]},Where:(i,e,t)=>{let n=new Float32Array(i.length);return[n,()=>{for(let s=0;s<n.length;s++)n[s]=i[s]?e[s]:t[s]}]},Slice:(i,[e],[t])=>{let n=new Float32Array(t-e);return[n,()=>n.set(i.subarray(e,t))]}},fw=Object.keys(du);function k0(i){return new Float32Array(Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer)}var rr=class{constructor({nodes:e,constants:t,inputs:n,outputs:s}){this.inputs=Object.fromEntries(Object.entries(n).map(([o,l])=>[o,new Float32Array(l)])),this.outputs=s,this.values={...this.inputs};for(let[o,l]of Object.entries(t))this.values[o]=k0(l);this.steps=e.map(([o,l,h])=>{let[f,d]=du[o](...l.map(m=>this.values[m]));return this.values[h]=f,[d,h,f]})}run(e,t={}){for(let[n,s]of Object.entries(this.inputs))s.set(e[n]);for(let[n,s,o]of this.steps)if(n(),t[s]!==void 0)for(let l=0;l<o.length;l++)o[l]*=t[s];return Object.fromEntries(this.outputs.map(n=>[n,this.values[n]]))}};var z0=(async function(i={}){var e,t=i,n=typeof window=="object",s=typeof WorkerGlobalScope<"u",o=typeof process=="object"&&process.versions?.node&&process.type!="renderer",l=!n&&!o&&!s;if(o){let{createRequire:r}=await import("module");var h=r(import.meta.url)}var f=[],d="./this.program",m=(r,a)=>{throw a},y=import.meta.url,g="";function S(r){return t.locateFile?t.locateFile(r,g):g+r}var E,R;if(o){if(!(typeof process=="object"&&process.versions?.node&&process.type!="renderer"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");var x=process.versions.node,v=x.split(".").slice(0,3);if(v=v[0]*1e4+v[1]*100+v[2].split("-")[0]*1,v<16e4)throw new Error("This emscripten-generated code requires node v16.0.0 (detected v"+x+")");var P=h("fs");y.startsWith("file:")&&(g=h("path").dirname(h("url").fileURLToPath(y))+"/"),R=a=>{a=ne(a)?new URL(a):a;var c=P.readFileSync(a);return G(Buffer.isBuffer(c)),c},E=async(a,c=!0)=>{a=ne(a)?new URL(a):a;var u=P.readFileSync(a,c?void 0:"utf8");return G(c?Buffer.isBuffer(u):typeof u=="string"),u},process.argv.length>1&&(d=process.argv[1].replace(/\\/g,"/")),f=process.argv.slice(2),m=(a,c)=>{throw process.exitCode=a,c}}else if(l){if(typeof process=="object"&&process.versions?.node&&process.type!="renderer"||typeof window=="object"||typeof WorkerGlobalScope<"u")throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)")}else if(n||s){try{g=new URL(".",y).href}catch{}if(!(typeof window=="object"||typeof WorkerGlobalScope<"u"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");s&&(R=r=>{var a=new XMLHttpRequest;return a.open("GET",r,!1),a.responseType="arraybuffer",a.send(null),new Uint8Array(a.response)}),E=async r=>{if(ne(r))return new Promise((c,u)=>{var p=new XMLHttpRequest;p.open("GET",r,!0),p.responseType="arraybuffer",p.onload=()=>{if(p.status==200||p.status==0&&p.response){c(p.response);return}u(p.status)},p.onerror=u,p.send(null)});var a=await fetch(r,{credentials:"same-origin"});if(a.ok)return a.arrayBuffer();throw new Error(a.status+" : "+a.url)}}else throw new Error("environment detection error");var U=console.log.bind(console),I=console.error.bind(console),O="IDBFS is no longer included by default; build with -lidbfs.js",N="PROXYFS is no longer included by default; build with -lproxyfs.js",b="WORKERFS is no longer included by default; build with -lworkerfs.js",D="FETCHFS is no longer included by default; build with -lfetchfs.js",q="ICASEFS is no longer included by default; build with -licasefs.js",k="JSFILEFS is no longer included by default; build with -ljsfilefs.js",Y="OPFS is no longer included by default; build with -lopfs.js",J="NODEFS is no longer included by default; build with -lnodefs.js";G(!l,"shell environment detected but not enabled at build time.  Add `shell` to `-sENVIRONMENT` to enable.");var ee;typeof WebAssembly!="object"&&I("no native wasm support detected");var z=!1,ie;function G(r,a){r||pe("Assertion failed"+(a?": "+a:""))}var ne=r=>r.startsWith("file://");function Se(){var r=Yl();G((r&3)==0),r==0&&(r+=4),$e[r>>2]=34821223,$e[r+4>>2]=2310721022,$e[0]=1668509029}function re(){if(!z){var r=Yl();r==0&&(r+=4);var a=$e[r>>2],c=$e[r+4>>2];(a!=34821223||c!=2310721022)&&pe(`Stack overflow! Stack cookie has been overwritten at ${Ot(r)}, expected hex dwords 0x89BACDFE and 0x2135467, but received ${Ot(c)} ${Ot(a)}`),$e[0]!=1668509029&&pe("Runtime error: The application has corrupted its heap memory area (address zero)!")}}class H extends Error{}class ge extends H{}class We extends H{constructor(a){super(a),this.excPtr=a;let c=Zh(a);this.name=c[0],this.message=c[1]}}var it=!0;function ue(...r){!it&&typeof it<"u"||console.warn(...r)}(()=>{var r=new Int16Array(1),a=new Int8Array(r.buffer);if(r[0]=25459,a[0]!==115||a[1]!==99)throw"Runtime error: expected the system to be little-endian! (Run with -sSUPPORT_BIG_ENDIAN to bypass)"})();function Fe(r){Object.getOwnPropertyDescriptor(t,r)||Object.defineProperty(t,r,{configurable:!0,set(){pe(`Attempt to set \`Module.${r}\` after it has already been processed.  This can happen, for example, when code is injected via '--post-js' rather than '--pre-js'`)}})}function Pe(r){return()=>G(!1,`call to '${r}' via reference taken before Wasm module initialization`)}function je(r){Object.getOwnPropertyDescriptor(t,r)&&pe(`\`Module.${r}\` was supplied but \`${r}\` not included in INCOMING_MODULE_JS_API`)}function Ue(r){return r==="FS_createPath"||r==="FS_createDataFile"||r==="FS_createPreloadedFile"||r==="FS_unlink"||r==="addRunDependency"||r==="FS_createLazyFile"||r==="FS_createDevice"||r==="removeRunDependency"}function ot(r,a){typeof globalThis<"u"&&!Object.getOwnPropertyDescriptor(globalThis,r)&&Object.defineProperty(globalThis,r,{configurable:!0,get(){a()}})}function Vt(r,a){ot(r,()=>{Jn(`\`${r}\` is not longer defined by emscripten. ${a}`)})}Vt("buffer","Please use HEAP8.buffer or wasmMemory.buffer"),Vt("asm","Please use wasmExports instead");function Ke(r){ot(r,()=>{var a=`\`${r}\` is a library symbol and not included by default; add it to your library.js __deps or to DEFAULT_LIBRARY_FUNCS_TO_INCLUDE on the command line`,c=r;c.startsWith("_")||(c="$"+r),a+=` (e.g. -sDEFAULT_LIBRARY_FUNCS_TO_INCLUDE='${c}')`,Ue(r)&&(a+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),Jn(a)}),Et(r)}function Et(r){Object.getOwnPropertyDescriptor(t,r)||Object.defineProperty(t,r,{configurable:!0,get(){var a=`'${r}' was not exported. add it to EXPORTED_RUNTIME_METHODS (see the Emscripten FAQ)`;Ue(r)&&(a+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),pe(a)}})}var Ct,mt,Ht,pt,It,Mt,rn,De,$e,hn,sn,W,vn,Rt=!1;function Ut(){var r=Ht.buffer;pt=new Int8Array(r),Mt=new Int16Array(r),It=new Uint8Array(r),rn=new Uint16Array(r),De=new Int32Array(r),$e=new Uint32Array(r),hn=new Float32Array(r),sn=new Float64Array(r),W=new BigInt64Array(r),vn=new BigUint64Array(r)}G(typeof Int32Array<"u"&&typeof Float64Array<"u"&&Int32Array.prototype.subarray!=null&&Int32Array.prototype.set!=null,"JS engine does not provide full typed array support");function Le(){if(t.preRun)for(typeof t.preRun=="function"&&(t.preRun=[t.preRun]);t.preRun.length;)dt(t.preRun.shift());Fe("preRun"),Xe(qe)}function $t(){G(!Rt),Rt=!0,re(),!t.noFSInit&&!M.initialized&&M.init(),lt.init(),nr.__wasm_call_ctors(),M.ignorePermissions=!1}function Ze(){if(re(),t.postRun)for(typeof t.postRun=="function"&&(t.postRun=[t.postRun]);t.postRun.length;)we(t.postRun.shift());Fe("postRun"),Xe(ut)}var Je=0,L=null,T={},Z=null;function ve(r){Je++,t.monitorRunDependencies?.(Je),r?(G(!T[r]),T[r]=1,Z===null&&typeof setInterval<"u"&&(Z=setInterval(()=>{if(z){clearInterval(Z),Z=null;return}var a=!1;for(var c in T)a||(a=!0,I("still waiting on run dependencies:")),I(`dependency: ${c}`);a&&I("(end of list)")},1e4))):I("warning: run dependency added without ID")}function de(r){if(Je--,t.monitorRunDependencies?.(Je),r?(G(T[r]),delete T[r]):I("warning: run dependency removed without ID"),Je==0&&(Z!==null&&(clearInterval(Z),Z=null),L)){var a=L;L=null,a()}}function pe(r){t.onAbort?.(r),r="Aborted("+r+")",I(r),z=!0;var a=new WebAssembly.RuntimeError(r);throw mt?.(a),a}function Me(r,a){return(...c)=>{G(Rt,`native function \`${r}\` called before runtime initialization`);var u=nr[r];return G(u,`exported native function \`${r}\` not found`),G(c.length<=a,`native function \`${r}\` called with ${c.length} args but expects ${a}`),u(...c)}}var ae;function le(){return t.locateFile?S("mujoco.wasm"):new URL("mujoco.wasm",import.meta.url).href}function Ce(r){if(r==ae&&ee)return new Uint8Array(ee);if(R)return R(r);throw"both async and sync fetching of the wasm failed"}async function B(r){if(!ee)try{var a=await E(r);return new Uint8Array(a)}catch{}return Ce(r)}async function he(r,a){try{var c=await B(r),u=await WebAssembly.instantiate(c,a);return u}catch(p){I(`failed to asynchronously prepare wasm: ${p}`),ne(ae)&&I(`warning: Loading from a file URI (${ae}) is not supported in most browsers. See https://emscripten.org/docs/getting_started/FAQ.html#how-do-i-run-a-local-webserver-for-testing-why-does-my-program-stall-in-downloading-or-preparing`),pe(p)}}async function se(r,a,c){if(!r&&typeof WebAssembly.instantiateStreaming=="function"&&!ne(a)&&!o)try{var u=fetch(a,{credentials:"same-origin"}),p=await WebAssembly.instantiateStreaming(u,c);return p}catch(_){I(`wasm streaming compile failed: ${_}`),I("falling back to ArrayBuffer instantiation")}return he(a,c)}function Re(){return{env:lu,wasi_snapshot_preview1:lu}}async function Ee(){function r(w,A){return nr=w.exports,Ht=nr.memory,G(Ht,"memory not found in wasm exports"),Ut(),xa=nr.__indirect_function_table,G(xa,"table not found in wasm exports"),Fm(nr),de("wasm-instantiate"),nr}ve("wasm-instantiate");var a=t;function c(w){return G(t===a,"the Module object should not be replaced during async compilation - perhaps the order of HTML elements is wrong?"),a=null,r(w.instance)}var u=Re();if(t.instantiateWasm)return new Promise((w,A)=>{try{t.instantiateWasm(u,(F,X)=>{w(r(F,X))})}catch(F){I(`Module.instantiateWasm callback failed with error: ${F}`),A(F)}});ae??=le();var p=await se(ee,ae,u),_=c(p);return _}class Ae{name="ExitStatus";constructor(a){this.message=`Program terminated with exit(${a})`,this.status=a}}var Xe=r=>{for(;r.length>0;)r.shift()(t)},ut=[],we=r=>ut.push(r),qe=[],dt=r=>qe.push(r);function Oe(r,a="i8"){switch(a.endsWith("*")&&(a="*"),a){case"i1":return pt[r];case"i8":return pt[r];case"i16":return Mt[r>>1];case"i32":return De[r>>2];case"i64":return W[r>>3];case"float":return hn[r>>2];case"double":return sn[r>>3];case"*":return $e[r>>2];default:pe(`invalid type for getValue: ${a}`)}}var Tt=!0,Ot=r=>(G(typeof r=="number"),r>>>=0,"0x"+r.toString(16).padStart(8,"0"));function gi(r,a,c="i8"){switch(c.endsWith("*")&&(c="*"),c){case"i1":pt[r]=a;break;case"i8":pt[r]=a;break;case"i16":Mt[r>>1]=a;break;case"i32":De[r>>2]=a;break;case"i64":W[r>>3]=BigInt(a);break;case"float":hn[r>>2]=a;break;case"double":sn[r>>3]=a;break;case"*":$e[r>>2]=a;break;default:pe(`invalid type for setValue: ${c}`)}}var ye=r=>nu(r),_e=()=>ru(),Jn=r=>{Jn.shown||={},Jn.shown[r]||(Jn.shown[r]=1,o&&(r="warning: "+r),I(r))},ns=typeof TextDecoder<"u"?new TextDecoder:void 0,_i=(r,a=0,c=NaN)=>{for(var u=a+c,p=a;r[p]&&!(p>=u);)++p;if(p-a>16&&r.buffer&&ns)return ns.decode(r.subarray(a,p));for(var _="";a<p;){var w=r[a++];if(!(w&128)){_+=String.fromCharCode(w);continue}var A=r[a++]&63;if((w&224)==192){_+=String.fromCharCode((w&31)<<6|A);continue}var F=r[a++]&63;if((w&240)==224?w=(w&15)<<12|A<<6|F:((w&248)!=240&&Jn("Invalid UTF-8 leading byte "+Ot(w)+" encountered when deserializing a UTF-8 string in wasm memory to a JS string!"),w=(w&7)<<18|A<<12|F<<6|r[a++]&63),w<65536)_+=String.fromCharCode(w);else{var X=w-65536;_+=String.fromCharCode(55296|X>>10,56320|X&1023)}}return _},un=(r,a)=>(G(typeof r=="number",`UTF8ToString expects a number (got ${typeof r})`),r?_i(It,r,a):""),is=(r,a,c,u)=>pe(`Assertion failed: ${un(r)}, at: `+[a?un(a):"unknown filename",c,u?un(u):"unknown function"]),Fn=[],ji=0,gr=r=>{var a=new _r(r);return a.get_caught()||(a.set_caught(!0),ji--),a.set_rethrown(!1),Fn.push(a),Ca(r),ou(r)},ca=()=>{if(!Fn.length)return 0;var r=Fn[Fn.length-1];return Ca(r.excPtr),r.excPtr},Nn=0,Zi=()=>{xe(0,0),G(Fn.length>0);var r=Fn.pop();jl(r.excPtr),Nn=0};class _r{constructor(a){this.excPtr=a,this.ptr=a-24}set_type(a){$e[this.ptr+4>>2]=a}get_type(){return $e[this.ptr+4>>2]}set_destructor(a){$e[this.ptr+8>>2]=a}get_destructor(){return $e[this.ptr+8>>2]}set_caught(a){a=a?1:0,pt[this.ptr+12]=a}get_caught(){return pt[this.ptr+12]!=0}set_rethrown(a){a=a?1:0,pt[this.ptr+13]=a}get_rethrown(){return pt[this.ptr+13]!=0}init(a,c){this.set_adjusted_ptr(0),this.set_type(a),this.set_destructor(c)}set_adjusted_ptr(a){$e[this.ptr+16>>2]=a}get_adjusted_ptr(){return $e[this.ptr+16>>2]}}var Ji=r=>eu(r),vr=r=>{var a=Nn?.excPtr;if(!a)return Ji(0),0;var c=new _r(a);c.set_adjusted_ptr(a);var u=c.get_type();if(!u)return Ji(0),a;for(var p of r){if(p===0||p===u)break;var _=c.ptr+16;if(au(p,u,_))return Ji(p),a}return Ji(u),a},Ll=()=>vr([]),Fl=r=>vr([r]),Nl=(r,a)=>vr([r,a]),rs=()=>{var r=Fn.pop();r||pe("no exception to throw");var a=r.excPtr;throw r.get_rethrown()||(Fn.push(r),r.set_rethrown(!0),r.set_caught(!1),ji++),Nn=new We(a),Nn},C=r=>{if(r){var a=new _r(r);Fn.push(a),a.set_rethrown(!0),rs()}},V=(r,a,c)=>{var u=new _r(r);throw u.init(a,c),Nn=new We(r),ji++,Nn},te=()=>ji,K=r=>{throw Nn||(Nn=new We(r)),Nn},$={isAbs:r=>r.charAt(0)==="/",splitPath:r=>{var a=/^(\/?|)([\s\S]*?)((?:\.{1,2}|[^\/]+?|)(\.[^.\/]*|))(?:[\/]*)$/;return a.exec(r).slice(1)},normalizeArray:(r,a)=>{for(var c=0,u=r.length-1;u>=0;u--){var p=r[u];p==="."?r.splice(u,1):p===".."?(r.splice(u,1),c++):c&&(r.splice(u,1),c--)}if(a)for(;c;c--)r.unshift("..");return r},normalize:r=>{var a=$.isAbs(r),c=r.slice(-1)==="/";return r=$.normalizeArray(r.split("/").filter(u=>!!u),!a).join("/"),!r&&!a&&(r="."),r&&c&&(r+="/"),(a?"/":"")+r},dirname:r=>{var a=$.splitPath(r),c=a[0],u=a[1];return!c&&!u?".":(u&&(u=u.slice(0,-1)),c+u)},basename:r=>r&&r.match(/([^\/]+|\/)\/*$/)[1],join:(...r)=>$.normalize(r.join("/")),join2:(r,a)=>$.normalize(r+"/"+a)},Ie=()=>{if(o){var r=h("crypto");return a=>r.randomFillSync(a)}return a=>crypto.getRandomValues(a)},ze=r=>{(ze=Ie())(r)},Te={resolve:(...r)=>{for(var a="",c=!1,u=r.length-1;u>=-1&&!c;u--){var p=u>=0?r[u]:M.cwd();if(typeof p!="string")throw new TypeError("Arguments to path.resolve must be strings");if(!p)return"";a=p+"/"+a,c=$.isAbs(p)}return a=$.normalizeArray(a.split("/").filter(_=>!!_),!c).join("/"),(c?"/":"")+a||"."},relative:(r,a)=>{r=Te.resolve(r).slice(1),a=Te.resolve(a).slice(1);function c(X){for(var Q=0;Q<X.length&&X[Q]==="";Q++);for(var oe=X.length-1;oe>=0&&X[oe]==="";oe--);return Q>oe?[]:X.slice(Q,oe-Q+1)}for(var u=c(r.split("/")),p=c(a.split("/")),_=Math.min(u.length,p.length),w=_,A=0;A<_;A++)if(u[A]!==p[A]){w=A;break}for(var F=[],A=w;A<u.length;A++)F.push("..");return F=F.concat(p.slice(w)),F.join("/")}},Ne=[],Ge=r=>{for(var a=0,c=0;c<r.length;++c){var u=r.charCodeAt(c);u<=127?a++:u<=2047?a+=2:u>=55296&&u<=57343?(a+=4,++c):a+=3}return a},rt=(r,a,c,u)=>{if(G(typeof r=="string",`stringToUTF8Array expects a string (got ${typeof r})`),!(u>0))return 0;for(var p=c,_=c+u-1,w=0;w<r.length;++w){var A=r.codePointAt(w);if(A<=127){if(c>=_)break;a[c++]=A}else if(A<=2047){if(c+1>=_)break;a[c++]=192|A>>6,a[c++]=128|A&63}else if(A<=65535){if(c+2>=_)break;a[c++]=224|A>>12,a[c++]=128|A>>6&63,a[c++]=128|A&63}else{if(c+3>=_)break;A>1114111&&Jn("Invalid Unicode code point "+Ot(A)+" encountered when serializing a JS string to a UTF-8 string in wasm memory! (Valid unicode code points should be in range 0-0x10FFFF)."),a[c++]=240|A>>18,a[c++]=128|A>>12&63,a[c++]=128|A>>6&63,a[c++]=128|A&63,w++}}return a[c]=0,c-p},gt=(r,a,c)=>{var u=c>0?c:Ge(r)+1,p=new Array(u),_=rt(r,p,0,p.length);return a&&(p.length=_),p},Ve=()=>{if(!Ne.length){var r=null;if(o){var a=256,c=Buffer.alloc(a),u=0,p=process.stdin.fd;try{u=P.readSync(p,c,0,a)}catch(_){if(_.toString().includes("EOF"))u=0;else throw _}u>0&&(r=c.slice(0,u).toString("utf-8"))}else typeof window<"u"&&typeof window.prompt=="function"&&(r=window.prompt("Input: "),r!==null&&(r+=`
`));if(!r)return null;Ne=gt(r,!0)}return Ne.shift()},lt={ttys:[],init(){},shutdown(){},register(r,a){lt.ttys[r]={input:[],output:[],ops:a},M.registerDevice(r,lt.stream_ops)},stream_ops:{open(r){var a=lt.ttys[r.node.rdev];if(!a)throw new M.ErrnoError(43);r.tty=a,r.seekable=!1},close(r){r.tty.ops.fsync(r.tty)},fsync(r){r.tty.ops.fsync(r.tty)},read(r,a,c,u,p){if(!r.tty||!r.tty.ops.get_char)throw new M.ErrnoError(60);for(var _=0,w=0;w<u;w++){var A;try{A=r.tty.ops.get_char(r.tty)}catch{throw new M.ErrnoError(29)}if(A===void 0&&_===0)throw new M.ErrnoError(6);if(A==null)break;_++,a[c+w]=A}return _&&(r.node.atime=Date.now()),_},write(r,a,c,u,p){if(!r.tty||!r.tty.ops.put_char)throw new M.ErrnoError(60);try{for(var _=0;_<u;_++)r.tty.ops.put_char(r.tty,a[c+_])}catch{throw new M.ErrnoError(29)}return u&&(r.node.mtime=r.node.ctime=Date.now()),_}},default_tty_ops:{get_char(r){return Ve()},put_char(r,a){a===null||a===10?(U(_i(r.output)),r.output=[]):a!=0&&r.output.push(a)},fsync(r){r.output?.length>0&&(U(_i(r.output)),r.output=[])},ioctl_tcgets(r){return{c_iflag:25856,c_oflag:5,c_cflag:191,c_lflag:35387,c_cc:[3,28,127,21,4,0,1,0,17,19,26,0,18,15,23,22,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}},ioctl_tcsets(r,a,c){return 0},ioctl_tiocgwinsz(r){return[24,80]}},default_tty1_ops:{put_char(r,a){a===null||a===10?(I(_i(r.output)),r.output=[]):a!=0&&r.output.push(a)},fsync(r){r.output?.length>0&&(I(_i(r.output)),r.output=[])}}},Wt=r=>{pe("internal error: mmapAlloc called but `emscripten_builtin_memalign` native symbol not exported")},ke={ops_table:null,mount(r){return ke.createNode(null,"/",16895,0)},createNode(r,a,c,u){if(M.isBlkdev(c)||M.isFIFO(c))throw new M.ErrnoError(63);ke.ops_table||={dir:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,lookup:ke.node_ops.lookup,mknod:ke.node_ops.mknod,rename:ke.node_ops.rename,unlink:ke.node_ops.unlink,rmdir:ke.node_ops.rmdir,readdir:ke.node_ops.readdir,symlink:ke.node_ops.symlink},stream:{llseek:ke.stream_ops.llseek}},file:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:{llseek:ke.stream_ops.llseek,read:ke.stream_ops.read,write:ke.stream_ops.write,mmap:ke.stream_ops.mmap,msync:ke.stream_ops.msync}},link:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,readlink:ke.node_ops.readlink},stream:{}},chrdev:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:M.chrdev_stream_ops}};var p=M.createNode(r,a,c,u);return M.isDir(p.mode)?(p.node_ops=ke.ops_table.dir.node,p.stream_ops=ke.ops_table.dir.stream,p.contents={}):M.isFile(p.mode)?(p.node_ops=ke.ops_table.file.node,p.stream_ops=ke.ops_table.file.stream,p.usedBytes=0,p.contents=null):M.isLink(p.mode)?(p.node_ops=ke.ops_table.link.node,p.stream_ops=ke.ops_table.link.stream):M.isChrdev(p.mode)&&(p.node_ops=ke.ops_table.chrdev.node,p.stream_ops=ke.ops_table.chrdev.stream),p.atime=p.mtime=p.ctime=Date.now(),r&&(r.contents[a]=p,r.atime=r.mtime=r.ctime=p.atime),p},getFileDataAsTypedArray(r){return r.contents?r.contents.subarray?r.contents.subarray(0,r.usedBytes):new Uint8Array(r.contents):new Uint8Array(0)},expandFileStorage(r,a){var c=r.contents?r.contents.length:0;if(!(c>=a)){var u=1024*1024;a=Math.max(a,c*(c<u?2:1.125)>>>0),c!=0&&(a=Math.max(a,256));var p=r.contents;r.contents=new Uint8Array(a),r.usedBytes>0&&r.contents.set(p.subarray(0,r.usedBytes),0)}},resizeFileStorage(r,a){if(r.usedBytes!=a)if(a==0)r.contents=null,r.usedBytes=0;else{var c=r.contents;r.contents=new Uint8Array(a),c&&r.contents.set(c.subarray(0,Math.min(a,r.usedBytes))),r.usedBytes=a}},node_ops:{getattr(r){var a={};return a.dev=M.isChrdev(r.mode)?r.id:1,a.ino=r.id,a.mode=r.mode,a.nlink=1,a.uid=0,a.gid=0,a.rdev=r.rdev,M.isDir(r.mode)?a.size=4096:M.isFile(r.mode)?a.size=r.usedBytes:M.isLink(r.mode)?a.size=r.link.length:a.size=0,a.atime=new Date(r.atime),a.mtime=new Date(r.mtime),a.ctime=new Date(r.ctime),a.blksize=4096,a.blocks=Math.ceil(a.size/a.blksize),a},setattr(r,a){for(let c of["mode","atime","mtime","ctime"])a[c]!=null&&(r[c]=a[c]);a.size!==void 0&&ke.resizeFileStorage(r,a.size)},lookup(r,a){throw new M.ErrnoError(44)},mknod(r,a,c,u){return ke.createNode(r,a,c,u)},rename(r,a,c){var u;try{u=M.lookupNode(a,c)}catch{}if(u){if(M.isDir(r.mode))for(var p in u.contents)throw new M.ErrnoError(55);M.hashRemoveNode(u)}delete r.parent.contents[r.name],a.contents[c]=r,r.name=c,a.ctime=a.mtime=r.parent.ctime=r.parent.mtime=Date.now()},unlink(r,a){delete r.contents[a],r.ctime=r.mtime=Date.now()},rmdir(r,a){var c=M.lookupNode(r,a);for(var u in c.contents)throw new M.ErrnoError(55);delete r.contents[a],r.ctime=r.mtime=Date.now()},readdir(r){return[".","..",...Object.keys(r.contents)]},symlink(r,a,c){var u=ke.createNode(r,a,41471,0);return u.link=c,u},readlink(r){if(!M.isLink(r.mode))throw new M.ErrnoError(28);return r.link}},stream_ops:{read(r,a,c,u,p){var _=r.node.contents;if(p>=r.node.usedBytes)return 0;var w=Math.min(r.node.usedBytes-p,u);if(G(w>=0),w>8&&_.subarray)a.set(_.subarray(p,p+w),c);else for(var A=0;A<w;A++)a[c+A]=_[p+A];return w},write(r,a,c,u,p,_){if(G(!(a instanceof ArrayBuffer)),a.buffer===pt.buffer&&(_=!1),!u)return 0;var w=r.node;if(w.mtime=w.ctime=Date.now(),a.subarray&&(!w.contents||w.contents.subarray)){if(_)return G(p===0,"canOwn must imply no weird position inside the file"),w.contents=a.subarray(c,c+u),w.usedBytes=u,u;if(w.usedBytes===0&&p===0)return w.contents=a.slice(c,c+u),w.usedBytes=u,u;if(p+u<=w.usedBytes)return w.contents.set(a.subarray(c,c+u),p),u}if(ke.expandFileStorage(w,p+u),w.contents.subarray&&a.subarray)w.contents.set(a.subarray(c,c+u),p);else for(var A=0;A<u;A++)w.contents[p+A]=a[c+A];return w.usedBytes=Math.max(w.usedBytes,p+u),u},llseek(r,a,c){var u=a;if(c===1?u+=r.position:c===2&&M.isFile(r.node.mode)&&(u+=r.node.usedBytes),u<0)throw new M.ErrnoError(28);return u},mmap(r,a,c,u,p){if(!M.isFile(r.node.mode))throw new M.ErrnoError(43);var _,w,A=r.node.contents;if(!(p&2)&&A&&A.buffer===pt.buffer)w=!1,_=A.byteOffset;else{if(w=!0,_=Wt(a),!_)throw new M.ErrnoError(48);A&&((c>0||c+a<A.length)&&(A.subarray?A=A.subarray(c,c+a):A=Array.prototype.slice.call(A,c,c+a)),pt.set(A,_))}return{ptr:_,allocated:w}},msync(r,a,c,u,p){return ke.stream_ops.write(r,a,0,u,c,!1),0}}},Dt=async r=>{var a=await E(r);return G(a,`Loading data file "${r}" failed (no arrayBuffer).`),new Uint8Array(a)},jt=(...r)=>M.createDataFile(...r),He=r=>{for(var a=r;;){if(!T[r])return r;r=a+Math.random()}},an=[],wt=(r,a,c,u)=>{typeof Browser<"u"&&Browser.init();var p=!1;return an.forEach(_=>{p||_.canHandle(a)&&(_.handle(r,a,c,u),p=!0)}),p},Kn=(r,a,c,u,p,_,w,A,F,X)=>{var Q=a?Te.resolve($.join2(r,a)):r,oe=He(`cp ${Q}`);function fe(ce){function me(Ye){X?.(),A||jt(r,a,Ye,u,p,F),_?.(),de(oe)}wt(ce,Q,me,()=>{w?.(),de(oe)})||me(ce)}ve(oe),typeof c=="string"?Dt(c).then(fe,w):fe(c)},on=r=>{var a={r:0,"r+":2,w:577,"w+":578,a:1089,"a+":1090},c=a[r];if(typeof c>"u")throw new Error(`Unknown file open mode: ${r}`);return c},Ii=(r,a)=>{var c=0;return r&&(c|=365),a&&(c|=146),c},Qn=r=>un(Qh(r)),ei={EPERM:63,ENOENT:44,ESRCH:71,EINTR:27,EIO:29,ENXIO:60,E2BIG:1,ENOEXEC:45,EBADF:8,ECHILD:12,EAGAIN:6,EWOULDBLOCK:6,ENOMEM:48,EACCES:2,EFAULT:21,ENOTBLK:105,EBUSY:10,EEXIST:20,EXDEV:75,ENODEV:43,ENOTDIR:54,EISDIR:31,EINVAL:28,ENFILE:41,EMFILE:33,ENOTTY:59,ETXTBSY:74,EFBIG:22,ENOSPC:51,ESPIPE:70,EROFS:69,EMLINK:34,EPIPE:64,EDOM:18,ERANGE:68,ENOMSG:49,EIDRM:24,ECHRNG:106,EL2NSYNC:156,EL3HLT:107,EL3RST:108,ELNRNG:109,EUNATCH:110,ENOCSI:111,EL2HLT:112,EDEADLK:16,ENOLCK:46,EBADE:113,EBADR:114,EXFULL:115,ENOANO:104,EBADRQC:103,EBADSLT:102,EDEADLOCK:16,EBFONT:101,ENOSTR:100,ENODATA:116,ETIME:117,ENOSR:118,ENONET:119,ENOPKG:120,EREMOTE:121,ENOLINK:47,EADV:122,ESRMNT:123,ECOMM:124,EPROTO:65,EMULTIHOP:36,EDOTDOT:125,EBADMSG:9,ENOTUNIQ:126,EBADFD:127,EREMCHG:128,ELIBACC:129,ELIBBAD:130,ELIBSCN:131,ELIBMAX:132,ELIBEXEC:133,ENOSYS:52,ENOTEMPTY:55,ENAMETOOLONG:37,ELOOP:32,EOPNOTSUPP:138,EPFNOSUPPORT:139,ECONNRESET:15,ENOBUFS:42,EAFNOSUPPORT:5,EPROTOTYPE:67,ENOTSOCK:57,ENOPROTOOPT:50,ESHUTDOWN:140,ECONNREFUSED:14,EADDRINUSE:3,ECONNABORTED:13,ENETUNREACH:40,ENETDOWN:38,ETIMEDOUT:73,EHOSTDOWN:142,EHOSTUNREACH:23,EINPROGRESS:26,EALREADY:7,EDESTADDRREQ:17,EMSGSIZE:35,EPROTONOSUPPORT:66,ESOCKTNOSUPPORT:137,EADDRNOTAVAIL:4,ENETRESET:39,EISCONN:30,ENOTCONN:53,ETOOMANYREFS:141,EUSERS:136,EDQUOT:19,ESTALE:72,ENOTSUP:138,ENOMEDIUM:148,EILSEQ:25,EOVERFLOW:61,ECANCELED:11,ENOTRECOVERABLE:56,EOWNERDEAD:62,ESTRPIPE:135},M={root:null,mounts:[],devices:{},streams:[],nextInode:1,nameTable:null,currentPath:"/",initialized:!1,ignorePermissions:!0,filesystems:null,syncFSRequests:0,readFiles:{},ErrnoError:class extends Error{name="ErrnoError";constructor(r){super(Rt?Qn(r):""),this.errno=r;for(var a in ei)if(ei[a]===r){this.code=a;break}}},FSStream:class{shared={};get object(){return this.node}set object(r){this.node=r}get isRead(){return(this.flags&2097155)!==1}get isWrite(){return(this.flags&2097155)!==0}get isAppend(){return this.flags&1024}get flags(){return this.shared.flags}set flags(r){this.shared.flags=r}get position(){return this.shared.position}set position(r){this.shared.position=r}},FSNode:class{node_ops={};stream_ops={};readMode=365;writeMode=146;mounted=null;constructor(r,a,c,u){r||(r=this),this.parent=r,this.mount=r.mount,this.id=M.nextInode++,this.name=a,this.mode=c,this.rdev=u,this.atime=this.mtime=this.ctime=Date.now()}get read(){return(this.mode&this.readMode)===this.readMode}set read(r){r?this.mode|=this.readMode:this.mode&=~this.readMode}get write(){return(this.mode&this.writeMode)===this.writeMode}set write(r){r?this.mode|=this.writeMode:this.mode&=~this.writeMode}get isFolder(){return M.isDir(this.mode)}get isDevice(){return M.isChrdev(this.mode)}},lookupPath(r,a={}){if(!r)throw new M.ErrnoError(44);a.follow_mount??=!0,$.isAbs(r)||(r=M.cwd()+"/"+r);e:for(var c=0;c<40;c++){for(var u=r.split("/").filter(X=>!!X),p=M.root,_="/",w=0;w<u.length;w++){var A=w===u.length-1;if(A&&a.parent)break;if(u[w]!=="."){if(u[w]===".."){if(_=$.dirname(_),M.isRoot(p)){r=_+"/"+u.slice(w+1).join("/");continue e}else p=p.parent;continue}_=$.join2(_,u[w]);try{p=M.lookupNode(p,u[w])}catch(X){if(X?.errno===44&&A&&a.noent_okay)return{path:_};throw X}if(M.isMountpoint(p)&&(!A||a.follow_mount)&&(p=p.mounted.root),M.isLink(p.mode)&&(!A||a.follow)){if(!p.node_ops.readlink)throw new M.ErrnoError(52);var F=p.node_ops.readlink(p);$.isAbs(F)||(F=$.dirname(_)+"/"+F),r=F+"/"+u.slice(w+1).join("/");continue e}}}return{path:_,node:p}}throw new M.ErrnoError(32)},getPath(r){for(var a;;){if(M.isRoot(r)){var c=r.mount.mountpoint;return a?c[c.length-1]!=="/"?`${c}/${a}`:c+a:c}a=a?`${r.name}/${a}`:r.name,r=r.parent}},hashName(r,a){for(var c=0,u=0;u<a.length;u++)c=(c<<5)-c+a.charCodeAt(u)|0;return(r+c>>>0)%M.nameTable.length},hashAddNode(r){var a=M.hashName(r.parent.id,r.name);r.name_next=M.nameTable[a],M.nameTable[a]=r},hashRemoveNode(r){var a=M.hashName(r.parent.id,r.name);if(M.nameTable[a]===r)M.nameTable[a]=r.name_next;else for(var c=M.nameTable[a];c;){if(c.name_next===r){c.name_next=r.name_next;break}c=c.name_next}},lookupNode(r,a){var c=M.mayLookup(r);if(c)throw new M.ErrnoError(c);for(var u=M.hashName(r.id,a),p=M.nameTable[u];p;p=p.name_next){var _=p.name;if(p.parent.id===r.id&&_===a)return p}return M.lookup(r,a)},createNode(r,a,c,u){G(typeof r=="object");var p=new M.FSNode(r,a,c,u);return M.hashAddNode(p),p},destroyNode(r){M.hashRemoveNode(r)},isRoot(r){return r===r.parent},isMountpoint(r){return!!r.mounted},isFile(r){return(r&61440)===32768},isDir(r){return(r&61440)===16384},isLink(r){return(r&61440)===40960},isChrdev(r){return(r&61440)===8192},isBlkdev(r){return(r&61440)===24576},isFIFO(r){return(r&61440)===4096},isSocket(r){return(r&49152)===49152},flagsToPermissionString(r){var a=["r","w","rw"][r&3];return r&512&&(a+="w"),a},nodePermissions(r,a){return M.ignorePermissions?0:a.includes("r")&&!(r.mode&292)||a.includes("w")&&!(r.mode&146)||a.includes("x")&&!(r.mode&73)?2:0},mayLookup(r){if(!M.isDir(r.mode))return 54;var a=M.nodePermissions(r,"x");return a||(r.node_ops.lookup?0:2)},mayCreate(r,a){if(!M.isDir(r.mode))return 54;try{var c=M.lookupNode(r,a);return 20}catch{}return M.nodePermissions(r,"wx")},mayDelete(r,a,c){var u;try{u=M.lookupNode(r,a)}catch(_){return _.errno}var p=M.nodePermissions(r,"wx");if(p)return p;if(c){if(!M.isDir(u.mode))return 54;if(M.isRoot(u)||M.getPath(u)===M.cwd())return 10}else if(M.isDir(u.mode))return 31;return 0},mayOpen(r,a){return r?M.isLink(r.mode)?32:M.isDir(r.mode)&&(M.flagsToPermissionString(a)!=="r"||a&576)?31:M.nodePermissions(r,M.flagsToPermissionString(a)):44},checkOpExists(r,a){if(!r)throw new M.ErrnoError(a);return r},MAX_OPEN_FDS:4096,nextfd(){for(var r=0;r<=M.MAX_OPEN_FDS;r++)if(!M.streams[r])return r;throw new M.ErrnoError(33)},getStreamChecked(r){var a=M.getStream(r);if(!a)throw new M.ErrnoError(8);return a},getStream:r=>M.streams[r],createStream(r,a=-1){return G(a>=-1),r=Object.assign(new M.FSStream,r),a==-1&&(a=M.nextfd()),r.fd=a,M.streams[a]=r,r},closeStream(r){M.streams[r]=null},dupStream(r,a=-1){var c=M.createStream(r,a);return c.stream_ops?.dup?.(c),c},doSetAttr(r,a,c){var u=r?.stream_ops.setattr,p=u?r:a;u??=a.node_ops.setattr,M.checkOpExists(u,63),u(p,c)},chrdev_stream_ops:{open(r){var a=M.getDevice(r.node.rdev);r.stream_ops=a.stream_ops,r.stream_ops.open?.(r)},llseek(){throw new M.ErrnoError(70)}},major:r=>r>>8,minor:r=>r&255,makedev:(r,a)=>r<<8|a,registerDevice(r,a){M.devices[r]={stream_ops:a}},getDevice:r=>M.devices[r],getMounts(r){for(var a=[],c=[r];c.length;){var u=c.pop();a.push(u),c.push(...u.mounts)}return a},syncfs(r,a){typeof r=="function"&&(a=r,r=!1),M.syncFSRequests++,M.syncFSRequests>1&&I(`warning: ${M.syncFSRequests} FS.syncfs operations in flight at once, probably just doing extra work`);var c=M.getMounts(M.root.mount),u=0;function p(w){return G(M.syncFSRequests>0),M.syncFSRequests--,a(w)}function _(w){if(w)return _.errored?void 0:(_.errored=!0,p(w));++u>=c.length&&p(null)}c.forEach(w=>{if(!w.type.syncfs)return _(null);w.type.syncfs(w,r,_)})},mount(r,a,c){if(typeof r=="string")throw r;var u=c==="/",p=!c,_;if(u&&M.root)throw new M.ErrnoError(10);if(!u&&!p){var w=M.lookupPath(c,{follow_mount:!1});if(c=w.path,_=w.node,M.isMountpoint(_))throw new M.ErrnoError(10);if(!M.isDir(_.mode))throw new M.ErrnoError(54)}var A={type:r,opts:a,mountpoint:c,mounts:[]},F=r.mount(A);return F.mount=A,A.root=F,u?M.root=F:_&&(_.mounted=A,_.mount&&_.mount.mounts.push(A)),F},unmount(r){var a=M.lookupPath(r,{follow_mount:!1});if(!M.isMountpoint(a.node))throw new M.ErrnoError(28);var c=a.node,u=c.mounted,p=M.getMounts(u);Object.keys(M.nameTable).forEach(w=>{for(var A=M.nameTable[w];A;){var F=A.name_next;p.includes(A.mount)&&M.destroyNode(A),A=F}}),c.mounted=null;var _=c.mount.mounts.indexOf(u);G(_!==-1),c.mount.mounts.splice(_,1)},lookup(r,a){return r.node_ops.lookup(r,a)},mknod(r,a,c){var u=M.lookupPath(r,{parent:!0}),p=u.node,_=$.basename(r);if(!_)throw new M.ErrnoError(28);if(_==="."||_==="..")throw new M.ErrnoError(20);var w=M.mayCreate(p,_);if(w)throw new M.ErrnoError(w);if(!p.node_ops.mknod)throw new M.ErrnoError(63);return p.node_ops.mknod(p,_,a,c)},statfs(r){return M.statfsNode(M.lookupPath(r,{follow:!0}).node)},statfsStream(r){return M.statfsNode(r.node)},statfsNode(r){var a={bsize:4096,frsize:4096,blocks:1e6,bfree:5e5,bavail:5e5,files:M.nextInode,ffree:M.nextInode-1,fsid:42,flags:2,namelen:255};return r.node_ops.statfs&&Object.assign(a,r.node_ops.statfs(r.mount.opts.root)),a},create(r,a=438){return a&=4095,a|=32768,M.mknod(r,a,0)},mkdir(r,a=511){return a&=1023,a|=16384,M.mknod(r,a,0)},mkdirTree(r,a){var c=r.split("/"),u="";for(var p of c)if(p){(u||$.isAbs(r))&&(u+="/"),u+=p;try{M.mkdir(u,a)}catch(_){if(_.errno!=20)throw _}}},mkdev(r,a,c){return typeof c>"u"&&(c=a,a=438),a|=8192,M.mknod(r,a,c)},symlink(r,a){if(!Te.resolve(r))throw new M.ErrnoError(44);var c=M.lookupPath(a,{parent:!0}),u=c.node;if(!u)throw new M.ErrnoError(44);var p=$.basename(a),_=M.mayCreate(u,p);if(_)throw new M.ErrnoError(_);if(!u.node_ops.symlink)throw new M.ErrnoError(63);return u.node_ops.symlink(u,p,r)},rename(r,a){var c=$.dirname(r),u=$.dirname(a),p=$.basename(r),_=$.basename(a),w,A,F;if(w=M.lookupPath(r,{parent:!0}),A=w.node,w=M.lookupPath(a,{parent:!0}),F=w.node,!A||!F)throw new M.ErrnoError(44);if(A.mount!==F.mount)throw new M.ErrnoError(75);var X=M.lookupNode(A,p),Q=Te.relative(r,u);if(Q.charAt(0)!==".")throw new M.ErrnoError(28);if(Q=Te.relative(a,c),Q.charAt(0)!==".")throw new M.ErrnoError(55);var oe;try{oe=M.lookupNode(F,_)}catch{}if(X!==oe){var fe=M.isDir(X.mode),ce=M.mayDelete(A,p,fe);if(ce)throw new M.ErrnoError(ce);if(ce=oe?M.mayDelete(F,_,fe):M.mayCreate(F,_),ce)throw new M.ErrnoError(ce);if(!A.node_ops.rename)throw new M.ErrnoError(63);if(M.isMountpoint(X)||oe&&M.isMountpoint(oe))throw new M.ErrnoError(10);if(F!==A&&(ce=M.nodePermissions(A,"w"),ce))throw new M.ErrnoError(ce);M.hashRemoveNode(X);try{A.node_ops.rename(X,F,_),X.parent=F}catch(me){throw me}finally{M.hashAddNode(X)}}},rmdir(r){var a=M.lookupPath(r,{parent:!0}),c=a.node,u=$.basename(r),p=M.lookupNode(c,u),_=M.mayDelete(c,u,!0);if(_)throw new M.ErrnoError(_);if(!c.node_ops.rmdir)throw new M.ErrnoError(63);if(M.isMountpoint(p))throw new M.ErrnoError(10);c.node_ops.rmdir(c,u),M.destroyNode(p)},readdir(r){var a=M.lookupPath(r,{follow:!0}),c=a.node,u=M.checkOpExists(c.node_ops.readdir,54);return u(c)},unlink(r){var a=M.lookupPath(r,{parent:!0}),c=a.node;if(!c)throw new M.ErrnoError(44);var u=$.basename(r),p=M.lookupNode(c,u),_=M.mayDelete(c,u,!1);if(_)throw new M.ErrnoError(_);if(!c.node_ops.unlink)throw new M.ErrnoError(63);if(M.isMountpoint(p))throw new M.ErrnoError(10);c.node_ops.unlink(c,u),M.destroyNode(p)},readlink(r){var a=M.lookupPath(r),c=a.node;if(!c)throw new M.ErrnoError(44);if(!c.node_ops.readlink)throw new M.ErrnoError(28);return c.node_ops.readlink(c)},stat(r,a){var c=M.lookupPath(r,{follow:!a}),u=c.node,p=M.checkOpExists(u.node_ops.getattr,63);return p(u)},fstat(r){var a=M.getStreamChecked(r),c=a.node,u=a.stream_ops.getattr,p=u?a:c;return u??=c.node_ops.getattr,M.checkOpExists(u,63),u(p)},lstat(r){return M.stat(r,!0)},doChmod(r,a,c,u){M.doSetAttr(r,a,{mode:c&4095|a.mode&-4096,ctime:Date.now(),dontFollow:u})},chmod(r,a,c){var u;if(typeof r=="string"){var p=M.lookupPath(r,{follow:!c});u=p.node}else u=r;M.doChmod(null,u,a,c)},lchmod(r,a){M.chmod(r,a,!0)},fchmod(r,a){var c=M.getStreamChecked(r);M.doChmod(c,c.node,a,!1)},doChown(r,a,c){M.doSetAttr(r,a,{timestamp:Date.now(),dontFollow:c})},chown(r,a,c,u){var p;if(typeof r=="string"){var _=M.lookupPath(r,{follow:!u});p=_.node}else p=r;M.doChown(null,p,u)},lchown(r,a,c){M.chown(r,a,c,!0)},fchown(r,a,c){var u=M.getStreamChecked(r);M.doChown(u,u.node,!1)},doTruncate(r,a,c){if(M.isDir(a.mode))throw new M.ErrnoError(31);if(!M.isFile(a.mode))throw new M.ErrnoError(28);var u=M.nodePermissions(a,"w");if(u)throw new M.ErrnoError(u);M.doSetAttr(r,a,{size:c,timestamp:Date.now()})},truncate(r,a){if(a<0)throw new M.ErrnoError(28);var c;if(typeof r=="string"){var u=M.lookupPath(r,{follow:!0});c=u.node}else c=r;M.doTruncate(null,c,a)},ftruncate(r,a){var c=M.getStreamChecked(r);if(a<0||(c.flags&2097155)===0)throw new M.ErrnoError(28);M.doTruncate(c,c.node,a)},utime(r,a,c){var u=M.lookupPath(r,{follow:!0}),p=u.node,_=M.checkOpExists(p.node_ops.setattr,63);_(p,{atime:a,mtime:c})},open(r,a,c=438){if(r==="")throw new M.ErrnoError(44);a=typeof a=="string"?on(a):a,a&64?c=c&4095|32768:c=0;var u,p;if(typeof r=="object")u=r;else{p=r.endsWith("/");var _=M.lookupPath(r,{follow:!(a&131072),noent_okay:!0});u=_.node,r=_.path}var w=!1;if(a&64)if(u){if(a&128)throw new M.ErrnoError(20)}else{if(p)throw new M.ErrnoError(31);u=M.mknod(r,c|511,0),w=!0}if(!u)throw new M.ErrnoError(44);if(M.isChrdev(u.mode)&&(a&=-513),a&65536&&!M.isDir(u.mode))throw new M.ErrnoError(54);if(!w){var A=M.mayOpen(u,a);if(A)throw new M.ErrnoError(A)}a&512&&!w&&M.truncate(u,0),a&=-131713;var F=M.createStream({node:u,path:M.getPath(u),flags:a,seekable:!0,position:0,stream_ops:u.stream_ops,ungotten:[],error:!1});return F.stream_ops.open&&F.stream_ops.open(F),w&&M.chmod(u,c&511),t.logReadFiles&&!(a&1)&&(r in M.readFiles||(M.readFiles[r]=1)),F},close(r){if(M.isClosed(r))throw new M.ErrnoError(8);r.getdents&&(r.getdents=null);try{r.stream_ops.close&&r.stream_ops.close(r)}catch(a){throw a}finally{M.closeStream(r.fd)}r.fd=null},isClosed(r){return r.fd===null},llseek(r,a,c){if(M.isClosed(r))throw new M.ErrnoError(8);if(!r.seekable||!r.stream_ops.llseek)throw new M.ErrnoError(70);if(c!=0&&c!=1&&c!=2)throw new M.ErrnoError(28);return r.position=r.stream_ops.llseek(r,a,c),r.ungotten=[],r.position},read(r,a,c,u,p){if(G(c>=0),u<0||p<0)throw new M.ErrnoError(28);if(M.isClosed(r))throw new M.ErrnoError(8);if((r.flags&2097155)===1)throw new M.ErrnoError(8);if(M.isDir(r.node.mode))throw new M.ErrnoError(31);if(!r.stream_ops.read)throw new M.ErrnoError(28);var _=typeof p<"u";if(!_)p=r.position;else if(!r.seekable)throw new M.ErrnoError(70);var w=r.stream_ops.read(r,a,c,u,p);return _||(r.position+=w),w},write(r,a,c,u,p,_){if(G(c>=0),u<0||p<0)throw new M.ErrnoError(28);if(M.isClosed(r))throw new M.ErrnoError(8);if((r.flags&2097155)===0)throw new M.ErrnoError(8);if(M.isDir(r.node.mode))throw new M.ErrnoError(31);if(!r.stream_ops.write)throw new M.ErrnoError(28);r.seekable&&r.flags&1024&&M.llseek(r,0,2);var w=typeof p<"u";if(!w)p=r.position;else if(!r.seekable)throw new M.ErrnoError(70);var A=r.stream_ops.write(r,a,c,u,p,_);return w||(r.position+=A),A},mmap(r,a,c,u,p){if((u&2)!==0&&(p&2)===0&&(r.flags&2097155)!==2)throw new M.ErrnoError(2);if((r.flags&2097155)===1)throw new M.ErrnoError(2);if(!r.stream_ops.mmap)throw new M.ErrnoError(43);if(!a)throw new M.ErrnoError(28);return r.stream_ops.mmap(r,a,c,u,p)},msync(r,a,c,u,p){return G(c>=0),r.stream_ops.msync?r.stream_ops.msync(r,a,c,u,p):0},ioctl(r,a,c){if(!r.stream_ops.ioctl)throw new M.ErrnoError(59);return r.stream_ops.ioctl(r,a,c)},readFile(r,a={}){if(a.flags=a.flags||0,a.encoding=a.encoding||"binary",a.encoding!=="utf8"&&a.encoding!=="binary")throw new Error(`Invalid encoding type "${a.encoding}"`);var c=M.open(r,a.flags),u=M.stat(r),p=u.size,_=new Uint8Array(p);return M.read(c,_,0,p,0),a.encoding==="utf8"&&(_=_i(_)),M.close(c),_},writeFile(r,a,c={}){c.flags=c.flags||577;var u=M.open(r,c.flags,c.mode);if(typeof a=="string"&&(a=new Uint8Array(gt(a,!0))),ArrayBuffer.isView(a))M.write(u,a,0,a.byteLength,void 0,c.canOwn);else throw new Error("Unsupported data type");M.close(u)},cwd:()=>M.currentPath,chdir(r){var a=M.lookupPath(r,{follow:!0});if(a.node===null)throw new M.ErrnoError(44);if(!M.isDir(a.node.mode))throw new M.ErrnoError(54);var c=M.nodePermissions(a.node,"x");if(c)throw new M.ErrnoError(c);M.currentPath=a.path},createDefaultDirectories(){M.mkdir("/tmp"),M.mkdir("/home"),M.mkdir("/home/web_user")},createDefaultDevices(){M.mkdir("/dev"),M.registerDevice(M.makedev(1,3),{read:()=>0,write:(u,p,_,w,A)=>w,llseek:()=>0}),M.mkdev("/dev/null",M.makedev(1,3)),lt.register(M.makedev(5,0),lt.default_tty_ops),lt.register(M.makedev(6,0),lt.default_tty1_ops),M.mkdev("/dev/tty",M.makedev(5,0)),M.mkdev("/dev/tty1",M.makedev(6,0));var r=new Uint8Array(1024),a=0,c=()=>(a===0&&(ze(r),a=r.byteLength),r[--a]);M.createDevice("/dev","random",c),M.createDevice("/dev","urandom",c),M.mkdir("/dev/shm"),M.mkdir("/dev/shm/tmp")},createSpecialDirectories(){M.mkdir("/proc");var r=M.mkdir("/proc/self");M.mkdir("/proc/self/fd"),M.mount({mount(){var a=M.createNode(r,"fd",16895,73);return a.stream_ops={llseek:ke.stream_ops.llseek},a.node_ops={lookup(c,u){var p=+u,_=M.getStreamChecked(p),w={parent:null,mount:{mountpoint:"fake"},node_ops:{readlink:()=>_.path},id:p+1};return w.parent=w,w},readdir(){return Array.from(M.streams.entries()).filter(([c,u])=>u).map(([c,u])=>c.toString())}},a}},{},"/proc/self/fd")},createStandardStreams(r,a,c){r?M.createDevice("/dev","stdin",r):M.symlink("/dev/tty","/dev/stdin"),a?M.createDevice("/dev","stdout",null,a):M.symlink("/dev/tty","/dev/stdout"),c?M.createDevice("/dev","stderr",null,c):M.symlink("/dev/tty1","/dev/stderr");var u=M.open("/dev/stdin",0),p=M.open("/dev/stdout",1),_=M.open("/dev/stderr",1);G(u.fd===0,`invalid handle for stdin (${u.fd})`),G(p.fd===1,`invalid handle for stdout (${p.fd})`),G(_.fd===2,`invalid handle for stderr (${_.fd})`)},staticInit(){M.nameTable=new Array(4096),M.mount(ke,{},"/"),M.createDefaultDirectories(),M.createDefaultDevices(),M.createSpecialDirectories(),M.filesystems={MEMFS:ke}},init(r,a,c){G(!M.initialized,"FS.init was previously called. If you want to initialize later with custom parameters, remove any earlier calls (note that one is automatically added to the generated code)"),M.initialized=!0,r??=t.stdin,a??=t.stdout,c??=t.stderr,M.createStandardStreams(r,a,c)},quit(){M.initialized=!1,ql(0);for(var r of M.streams)r&&M.close(r)},findObject(r,a){var c=M.analyzePath(r,a);return c.exists?c.object:null},analyzePath(r,a){try{var c=M.lookupPath(r,{follow:!a});r=c.path}catch{}var u={isRoot:!1,exists:!1,error:0,name:null,path:null,object:null,parentExists:!1,parentPath:null,parentObject:null};try{var c=M.lookupPath(r,{parent:!0});u.parentExists=!0,u.parentPath=c.path,u.parentObject=c.node,u.name=$.basename(r),c=M.lookupPath(r,{follow:!a}),u.exists=!0,u.path=c.path,u.object=c.node,u.name=c.node.name,u.isRoot=c.path==="/"}catch(p){u.error=p.errno}return u},createPath(r,a,c,u){r=typeof r=="string"?r:M.getPath(r);for(var p=a.split("/").reverse();p.length;){var _=p.pop();if(_){var w=$.join2(r,_);try{M.mkdir(w)}catch(A){if(A.errno!=20)throw A}r=w}}return w},createFile(r,a,c,u,p){var _=$.join2(typeof r=="string"?r:M.getPath(r),a),w=Ii(u,p);return M.create(_,w)},createDataFile(r,a,c,u,p,_){var w=a;r&&(r=typeof r=="string"?r:M.getPath(r),w=a?$.join2(r,a):r);var A=Ii(u,p),F=M.create(w,A);if(c){if(typeof c=="string"){for(var X=new Array(c.length),Q=0,oe=c.length;Q<oe;++Q)X[Q]=c.charCodeAt(Q);c=X}M.chmod(F,A|146);var fe=M.open(F,577);M.write(fe,c,0,c.length,0,_),M.close(fe),M.chmod(F,A)}},createDevice(r,a,c,u){var p=$.join2(typeof r=="string"?r:M.getPath(r),a),_=Ii(!!c,!!u);M.createDevice.major??=64;var w=M.makedev(M.createDevice.major++,0);return M.registerDevice(w,{open(A){A.seekable=!1},close(A){u?.buffer?.length&&u(10)},read(A,F,X,Q,oe){for(var fe=0,ce=0;ce<Q;ce++){var me;try{me=c()}catch{throw new M.ErrnoError(29)}if(me===void 0&&fe===0)throw new M.ErrnoError(6);if(me==null)break;fe++,F[X+ce]=me}return fe&&(A.node.atime=Date.now()),fe},write(A,F,X,Q,oe){for(var fe=0;fe<Q;fe++)try{u(F[X+fe])}catch{throw new M.ErrnoError(29)}return Q&&(A.node.mtime=A.node.ctime=Date.now()),fe}}),M.mkdev(p,_,w)},forceLoadFile(r){if(r.isDevice||r.isFolder||r.link||r.contents)return!0;if(typeof XMLHttpRequest<"u")throw new Error("Lazy loading should have been performed (contents set) in createLazyFile, but it was not. Lazy loading only works in web workers. Use --embed-file or --preload-file in emcc on the main thread.");try{r.contents=R(r.url),r.usedBytes=r.contents.length}catch{throw new M.ErrnoError(29)}},createLazyFile(r,a,c,u,p){class _{lengthKnown=!1;chunks=[];get(ce){if(!(ce>this.length-1||ce<0)){var me=ce%this.chunkSize,Ye=ce/this.chunkSize|0;return this.getter(Ye)[me]}}setDataGetter(ce){this.getter=ce}cacheLength(){var ce=new XMLHttpRequest;if(ce.open("HEAD",c,!1),ce.send(null),!(ce.status>=200&&ce.status<300||ce.status===304))throw new Error("Couldn't load "+c+". Status: "+ce.status);var me=Number(ce.getResponseHeader("Content-length")),Ye,vt=(Ye=ce.getResponseHeader("Accept-Ranges"))&&Ye==="bytes",st=(Ye=ce.getResponseHeader("Content-Encoding"))&&Ye==="gzip",bt=1024*1024;vt||(bt=me);var tt=(Kt,yn)=>{if(Kt>yn)throw new Error("invalid range ("+Kt+", "+yn+") or no bytes requested!");if(yn>me-1)throw new Error("only "+me+" bytes available! programmer error!");var Nt=new XMLHttpRequest;if(Nt.open("GET",c,!1),me!==bt&&Nt.setRequestHeader("Range","bytes="+Kt+"-"+yn),Nt.responseType="arraybuffer",Nt.overrideMimeType&&Nt.overrideMimeType("text/plain; charset=x-user-defined"),Nt.send(null),!(Nt.status>=200&&Nt.status<300||Nt.status===304))throw new Error("Couldn't load "+c+". Status: "+Nt.status);return Nt.response!==void 0?new Uint8Array(Nt.response||[]):gt(Nt.responseText||"",!0)},qt=this;qt.setDataGetter(Kt=>{var yn=Kt*bt,Nt=(Kt+1)*bt-1;if(Nt=Math.min(Nt,me-1),typeof qt.chunks[Kt]>"u"&&(qt.chunks[Kt]=tt(yn,Nt)),typeof qt.chunks[Kt]>"u")throw new Error("doXHR failed!");return qt.chunks[Kt]}),(st||!me)&&(bt=me=1,me=this.getter(0).length,bt=me,U("LazyFiles on gzip forces download of the whole file when length is accessed")),this._length=me,this._chunkSize=bt,this.lengthKnown=!0}get length(){return this.lengthKnown||this.cacheLength(),this._length}get chunkSize(){return this.lengthKnown||this.cacheLength(),this._chunkSize}}if(typeof XMLHttpRequest<"u"){if(!s)throw"Cannot do synchronous binary XHRs outside webworkers in modern browsers. Use --embed-file or --preload-file in emcc";var w=new _,A={isDevice:!1,contents:w}}else var A={isDevice:!1,url:c};var F=M.createFile(r,a,A,u,p);A.contents?F.contents=A.contents:A.url&&(F.contents=null,F.url=A.url),Object.defineProperties(F,{usedBytes:{get:function(){return this.contents.length}}});var X={},Q=Object.keys(F.stream_ops);Q.forEach(fe=>{var ce=F.stream_ops[fe];X[fe]=(...me)=>(M.forceLoadFile(F),ce(...me))});function oe(fe,ce,me,Ye,vt){var st=fe.node.contents;if(vt>=st.length)return 0;var bt=Math.min(st.length-vt,Ye);if(G(bt>=0),st.slice)for(var tt=0;tt<bt;tt++)ce[me+tt]=st[vt+tt];else for(var tt=0;tt<bt;tt++)ce[me+tt]=st.get(vt+tt);return bt}return X.read=(fe,ce,me,Ye,vt)=>(M.forceLoadFile(F),oe(fe,ce,me,Ye,vt)),X.mmap=(fe,ce,me,Ye,vt)=>{M.forceLoadFile(F);var st=Wt(ce);if(!st)throw new M.ErrnoError(48);return oe(fe,pt,st,ce,me),{ptr:st,allocated:!0}},F.stream_ops=X,F},absolutePath(){pe("FS.absolutePath has been removed; use PATH_FS.resolve instead")},createFolder(){pe("FS.createFolder has been removed; use FS.mkdir instead")},createLink(){pe("FS.createLink has been removed; use FS.symlink instead")},joinPath(){pe("FS.joinPath has been removed; use PATH.join instead")},mmapAlloc(){pe("FS.mmapAlloc has been replaced by the top level function mmapAlloc")},standardizePath(){pe("FS.standardizePath has been removed; use PATH.normalize instead")}},ft={DEFAULT_POLLMASK:5,calculateAt(r,a,c){if($.isAbs(a))return a;var u;if(r===-100)u=M.cwd();else{var p=ft.getStreamFromFD(r);u=p.path}if(a.length==0){if(!c)throw new M.ErrnoError(44);return u}return u+"/"+a},writeStat(r,a){De[r>>2]=a.dev,De[r+4>>2]=a.mode,$e[r+8>>2]=a.nlink,De[r+12>>2]=a.uid,De[r+16>>2]=a.gid,De[r+20>>2]=a.rdev,W[r+24>>3]=BigInt(a.size),De[r+32>>2]=4096,De[r+36>>2]=a.blocks;var c=a.atime.getTime(),u=a.mtime.getTime(),p=a.ctime.getTime();return W[r+40>>3]=BigInt(Math.floor(c/1e3)),$e[r+48>>2]=c%1e3*1e3*1e3,W[r+56>>3]=BigInt(Math.floor(u/1e3)),$e[r+64>>2]=u%1e3*1e3*1e3,W[r+72>>3]=BigInt(Math.floor(p/1e3)),$e[r+80>>2]=p%1e3*1e3*1e3,W[r+88>>3]=BigInt(a.ino),0},writeStatFs(r,a){De[r+4>>2]=a.bsize,De[r+40>>2]=a.bsize,De[r+8>>2]=a.blocks,De[r+12>>2]=a.bfree,De[r+16>>2]=a.bavail,De[r+20>>2]=a.files,De[r+24>>2]=a.ffree,De[r+28>>2]=a.fsid,De[r+44>>2]=a.flags,De[r+36>>2]=a.namelen},doMsync(r,a,c,u,p){if(!M.isFile(a.node.mode))throw new M.ErrnoError(43);if(u&2)return 0;var _=It.slice(r,r+c);M.msync(a,_,p,c,u)},getStreamFromFD(r){var a=M.getStreamChecked(r);return a},varargs:void 0,getStr(r){var a=un(r);return a}};function An(r,a,c){try{var u=ft.getStreamFromFD(r);if(G(!c),u.fd===a)return-28;if(a<0||a>=M.MAX_OPEN_FDS)return-8;var p=M.getStream(a);return p&&M.close(p),M.dupStream(u,a).fd}catch(_){if(typeof M>"u"||_.name!=="ErrnoError")throw _;return-_.errno}}var Ft=()=>{G(ft.varargs!=null);var r=De[+ft.varargs>>2];return ft.varargs+=4,r},Bt=Ft;function Gn(r,a,c){ft.varargs=c;try{var u=ft.getStreamFromFD(r);switch(a){case 0:{var p=Ft();if(p<0)return-28;for(;M.streams[p];)p++;var _;return _=M.dupStream(u,p),_.fd}case 1:case 2:return 0;case 3:return u.flags;case 4:{var p=Ft();return u.flags|=p,0}case 12:{var p=Bt(),w=0;return Mt[p+w>>1]=2,0}case 13:case 14:return 0}return-28}catch(A){if(typeof M>"u"||A.name!=="ErrnoError")throw A;return-A.errno}}function ha(r,a){try{return ft.writeStat(a,M.fstat(r))}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}function bf(r,a,c){ft.varargs=c;try{var u=ft.getStreamFromFD(r);switch(a){case 21509:return u.tty?0:-59;case 21505:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tcgets){var p=u.tty.ops.ioctl_tcgets(u),_=Bt();De[_>>2]=p.c_iflag||0,De[_+4>>2]=p.c_oflag||0,De[_+8>>2]=p.c_cflag||0,De[_+12>>2]=p.c_lflag||0;for(var w=0;w<32;w++)pt[_+w+17]=p.c_cc[w]||0;return 0}return 0}case 21510:case 21511:case 21512:return u.tty?0:-59;case 21506:case 21507:case 21508:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tcsets){for(var _=Bt(),A=De[_>>2],F=De[_+4>>2],X=De[_+8>>2],Q=De[_+12>>2],oe=[],w=0;w<32;w++)oe.push(pt[_+w+17]);return u.tty.ops.ioctl_tcsets(u.tty,a,{c_iflag:A,c_oflag:F,c_cflag:X,c_lflag:Q,c_cc:oe})}return 0}case 21519:{if(!u.tty)return-59;var _=Bt();return De[_>>2]=0,0}case 21520:return u.tty?-28:-59;case 21531:{var _=Bt();return M.ioctl(u,a,_)}case 21523:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tiocgwinsz){var fe=u.tty.ops.ioctl_tiocgwinsz(u.tty),_=Bt();Mt[_>>1]=fe[0],Mt[_+2>>1]=fe[1]}return 0}case 21524:return u.tty?0:-59;case 21515:return u.tty?0:-59;default:return-28}}catch(ce){if(typeof M>"u"||ce.name!=="ErrnoError")throw ce;return-ce.errno}}function wf(r,a){try{return r=ft.getStr(r),ft.writeStat(a,M.lstat(r))}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}function Ef(r,a,c,u){try{a=ft.getStr(a);var p=u&256,_=u&4096;return u=u&-6401,G(!u,`unknown flags in __syscall_newfstatat: ${u}`),a=ft.calculateAt(r,a,_),ft.writeStat(c,p?M.lstat(a):M.stat(a))}catch(w){if(typeof M>"u"||w.name!=="ErrnoError")throw w;return-w.errno}}function Tf(r,a,c,u){ft.varargs=u;try{a=ft.getStr(a),a=ft.calculateAt(r,a);var p=u?Ft():0;return M.open(a,c,p).fd}catch(_){if(typeof M>"u"||_.name!=="ErrnoError")throw _;return-_.errno}}function Af(r,a){try{return r=ft.getStr(r),ft.writeStat(a,M.stat(r))}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}var Cf=()=>pe("native code called abort()"),Zt=r=>{for(var a="";;){var c=It[r++];if(!c)return a;a+=String.fromCharCode(c)}},yr={},Ki={},ua={},ss=class extends Error{constructor(a){super(a),this.name="BindingError"}},xt=r=>{throw new ss(r)};function Rf(r,a,c={}){var u=a.name;if(r||xt(`type "${u}" must have a positive integer typeid pointer`),Ki.hasOwnProperty(r)){if(c.ignoreDuplicateRegistrations)return;xt(`Cannot register type '${u}' twice`)}if(Ki[r]=a,delete ua[r],yr.hasOwnProperty(r)){var p=yr[r];delete yr[r],p.forEach(_=>_())}}function Un(r,a,c={}){if(a.argPackAdvance===void 0)throw new TypeError("registerType registeredInstance requires argPackAdvance");return Rf(r,a,c)}var wh=(r,a,c)=>{switch(a){case 1:return c?u=>pt[u]:u=>It[u];case 2:return c?u=>Mt[u>>1]:u=>rn[u>>1];case 4:return c?u=>De[u>>2]:u=>$e[u>>2];case 8:return c?u=>W[u>>3]:u=>vn[u>>3];default:throw new TypeError(`invalid integer width (${a}): ${r}`)}},Qi=r=>{if(r===null)return"null";var a=typeof r;return a==="object"||a==="array"||a==="function"?r.toString():""+r},Eh=(r,a,c,u)=>{if(a<c||a>u)throw new TypeError(`Passing a number "${Qi(a)}" from JS side to C/C++ side to an argument of type "${r}", which is outside the valid range [${c}, ${u}]!`)},Pf=(r,a,c,u,p)=>{a=Zt(a);let _=u===0n,w=A=>A;if(_){let A=c*8;w=F=>BigInt.asUintN(A,F),p=w(p)}Un(r,{name:a,fromWireType:w,toWireType:(A,F)=>{if(typeof F=="number")F=BigInt(F);else if(typeof F!="bigint")throw new TypeError(`Cannot convert "${Qi(F)}" to ${this.name}`);return Eh(a,F,u,p),F},argPackAdvance:ti,readValueFromPointer:wh(a,c,!_),destructorFunction:null})},ti=8,If=(r,a,c,u)=>{a=Zt(a),Un(r,{name:a,fromWireType:function(p){return!!p},toWireType:function(p,_){return _?c:u},argPackAdvance:ti,readValueFromPointer:function(p){return this.fromWireType(It[p])},destructorFunction:null})},Df=r=>({count:r.count,deleteScheduled:r.deleteScheduled,preservePointerOnDelete:r.preservePointerOnDelete,ptr:r.ptr,ptrType:r.ptrType,smartPtr:r.smartPtr,smartPtrType:r.smartPtrType}),Ul=r=>{function a(c){return c.$$.ptrType.registeredClass.name}xt(a(r)+" instance already deleted")},Ol=!1,Th=r=>{},Lf=r=>{r.smartPtr?r.smartPtrType.rawDestructor(r.smartPtr):r.ptrType.registeredClass.rawDestructor(r.ptr)},Ah=r=>{r.count.value-=1;var a=r.count.value===0;a&&Lf(r)},Ch=(r,a,c)=>{if(a===c)return r;if(c.baseClass===void 0)return null;var u=Ch(r,a,c.baseClass);return u===null?null:c.downcast(u)},Rh={},Ff={},Nf=(r,a)=>{for(a===void 0&&xt("ptr should not be undefined");r.baseClass;)a=r.upcast(a),r=r.baseClass;return a},Uf=(r,a)=>(a=Nf(r,a),Ff[a]),Of=class extends Error{constructor(a){super(a),this.name="InternalError"}},da=r=>{throw new Of(r)},fa=(r,a)=>{(!a.ptrType||!a.ptr)&&da("makeClassHandle requires ptr and ptrType");var c=!!a.smartPtrType,u=!!a.smartPtr;return c!==u&&da("Both smartPtrType and smartPtr must be specified"),a.count={value:1},as(Object.create(r,{$$:{value:a,writable:!0}}))};function Ph(r){var a=this.getPointee(r);if(!a)return this.destructor(r),null;var c=Uf(this.registeredClass,a);if(c!==void 0){if(c.$$.count.value===0)return c.$$.ptr=a,c.$$.smartPtr=r,c.clone();var u=c.clone();return this.destructor(r),u}function p(){return this.isSmartPointer?fa(this.registeredClass.instancePrototype,{ptrType:this.pointeeType,ptr:a,smartPtrType:this,smartPtr:r}):fa(this.registeredClass.instancePrototype,{ptrType:this,ptr:r})}var _=this.registeredClass.getActualType(a),w=Rh[_];if(!w)return p.call(this);var A;this.isConst?A=w.constPointerType:A=w.pointerType;var F=Ch(a,this.registeredClass,A.registeredClass);return F===null?p.call(this):this.isSmartPointer?fa(A.registeredClass.instancePrototype,{ptrType:A,ptr:F,smartPtrType:this,smartPtr:r}):fa(A.registeredClass.instancePrototype,{ptrType:A,ptr:F})}var as=r=>typeof FinalizationRegistry>"u"?(as=a=>a,r):(Ol=new FinalizationRegistry(a=>{console.warn(a.leakWarning),Ah(a.$$)}),as=a=>{var c=a.$$,u=!!c.smartPtr;if(u){var p={$$:c},_=c.ptrType.registeredClass,w=new Error(`Embind found a leaked C++ instance ${_.name} <${Ot(c.ptr)}>.
We'll free it automatically in this case, but this functionality is not reliable across various environments.
Make sure to invoke .delete() manually once you're done with the instance instead.
Originally allocated`);"captureStackTrace"in Error&&Error.captureStackTrace(w,Ph),p.leakWarning=w.stack.replace(/^Error: /,""),Ol.register(a,p,a)}return a},Th=a=>Ol.unregister(a),as(r)),pa=[],Bf=()=>{for(;pa.length;){var r=pa.pop();r.$$.deleteScheduled=!1,r.delete()}},Ih,kf=()=>{let r=ma.prototype;Object.assign(r,{isAliasOf(c){if(!(this instanceof ma)||!(c instanceof ma))return!1;var u=this.$$.ptrType.registeredClass,p=this.$$.ptr;c.$$=c.$$;for(var _=c.$$.ptrType.registeredClass,w=c.$$.ptr;u.baseClass;)p=u.upcast(p),u=u.baseClass;for(;_.baseClass;)w=_.upcast(w),_=_.baseClass;return u===_&&p===w},clone(){if(this.$$.ptr||Ul(this),this.$$.preservePointerOnDelete)return this.$$.count.value+=1,this;var c=as(Object.create(Object.getPrototypeOf(this),{$$:{value:Df(this.$$)}}));return c.$$.count.value+=1,c.$$.deleteScheduled=!1,c},delete(){this.$$.ptr||Ul(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),Th(this),Ah(this.$$),this.$$.preservePointerOnDelete||(this.$$.smartPtr=void 0,this.$$.ptr=void 0)},isDeleted(){return!this.$$.ptr},deleteLater(){return this.$$.ptr||Ul(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),pa.push(this),pa.length===1&&Ih&&Ih(Bf),this.$$.deleteScheduled=!0,this}});let a=Symbol.dispose;a&&(r[a]=r.delete)};function ma(){}var ga=(r,a)=>Object.defineProperty(a,"name",{value:r}),Bl=(r,a,c)=>{if(r[a].overloadTable===void 0){var u=r[a];r[a]=function(...p){return r[a].overloadTable.hasOwnProperty(p.length)||xt(`Function '${c}' called with an invalid number of arguments (${p.length}) - expects one of (${r[a].overloadTable})!`),r[a].overloadTable[p.length].apply(this,p)},r[a].overloadTable=[],r[a].overloadTable[u.argCount]=u}},kl=(r,a,c)=>{t.hasOwnProperty(r)?((c===void 0||t[r].overloadTable!==void 0&&t[r].overloadTable[c]!==void 0)&&xt(`Cannot register public name '${r}' twice`),Bl(t,r,r),t[r].overloadTable.hasOwnProperty(c)&&xt(`Cannot register multiple overloads of a function with the same number of arguments (${c})!`),t[r].overloadTable[c]=a):(t[r]=a,t[r].argCount=c)},zf=48,Gf=57,Vf=r=>{G(typeof r=="string"),r=r.replace(/[^a-zA-Z0-9_]/g,"$");var a=r.charCodeAt(0);return a>=zf&&a<=Gf?`_${r}`:r};function Hf(r,a,c,u,p,_,w,A){this.name=r,this.constructor=a,this.instancePrototype=c,this.rawDestructor=u,this.baseClass=p,this.getActualType=_,this.upcast=w,this.downcast=A,this.pureVirtualFunctions=[]}var _a=(r,a,c)=>{for(;a!==c;)a.upcast||xt(`Expected null or instance of ${c.name}, got an instance of ${a.name}`),r=a.upcast(r),a=a.baseClass;return r};function Wf(r,a){if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;a.$$||xt(`Cannot pass "${Qi(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`);var c=a.$$.ptrType.registeredClass,u=_a(a.$$.ptr,c,this.registeredClass);return u}function Xf(r,a){var c;if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),this.isSmartPointer?(c=this.rawConstructor(),r!==null&&r.push(this.rawDestructor,c),c):0;(!a||!a.$$)&&xt(`Cannot pass "${Qi(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),!this.isConst&&a.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${a.$$.smartPtrType?a.$$.smartPtrType.name:a.$$.ptrType.name} to parameter type ${this.name}`);var u=a.$$.ptrType.registeredClass;if(c=_a(a.$$.ptr,u,this.registeredClass),this.isSmartPointer)switch(a.$$.smartPtr===void 0&&xt("Passing raw pointer to smart pointer is illegal"),this.sharingPolicy){case 0:a.$$.smartPtrType===this?c=a.$$.smartPtr:xt(`Cannot convert argument of type ${a.$$.smartPtrType?a.$$.smartPtrType.name:a.$$.ptrType.name} to parameter type ${this.name}`);break;case 1:c=a.$$.smartPtr;break;case 2:if(a.$$.smartPtrType===this)c=a.$$.smartPtr;else{var p=a.clone();c=this.rawShare(c,Jt.toHandle(()=>p.delete())),r!==null&&r.push(this.rawDestructor,c)}break;default:xt("Unsupporting sharing policy")}return c}function $f(r,a){if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;a.$$||xt(`Cannot pass "${Qi(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),a.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${a.$$.ptrType.name} to parameter type ${this.name}`);var c=a.$$.ptrType.registeredClass,u=_a(a.$$.ptr,c,this.registeredClass);return u}function va(r){return this.fromWireType($e[r>>2])}var qf=()=>{Object.assign(ya.prototype,{getPointee(r){return this.rawGetPointee&&(r=this.rawGetPointee(r)),r},destructor(r){this.rawDestructor?.(r)},argPackAdvance:ti,readValueFromPointer:va,fromWireType:Ph})};function ya(r,a,c,u,p,_,w,A,F,X,Q){this.name=r,this.registeredClass=a,this.isReference=c,this.isConst=u,this.isSmartPointer=p,this.pointeeType=_,this.sharingPolicy=w,this.rawGetPointee=A,this.rawConstructor=F,this.rawShare=X,this.rawDestructor=Q,!p&&a.baseClass===void 0?u?(this.toWireType=Wf,this.destructorFunction=null):(this.toWireType=$f,this.destructorFunction=null):this.toWireType=Xf}var Dh=(r,a,c)=>{t.hasOwnProperty(r)||da("Replacing nonexistent public symbol"),t[r].overloadTable!==void 0&&c!==void 0?t[r].overloadTable[c]=a:(t[r]=a,t[r].argCount=c)},Lh=[],xa,be=r=>{var a=Lh[r];return a||(Lh[r]=a=xa.get(r)),G(xa.get(r)==a,"JavaScript-side Wasm function table mirror is out of date!"),a},ni=(r,a,c=!1)=>{G(!c,"Async bindings are only supported with JSPI."),r=Zt(r);function u(){var _=be(a);return _}var p=u();return typeof p!="function"&&xt(`unknown function pointer with signature ${r}: ${a}`),p};class Yf extends Error{}var Fh=r=>{var a=Kh(r),c=Zt(a);return Hn(a),c},er=(r,a)=>{var c=[],u={};function p(_){if(!u[_]&&!Ki[_]){if(ua[_]){ua[_].forEach(p);return}c.push(_),u[_]=!0}}throw a.forEach(p),new Yf(`${r}: `+c.map(Fh).join([", "]))},Vn=(r,a,c)=>{r.forEach(A=>ua[A]=a);function u(A){var F=c(A);F.length!==r.length&&da("Mismatched type converter count");for(var X=0;X<r.length;++X)Un(r[X],F[X])}var p=new Array(a.length),_=[],w=0;a.forEach((A,F)=>{Ki.hasOwnProperty(A)?p[F]=Ki[A]:(_.push(A),yr.hasOwnProperty(A)||(yr[A]=[]),yr[A].push(()=>{p[F]=Ki[A],++w,w===_.length&&u(p)}))}),_.length===0&&u(p)},jf=(r,a,c,u,p,_,w,A,F,X,Q,oe,fe)=>{Q=Zt(Q),_=ni(p,_),A&&=ni(w,A),X&&=ni(F,X),fe=ni(oe,fe);var ce=Vf(Q);kl(ce,function(){er(`Cannot construct ${Q} due to unbound types`,[u])}),Vn([r,a,c],u?[u]:[],me=>{me=me[0];var Ye,vt;u?(Ye=me.registeredClass,vt=Ye.instancePrototype):vt=ma.prototype;var st=ga(Q,function(...Nt){if(Object.getPrototypeOf(this)!==bt)throw new ss(`Use 'new' to construct ${Q}`);if(tt.constructor_body===void 0)throw new ss(`${Q} has no accessible constructor`);var ir=tt.constructor_body[Nt.length];if(ir===void 0)throw new ss(`Tried to invoke ctor of ${Q} with invalid number of parameters (${Nt.length}) - expected (${Object.keys(tt.constructor_body).toString()}) parameters instead!`);return ir.apply(this,Nt)}),bt=Object.create(vt,{constructor:{value:st}});st.prototype=bt;var tt=new Hf(Q,st,bt,fe,Ye,_,A,X);tt.baseClass&&(tt.baseClass.__derivedClasses??=[],tt.baseClass.__derivedClasses.push(tt));var qt=new ya(Q,tt,!0,!1,!1),Kt=new ya(Q+"*",tt,!1,!1,!1),yn=new ya(Q+" const*",tt,!1,!0,!1);return Rh[r]={pointerType:Kt,constPointerType:yn},Dh(ce,st),[qt,Kt,yn]})},Sa=r=>{for(;r.length;){var a=r.pop(),c=r.pop();c(a)}};function Nh(r){for(var a=1;a<r.length;++a)if(r[a]!==null&&r[a].destructorFunction===void 0)return!0;return!1}function Uh(r,a,c,u,p){if(r<a||r>c){var _=a==c?a:`${a} to ${c}`;p(`function ${u} called with ${r} arguments, expected ${_}`)}}function lw(r,a,c,u){var p=Nh(r),_=r.length-2,w=[],A=["fn"];a&&A.push("thisWired");for(var F=0;F<_;++F)w.push(`arg${F}`),A.push(`arg${F}Wired`);w=w.join(","),A=A.join(",");var X=`return function (${w}) {
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
${X}`,[oe,X]}function Zf(r){for(var a=r.length-2,c=r.length-1;c>=2&&r[c].optional;--c)a--;return a}function Ma(r,a,c,u,p,_){var w=a.length;w<2&&xt("argTypes array size mismatch! Must at least get return value and 'this' types!"),G(!_,"Async bindings are only supported with JSPI.");for(var A=a[1]!==null&&c!==null,F=Nh(a),X=a[0].name!=="void",Q=w-2,oe=Zf(a),fe=[r,xt,u,p,Sa,a[0],a[1]],ce=0;ce<w-2;++ce)fe.push(a[ce+2]);if(!F)for(var ce=A?1:2;ce<a.length;++ce)a[ce].destructorFunction!==null&&fe.push(a[ce].destructorFunction);fe.push(Uh,oe,Q);var me=A?1:2,Ye=function(...vt){Uh(vt.length,oe,Q,r,xt);for(var st=F?[]:null,bt=A?[a[1].toWireType(st,this)]:[],tt=0;tt<Q;++tt)bt.push(a[tt+2].toWireType(st,vt[tt]));var qt=u(p,...bt);if(F)Sa(st);else for(var tt=me;tt<a.length;++tt)a[tt].destructorFunction?.(bt[tt-me]);if(X)return a[0].fromWireType(qt)};return ga(r,Ye)}var ba=(r,a)=>{for(var c=[],u=0;u<r;u++)c.push($e[a+u*4>>2]);return c},zl=r=>{r=r.trim();let a=r.indexOf("(");return a===-1?r:(G(r.endsWith(")"),"Parentheses for argument names should match."),r.slice(0,a))},Jf=(r,a,c,u,p,_,w,A,F)=>{var X=ba(c,u);a=Zt(a),a=zl(a),_=ni(p,_,A),Vn([],[r],Q=>{Q=Q[0];var oe=`${Q.name}.${a}`;function fe(){er(`Cannot call ${oe} due to unbound types`,X)}a.startsWith("@@")&&(a=Symbol[a.substring(2)]);var ce=Q.registeredClass.constructor;return ce[a]===void 0?(fe.argCount=c-1,ce[a]=fe):(Bl(ce,a,oe),ce[a].overloadTable[c-1]=fe),Vn([],X,me=>{var Ye=[me[0],null].concat(me.slice(1)),vt=Ma(oe,Ye,null,_,w,A);if(ce[a].overloadTable===void 0?(vt.argCount=c-1,ce[a]=vt):ce[a].overloadTable[c-1]=vt,Q.registeredClass.__derivedClasses)for(let st of Q.registeredClass.__derivedClasses)st.constructor.hasOwnProperty(a)||(st.constructor[a]=vt);return[]}),[]})},Kf=(r,a,c,u,p,_)=>{G(a>0);var w=ba(a,c);p=ni(u,p);var A=[_],F=[];Vn([],[r],X=>{X=X[0];var Q=`constructor ${X.name}`;if(X.registeredClass.constructor_body===void 0&&(X.registeredClass.constructor_body=[]),X.registeredClass.constructor_body[a-1]!==void 0)throw new ss(`Cannot register multiple constructors with identical number of parameters (${a-1}) for class '${X.name}'! Overload resolution is currently only performed using the parameter count, not actual type info!`);return X.registeredClass.constructor_body[a-1]=()=>{er(`Cannot construct ${X.name} due to unbound types`,w)},Vn([],w,oe=>(oe.splice(1,0,null),X.registeredClass.constructor_body[a-1]=Ma(Q,oe,null,p,_),[])),[]})},Qf=(r,a,c,u,p,_,w,A,F,X)=>{var Q=ba(c,u);a=Zt(a),a=zl(a),_=ni(p,_,F),Vn([],[r],oe=>{oe=oe[0];var fe=`${oe.name}.${a}`;a.startsWith("@@")&&(a=Symbol[a.substring(2)]),A&&oe.registeredClass.pureVirtualFunctions.push(a);function ce(){er(`Cannot call ${fe} due to unbound types`,Q)}var me=oe.registeredClass.instancePrototype,Ye=me[a];return Ye===void 0||Ye.overloadTable===void 0&&Ye.className!==oe.name&&Ye.argCount===c-2?(ce.argCount=c-2,ce.className=oe.name,me[a]=ce):(Bl(me,a,fe),me[a].overloadTable[c-2]=ce),Vn([],Q,vt=>{var st=Ma(fe,vt,oe,_,w,F);return me[a].overloadTable===void 0?(st.argCount=c-2,me[a]=st):me[a].overloadTable[c-2]=st,[]}),[]})},Oh=(r,a,c)=>(r instanceof Object||xt(`${c} with invalid "this": ${r}`),r instanceof a.registeredClass.constructor||xt(`${c} incompatible with "this" of type ${r.constructor.name}`),r.$$.ptr||xt(`cannot call emscripten binding method ${c} on deleted object`),_a(r.$$.ptr,r.$$.ptrType.registeredClass,a.registeredClass)),ep=(r,a,c,u,p,_,w,A,F,X)=>{a=Zt(a),p=ni(u,p),Vn([],[r],Q=>{Q=Q[0];var oe=`${Q.name}.${a}`,fe={get(){er(`Cannot access ${oe} due to unbound types`,[c,w])},enumerable:!0,configurable:!0};return F?fe.set=()=>er(`Cannot access ${oe} due to unbound types`,[c,w]):fe.set=ce=>xt(oe+" is a read-only property"),Object.defineProperty(Q.registeredClass.instancePrototype,a,fe),Vn([],F?[c,w]:[c],ce=>{var me=ce[0],Ye={get(){var st=Oh(this,Q,oe+" getter");return me.fromWireType(p(_,st))},enumerable:!0};if(F){F=ni(A,F);var vt=ce[1];Ye.set=function(st){var bt=Oh(this,Q,oe+" setter"),tt=[];F(X,bt,vt.toWireType(tt,st)),Sa(tt)}}return Object.defineProperty(Q.registeredClass.instancePrototype,a,Ye),[]}),[]})},tp=(r,a,c)=>{r=Zt(r),Vn([],[a],u=>(u=u[0],t[r]=u.fromWireType(c),[]))},Bh=[],ii=[0,1,,1,null,1,!0,1,!1,1],Gl=r=>{r>9&&--ii[r+1]===0&&(G(ii[r]!==void 0,"Decref for unallocated handle."),ii[r]=void 0,Bh.push(r))},Jt={toValue:r=>(r||xt(`Cannot use deleted val. handle = ${r}`),G(r===2||ii[r]!==void 0&&r%2===0,`invalid handle: ${r}`),ii[r]),toHandle:r=>{switch(r){case void 0:return 2;case null:return 4;case!0:return 6;case!1:return 8;default:{let a=Bh.pop()||ii.length;return ii[a]=r,ii[a+1]=1,a}}}},kh={name:"emscripten::val",fromWireType:r=>{var a=Jt.toValue(r);return Gl(r),a},toWireType:(r,a)=>Jt.toHandle(a),argPackAdvance:ti,readValueFromPointer:va,destructorFunction:null},zh=r=>Un(r,kh),np=(r,a,c)=>{switch(a){case 1:return c?function(u){return this.fromWireType(pt[u])}:function(u){return this.fromWireType(It[u])};case 2:return c?function(u){return this.fromWireType(Mt[u>>1])}:function(u){return this.fromWireType(rn[u>>1])};case 4:return c?function(u){return this.fromWireType(De[u>>2])}:function(u){return this.fromWireType($e[u>>2])};default:throw new TypeError(`invalid integer width (${a}): ${r}`)}},ip=(r,a,c,u)=>{a=Zt(a);function p(){}p.values={},Un(r,{name:a,constructor:p,fromWireType:function(_){return this.constructor.values[_]},toWireType:(_,w)=>w.value,argPackAdvance:ti,readValueFromPointer:np(a,c,u),destructorFunction:null}),kl(a,p)},wa=(r,a)=>{var c=Ki[r];return c===void 0&&xt(`${a} has unknown type ${Fh(r)}`),c},rp=(r,a,c)=>{var u=wa(r,"enum");a=Zt(a);var p=u.constructor,_=Object.create(u.constructor.prototype,{value:{value:c},constructor:{value:ga(`${u.name}_${a}`,function(){})}});p.values[c]=_,p[a]=_},sp=(r,a)=>{switch(a){case 4:return function(c){return this.fromWireType(hn[c>>2])};case 8:return function(c){return this.fromWireType(sn[c>>3])};default:throw new TypeError(`invalid float width (${a}): ${r}`)}},ap=(r,a,c)=>{a=Zt(a),Un(r,{name:a,fromWireType:u=>u,toWireType:(u,p)=>{if(typeof p!="number"&&typeof p!="boolean")throw new TypeError(`Cannot convert ${Qi(p)} to ${this.name}`);return p},argPackAdvance:ti,readValueFromPointer:sp(a,c),destructorFunction:null})},op=(r,a,c,u,p,_,w,A)=>{var F=ba(a,c);r=Zt(r),r=zl(r),p=ni(u,p,w),kl(r,function(){er(`Cannot call ${r} due to unbound types`,F)},a-1),Vn([],F,X=>{var Q=[X[0],null].concat(X.slice(1));return Dh(r,Ma(r,Q,null,p,_,w),a-1),[]})},lp=(r,a,c,u,p)=>{a=Zt(a);let _=u===0,w=F=>F;if(_){var A=32-8*c;w=F=>F<<A>>>A,p=w(p)}Un(r,{name:a,fromWireType:w,toWireType:(F,X)=>{if(typeof X!="number"&&typeof X!="boolean")throw new TypeError(`Cannot convert "${Qi(X)}" to ${a}`);return Eh(a,X,u,p),X},argPackAdvance:ti,readValueFromPointer:wh(a,c,u!==0),destructorFunction:null})},cp=(r,a,c)=>{var u=[Int8Array,Uint8Array,Int16Array,Uint16Array,Int32Array,Uint32Array,Float32Array,Float64Array,BigInt64Array,BigUint64Array],p=u[a];function _(w){var A=$e[w>>2],F=$e[w+4>>2];return new p(pt.buffer,F,A)}c=Zt(c),Un(r,{name:c,fromWireType:_,argPackAdvance:ti,readValueFromPointer:_},{ignoreDuplicateRegistrations:!0})},hp=Object.assign({optional:!0},kh),up=(r,a)=>{Un(r,hp)},tr=(r,a,c)=>(G(typeof c=="number","stringToUTF8(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),rt(r,It,a,c)),dp=(r,a)=>{a=Zt(a);var c=!0;Un(r,{name:a,fromWireType(u){var p=$e[u>>2],_=u+4,w;if(c)for(var A=_,F=0;F<=p;++F){var X=_+F;if(F==p||It[X]==0){var Q=X-A,oe=un(A,Q);w===void 0?w=oe:(w+="\0",w+=oe),A=X+1}}else{for(var fe=new Array(p),F=0;F<p;++F)fe[F]=String.fromCharCode(It[_+F]);w=fe.join("")}return Hn(u),w},toWireType(u,p){p instanceof ArrayBuffer&&(p=new Uint8Array(p));var _,w=typeof p=="string";w||ArrayBuffer.isView(p)&&p.BYTES_PER_ELEMENT==1||xt("Cannot pass non-string to std::string"),c&&w?_=Ge(p):_=p.length;var A=$l(4+_+1),F=A+4;if($e[A>>2]=_,w)if(c)tr(p,F,_+1);else for(var X=0;X<_;++X){var Q=p.charCodeAt(X);Q>255&&(Hn(A),xt("String has UTF-16 code units that do not fit in 8 bits")),It[F+X]=Q}else It.set(p,F);return u!==null&&u.push(Hn,A),A},argPackAdvance:ti,readValueFromPointer:va,destructorFunction(u){Hn(u)}})},Gh=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0,fp=(r,a)=>{G(r%2==0,"Pointer passed to UTF16ToString must be aligned to two bytes!");for(var c=r>>1,u=c+a/2,p=c;!(p>=u)&&rn[p];)++p;if(p-c>16&&Gh)return Gh.decode(rn.subarray(c,p));for(var _="",w=c;!(w>=u);++w){var A=rn[w];if(A==0)break;_+=String.fromCharCode(A)}return _},pp=(r,a,c)=>{if(G(a%2==0,"Pointer passed to stringToUTF16 must be aligned to two bytes!"),G(typeof c=="number","stringToUTF16(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),c??=2147483647,c<2)return 0;c-=2;for(var u=a,p=c<r.length*2?c/2:r.length,_=0;_<p;++_){var w=r.charCodeAt(_);Mt[a>>1]=w,a+=2}return Mt[a>>1]=0,a-u},mp=r=>r.length*2,gp=(r,a)=>{G(r%4==0,"Pointer passed to UTF32ToString must be aligned to four bytes!");for(var c="",u=0;!(u>=a/4);u++){var p=De[r+u*4>>2];if(!p)break;c+=String.fromCodePoint(p)}return c},_p=(r,a,c)=>{if(G(a%4==0,"Pointer passed to stringToUTF32 must be aligned to four bytes!"),G(typeof c=="number","stringToUTF32(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),c??=2147483647,c<4)return 0;for(var u=a,p=u+c-4,_=0;_<r.length;++_){var w=r.codePointAt(_);if(w>65535&&_++,De[a>>2]=w,a+=4,a+4>p)break}return De[a>>2]=0,a-u},vp=r=>{for(var a=0,c=0;c<r.length;++c){var u=r.codePointAt(c);u>65535&&c++,a+=4}return a},yp=(r,a,c)=>{c=Zt(c);var u,p,_,w;a===2?(u=fp,p=pp,w=mp,_=A=>rn[A>>1]):a===4&&(u=gp,p=_p,w=vp,_=A=>$e[A>>2]),Un(r,{name:c,fromWireType:A=>{for(var F=$e[A>>2],X,Q=A+4,oe=0;oe<=F;++oe){var fe=A+4+oe*a;if(oe==F||_(fe)==0){var ce=fe-Q,me=u(Q,ce);X===void 0?X=me:(X+="\0",X+=me),Q=fe+a}}return Hn(A),X},toWireType:(A,F)=>{typeof F!="string"&&xt(`Cannot pass non-string to C++ string type ${c}`);var X=w(F),Q=$l(4+X+a);return $e[Q>>2]=X/a,p(F,Q+4,X+a),A!==null&&A.push(Hn,Q),Q},argPackAdvance:ti,readValueFromPointer:va,destructorFunction(A){Hn(A)}})},xp=(r,a)=>{zh(r)},Sp=(r,a)=>{a=Zt(a),Un(r,{isVoid:!0,name:a,argPackAdvance:0,fromWireType:()=>{},toWireType:(c,u)=>{}})},Mp=()=>{throw new ge},Vl=(r,a,c)=>{var u=[],p=r.toWireType(u,c);return u.length&&($e[a>>2]=Jt.toHandle(u)),p},bp=(r,a,c)=>(r=Jt.toValue(r),a=wa(a,"emval::as"),Vl(a,c,r)),Ea=[],wp=(r,a,c,u)=>(r=Ea[r],a=Jt.toValue(a),r(null,a,c,u)),Ep={},Hl=r=>{var a=Ep[r];return a===void 0?Zt(r):a},Tp=(r,a,c,u,p)=>(r=Ea[r],a=Jt.toValue(a),c=Hl(c),r(a,a[c],u,p)),Vh=()=>globalThis,Ap=r=>r===0?Jt.toHandle(Vh()):(r=Hl(r),Jt.toHandle(Vh()[r])),Cp=r=>{var a=Ea.length;return Ea.push(r),a},Rp=(r,a)=>{for(var c=new Array(r),u=0;u<r;++u)c[u]=wa($e[a+u*4>>2],`parameter ${u}`);return c},Pp=(r,a,c)=>{var u=Rp(r,a),p=u.shift();r--;var _=`return function (obj, func, destructorsRef, args) {
`,w=0,A=[];c===0&&A.push("obj");for(var F=["retType"],X=[p],Q=0;Q<r;++Q)A.push(`arg${Q}`),F.push(`argType${Q}`),X.push(u[Q]),_+=`  var arg${Q} = argType${Q}.readValueFromPointer(args${w?"+"+w:""});
`,w+=u[Q].argPackAdvance;var oe=c===1?"new func":"func.call";_+=`  var rv = ${oe}(${A.join(", ")});
`,p.isVoid||(F.push("emval_returnValue"),X.push(Vl),_+=`  return emval_returnValue(retType, destructorsRef, rv);
`),_+=`};
`;var fe=(me,Ye,vt,st)=>{for(var bt=c===0?[me]:[],tt=0;tt<r;++tt)bt.push(u[tt].readValueFromPointer(st)),st+=u[tt].argPackAdvance;var qt=c===1?new Ye(...bt):Ye.call(...bt);if(!p.isVoid)return Vl(p,vt,qt)},ce=`methodCaller<(${u.map(me=>me.name).join(", ")}) => ${p.name}>`;return Cp(ga(ce,fe))},Ip=(r,a)=>(r=Jt.toValue(r),a=Jt.toValue(a),Jt.toHandle(r[a])),Dp=r=>{r>9&&(ii[r+1]+=1)},Lp=r=>(r=Jt.toValue(r),typeof r=="number"),Fp=r=>(r=Jt.toValue(r),typeof r=="string"),Np=()=>Jt.toHandle([]),Up=r=>Jt.toHandle(Hl(r)),Op=r=>{var a=Jt.toValue(r);Sa(a),Gl(r)},Bp=(r,a)=>{r=wa(r,"_emval_take_value");var c=r.readValueFromPointer(a);return Jt.toHandle(c)},kp=r=>{throw r=Jt.toValue(r),r},zp=r=>r%4===0&&(r%100!==0||r%400===0),Gp=[0,31,60,91,121,152,182,213,244,274,305,335],Vp=[0,31,59,90,120,151,181,212,243,273,304,334],Hh=r=>{var a=zp(r.getFullYear()),c=a?Gp:Vp,u=c[r.getMonth()]+r.getDate()-1;return u},Hp=9007199254740992,Wp=-9007199254740992,Wl=r=>r<Wp||r>Hp?NaN:Number(r);function Xp(r,a){r=Wl(r);var c=new Date(r*1e3);De[a>>2]=c.getSeconds(),De[a+4>>2]=c.getMinutes(),De[a+8>>2]=c.getHours(),De[a+12>>2]=c.getDate(),De[a+16>>2]=c.getMonth(),De[a+20>>2]=c.getFullYear()-1900,De[a+24>>2]=c.getDay();var u=Hh(c)|0;De[a+28>>2]=u,De[a+36>>2]=-(c.getTimezoneOffset()*60);var p=new Date(c.getFullYear(),0,1),_=new Date(c.getFullYear(),6,1).getTimezoneOffset(),w=p.getTimezoneOffset(),A=(_!=w&&c.getTimezoneOffset()==Math.min(w,_))|0;De[a+32>>2]=A}var $p=function(r){var a=(()=>{var c=new Date(De[r+20>>2]+1900,De[r+16>>2],De[r+12>>2],De[r+8>>2],De[r+4>>2],De[r>>2],0),u=De[r+32>>2],p=c.getTimezoneOffset(),_=new Date(c.getFullYear(),0,1),w=new Date(c.getFullYear(),6,1).getTimezoneOffset(),A=_.getTimezoneOffset(),F=Math.min(A,w);if(u<0)De[r+32>>2]=+(w!=A&&F==p);else if(u>0!=(F==p)){var X=Math.max(A,w),Q=u>0?F:X;c.setTime(c.getTime()+(Q-p)*6e4)}De[r+24>>2]=c.getDay();var oe=Hh(c)|0;De[r+28>>2]=oe,De[r>>2]=c.getSeconds(),De[r+4>>2]=c.getMinutes(),De[r+8>>2]=c.getHours(),De[r+12>>2]=c.getDate(),De[r+16>>2]=c.getMonth(),De[r+20>>2]=c.getYear();var fe=c.getTime();return isNaN(fe)?-1:fe/1e3})();return BigInt(a)},qp=(r,a,c,u)=>{var p=new Date().getFullYear(),_=new Date(p,0,1),w=new Date(p,6,1),A=_.getTimezoneOffset(),F=w.getTimezoneOffset(),X=Math.max(A,F);$e[r>>2]=X*60,De[a>>2]=+(A!=F);var Q=ce=>{var me=ce>=0?"-":"+",Ye=Math.abs(ce),vt=String(Math.floor(Ye/60)).padStart(2,"0"),st=String(Ye%60).padStart(2,"0");return`UTC${me}${vt}${st}`},oe=Q(A),fe=Q(F);G(oe),G(fe),G(Ge(oe)<=16,`timezone name truncated to fit in TZNAME_MAX (${oe})`),G(Ge(fe)<=16,`timezone name truncated to fit in TZNAME_MAX (${fe})`),F<A?(tr(oe,c,17),tr(fe,u,17)):(tr(oe,u,17),tr(fe,c,17))},Wh=()=>performance.now(),Xh=()=>Date.now(),Yp=1,jp=r=>r>=0&&r<=3;function Zp(r,a,c){if(a=Wl(a),!jp(r))return 28;var u;if(r===0)u=Xh();else if(Yp)u=Wh();else return 52;var p=Math.round(u*1e3*1e3);return W[c>>3]=BigInt(p),0}var Ta=[],Jp=(r,a)=>{G(Array.isArray(Ta)),G(a%16==0),Ta.length=0;for(var c;c=It[r++];){var u=String.fromCharCode(c),p=["d","f","i","p"];p.push("j"),G(p.includes(u),`Invalid character ${c}("${u}") in readEmAsmArgs! Use only [${p}], and do not specify "v" for void return argument.`);var _=c!=105;_&=c!=112,a+=_&&a%8?4:0,Ta.push(c==112?$e[a>>2]:c==106?W[a>>3]:c==105?De[a>>2]:sn[a>>3]),a+=_?8:4}return Ta},Kp=(r,a,c)=>{var u=Jp(a,c);return G(Jh.hasOwnProperty(r),`No EM_ASM constant found at address ${r}.  The loaded WebAssembly file is likely out of sync with the generated JavaScript.`),Jh[r](...u)},Qp=(r,a,c)=>Kp(r,a,c),$h=()=>2147483648,em=()=>$h(),tm=(r,a)=>(G(a,"alignment argument is required"),Math.ceil(r/a)*a),nm=r=>{var a=Ht.buffer,c=(r-a.byteLength+65535)/65536|0;try{return Ht.grow(c),Ut(),1}catch(u){I(`growMemory: Attempted to grow heap from ${a.byteLength} bytes to ${r} bytes, but got error: ${u}`)}},im=r=>{var a=It.length;r>>>=0,G(r>a);var c=$h();if(r>c)return I(`Cannot enlarge memory, requested ${r} bytes, but the limit is ${c} bytes!`),!1;for(var u=1;u<=4;u*=2){var p=a*(1+.2/u);p=Math.min(p,r+100663296);var _=Math.min(c,tm(Math.max(r,p),65536)),w=nm(_);if(w)return!0}return I(`Failed to grow the heap from ${a} bytes to ${_} bytes, not enough memory!`),!1},Xl={},rm=()=>d||"./this.program",os=()=>{if(!os.strings){var r=(typeof navigator=="object"&&navigator.language||"C").replace("-","_")+".UTF-8",a={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:r,_:rm()};for(var c in Xl)Xl[c]===void 0?delete a[c]:a[c]=Xl[c];var u=[];for(var c in a)u.push(`${c}=${a[c]}`);os.strings=u}return os.strings},sm=(r,a)=>{var c=0,u=0;for(var p of os()){var _=a+c;$e[r+u>>2]=_,c+=tr(p,_,1/0)+1,u+=4}return 0},am=(r,a)=>{var c=os();$e[r>>2]=c.length;var u=0;for(var p of c)u+=Ge(p)+1;return $e[a>>2]=u,0},qh=0,Yh=()=>Tt||qh>0,om=r=>{ie=r,Yh()||(t.onExit?.(r),z=!0),m(r,new Ae(r))},lm=(r,a)=>{if(ie=r,M_(),Yh()&&!a){var c=`program exited (with status: ${r}), but keepRuntimeAlive() is set (counter=${qh}) due to an async operation, so halting execution but not exiting the runtime or preventing further async execution (you can use emscripten_force_exit, if you want to force a true shutdown)`;mt?.(c),I(c)}om(r)},cm=lm;function hm(r){try{var a=ft.getStreamFromFD(r);return M.close(a),0}catch(c){if(typeof M>"u"||c.name!=="ErrnoError")throw c;return c.errno}}var um=(r,a,c,u)=>{for(var p=0,_=0;_<c;_++){var w=$e[a>>2],A=$e[a+4>>2];a+=8;var F=M.read(r,pt,w,A,u);if(F<0)return-1;if(p+=F,F<A)break;typeof u<"u"&&(u+=F)}return p};function dm(r,a,c,u){try{var p=ft.getStreamFromFD(r),_=um(p,a,c);return $e[u>>2]=_,0}catch(w){if(typeof M>"u"||w.name!=="ErrnoError")throw w;return w.errno}}function fm(r,a,c,u){a=Wl(a);try{if(isNaN(a))return 61;var p=ft.getStreamFromFD(r);return M.llseek(p,a,c),W[u>>3]=BigInt(p.position),p.getdents&&a===0&&c===0&&(p.getdents=null),0}catch(_){if(typeof M>"u"||_.name!=="ErrnoError")throw _;return _.errno}}var pm=(r,a,c,u)=>{for(var p=0,_=0;_<c;_++){var w=$e[a>>2],A=$e[a+4>>2];a+=8;var F=M.write(r,pt,w,A,u);if(F<0)return-1;if(p+=F,F<A)break;typeof u<"u"&&(u+=F)}return p};function mm(r,a,c,u){try{var p=ft.getStreamFromFD(r),_=pm(p,a,c);return $e[u>>2]=_,0}catch(w){if(typeof M>"u"||w.name!=="ErrnoError")throw w;return w.errno}}var gm=r=>r,_m=r=>{var a=t["_"+r];return G(a,"Cannot call unknown function "+r+", make sure it is exported"),a},vm=(r,a)=>{G(r.length>=0,"writeArrayToMemory array must have a length (should be an array or typed array)"),pt.set(r,a)},Aa=r=>iu(r),ym=r=>{var a=Ge(r)+1,c=Aa(a);return tr(r,c,a),c},jh=(r,a,c,u,p)=>{var _={string:me=>{var Ye=0;return me!=null&&me!==0&&(Ye=ym(me)),Ye},array:me=>{var Ye=Aa(me.length);return vm(me,Ye),Ye}};function w(me){return a==="string"?un(me):a==="boolean"?!!me:me}var A=_m(r),F=[],X=0;if(G(a!=="array",'Return type should not be "array".'),u)for(var Q=0;Q<u.length;Q++){var oe=_[c[Q]];oe?(X===0&&(X=_e()),F[Q]=oe(u[Q])):F[Q]=u[Q]}var fe=A(...F);function ce(me){return X!==0&&ye(X),w(me)}return fe=ce(fe),fe},xm=(r,a,c,u)=>(...p)=>jh(r,a,c,p,u),Sm=(...r)=>M.createPath(...r),Mm=(...r)=>M.unlink(...r),bm=(...r)=>M.createLazyFile(...r),wm=(...r)=>M.createDevice(...r),Em=r=>Ca(r),Tm=r=>jl(r),Am=r=>{var a=_e(),c=Aa(4),u=Aa(4);su(r,c,u);var p=$e[c>>2],_=$e[u>>2],w=un(p);Hn(p);var A;return _&&(A=un(_),Hn(_)),ye(a),[w,A]},Zh=r=>Am(r);M.createPreloadedFile=Kn,M.staticInit(),kf(),qf(),G(ii.length===10),t.noExitRuntime&&(Tt=t.noExitRuntime),t.preloadPlugins&&(an=t.preloadPlugins),t.print&&(U=t.print),t.printErr&&(I=t.printErr),t.wasmBinary&&(ee=t.wasmBinary),Pm(),t.arguments&&(f=t.arguments),t.thisProgram&&(d=t.thisProgram),G(typeof t.memoryInitializerPrefixURL>"u","Module.memoryInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.pthreadMainPrefixURL>"u","Module.pthreadMainPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.cdInitializerPrefixURL>"u","Module.cdInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.filePackagePrefixURL>"u","Module.filePackagePrefixURL option was removed, use Module.locateFile instead"),G(typeof t.read>"u","Module.read option was removed"),G(typeof t.readAsync>"u","Module.readAsync option was removed (modify readAsync in JS)"),G(typeof t.readBinary>"u","Module.readBinary option was removed (modify readBinary in JS)"),G(typeof t.setWindowTitle>"u","Module.setWindowTitle option was removed (modify emscripten_set_window_title in JS)"),G(typeof t.TOTAL_MEMORY>"u","Module.TOTAL_MEMORY has been renamed Module.INITIAL_MEMORY"),G(typeof t.ENVIRONMENT>"u","Module.ENVIRONMENT has been deprecated. To force the environment, use the ENVIRONMENT compile-time option (for example, -sENVIRONMENT=web or -sENVIRONMENT=node)"),G(typeof t.STACK_SIZE>"u","STACK_SIZE can no longer be set at runtime.  Use -sSTACK_SIZE at link time"),G(typeof t.wasmMemory>"u","Use of `wasmMemory` detected.  Use -sIMPORTED_MEMORY to define wasmMemory externally"),G(typeof t.INITIAL_MEMORY>"u","Detected runtime INITIAL_MEMORY setting.  Use -sIMPORTED_MEMORY to define wasmMemory dynamically"),t.addRunDependency=ve,t.removeRunDependency=de,t.ccall=jh,t.cwrap=xm,t.FS_createPreloadedFile=Kn,t.FS_unlink=Mm,t.FS_createPath=Sm,t.FS_createDevice=wm,t.FS=M,t.FS_createDataFile=jt,t.FS_createLazyFile=bm,t.MEMFS=ke;var Cm=["writeI53ToI64","writeI53ToI64Clamped","writeI53ToI64Signaling","writeI53ToU64Clamped","writeI53ToU64Signaling","readI53FromI64","readI53FromU64","convertI32PairToI53","convertI32PairToI53Checked","convertU32PairToI53","getTempRet0","zeroMemory","withStackSave","inetPton4","inetNtop4","inetPton6","inetNtop6","readSockaddr","writeSockaddr","emscriptenLog","runMainThreadEmAsm","jstoi_q","autoResumeAudioContext","getDynCaller","dynCall","handleException","runtimeKeepalivePush","runtimeKeepalivePop","callUserCallback","maybeExit","asmjsMangle","HandleAllocator","getNativeTypeSize","addOnInit","addOnPostCtor","addOnPreMain","addOnExit","STACK_SIZE","STACK_ALIGN","POINTER_SIZE","ASSERTIONS","uleb128Encode","sigToWasmTypes","generateFuncType","convertJsFunctionToWasm","getEmptyTableSlot","updateTableMap","getFunctionAddress","addFunction","removeFunction","reallyNegative","unSign","strLen","reSign","formatString","intArrayToString","stringToAscii","stringToNewUTF8","registerKeyEventCallback","maybeCStringToJsString","findEventTarget","getBoundingClientRect","fillMouseEventData","registerMouseEventCallback","registerWheelEventCallback","registerUiEventCallback","registerFocusEventCallback","fillDeviceOrientationEventData","registerDeviceOrientationEventCallback","fillDeviceMotionEventData","registerDeviceMotionEventCallback","screenOrientation","fillOrientationChangeEventData","registerOrientationChangeEventCallback","fillFullscreenChangeEventData","registerFullscreenChangeEventCallback","JSEvents_requestFullscreen","JSEvents_resizeCanvasForFullscreen","registerRestoreOldStyle","hideEverythingExceptGivenElement","restoreHiddenElements","setLetterbox","softFullscreenResizeWebGLRenderTarget","doRequestFullscreen","fillPointerlockChangeEventData","registerPointerlockChangeEventCallback","registerPointerlockErrorEventCallback","requestPointerLock","fillVisibilityChangeEventData","registerVisibilityChangeEventCallback","registerTouchEventCallback","fillGamepadEventData","registerGamepadEventCallback","registerBeforeUnloadEventCallback","fillBatteryEventData","battery","registerBatteryEventCallback","setCanvasElementSize","getCanvasElementSize","jsStackTrace","getCallstack","convertPCtoSourceLocation","wasiRightsToMuslOFlags","wasiOFlagsToMuslOFlags","safeSetTimeout","setImmediateWrapped","safeRequestAnimationFrame","clearImmediateWrapped","registerPostMainLoop","registerPreMainLoop","getPromise","makePromise","idsToPromises","makePromiseCallback","Browser_asyncPrepareDataCounter","arraySum","addDays","getSocketFromFD","getSocketAddress","FS_mkdirTree","_setNetworkCallback","heapObjectForWebGLType","toTypedArrayIndex","webgl_enable_ANGLE_instanced_arrays","webgl_enable_OES_vertex_array_object","webgl_enable_WEBGL_draw_buffers","webgl_enable_WEBGL_multi_draw","webgl_enable_EXT_polygon_offset_clamp","webgl_enable_EXT_clip_control","webgl_enable_WEBGL_polygon_mode","emscriptenWebGLGet","computeUnpackAlignedImageSize","colorChannelsInGlTextureFormat","emscriptenWebGLGetTexPixelData","emscriptenWebGLGetUniform","webglGetUniformLocation","webglPrepareUniformLocationsBeforeFirstUse","webglGetLeftBracePos","emscriptenWebGLGetVertexAttrib","__glGetActiveAttribOrUniform","writeGLArray","registerWebGlEventCallback","runAndAbortIfError","ALLOC_NORMAL","ALLOC_STACK","allocate","writeStringToMemory","writeAsciiToMemory","demangle","stackTrace","getFunctionArgsName","createJsInvokerSignature","PureVirtualError","registerInheritedInstance","unregisterInheritedInstance","getInheritedInstanceCount","getLiveInheritedInstances","setDelayFunction","count_emval_handles"];Cm.forEach(Ke);var Rm=["run","out","err","callMain","abort","wasmMemory","wasmExports","HEAPF32","HEAPF64","HEAP8","HEAPU8","HEAP16","HEAPU16","HEAP32","HEAPU32","HEAP64","HEAPU64","writeStackCookie","checkStackCookie","INT53_MAX","INT53_MIN","bigintToI53Checked","stackSave","stackRestore","stackAlloc","setTempRet0","ptrToString","exitJS","getHeapMax","growMemory","ENV","ERRNO_CODES","strError","DNS","Protocols","Sockets","timers","warnOnce","readEmAsmArgsArray","readEmAsmArgs","runEmAsmFunction","getExecutableName","keepRuntimeAlive","asyncLoad","alignMemory","mmapAlloc","wasmTable","getUniqueRunDependency","noExitRuntime","addOnPreRun","addOnPostRun","freeTableIndexes","functionsInTableMap","setValue","getValue","PATH","PATH_FS","UTF8Decoder","UTF8ArrayToString","UTF8ToString","stringToUTF8Array","stringToUTF8","lengthBytesUTF8","intArrayFromString","AsciiToString","UTF16Decoder","UTF16ToString","stringToUTF16","lengthBytesUTF16","UTF32ToString","stringToUTF32","lengthBytesUTF32","stringToUTF8OnStack","writeArrayToMemory","JSEvents","specialHTMLTargets","findCanvasEventTarget","currentFullscreenStrategy","restoreOldWindowedStyle","UNWIND_CACHE","ExitStatus","getEnvStrings","checkWasiClock","doReadv","doWritev","initRandomFill","randomFill","emSetImmediate","emClearImmediate_deps","emClearImmediate","promiseMap","uncaughtExceptionCount","exceptionLast","exceptionCaught","ExceptionInfo","findMatchingCatch","getExceptionMessageCommon","Browser","requestFullscreen","requestFullScreen","setCanvasSize","getUserMedia","createContext","getPreloadedImageData__data","wget","MONTH_DAYS_REGULAR","MONTH_DAYS_LEAP","MONTH_DAYS_REGULAR_CUMULATIVE","MONTH_DAYS_LEAP_CUMULATIVE","isLeapYear","ydayFromDate","SYSCALLS","preloadPlugins","FS_modeStringToFlags","FS_getMode","FS_stdin_getChar_buffer","FS_stdin_getChar","FS_readFile","FS_root","FS_mounts","FS_devices","FS_streams","FS_nextInode","FS_nameTable","FS_currentPath","FS_initialized","FS_ignorePermissions","FS_filesystems","FS_syncFSRequests","FS_readFiles","FS_lookupPath","FS_getPath","FS_hashName","FS_hashAddNode","FS_hashRemoveNode","FS_lookupNode","FS_createNode","FS_destroyNode","FS_isRoot","FS_isMountpoint","FS_isFile","FS_isDir","FS_isLink","FS_isChrdev","FS_isBlkdev","FS_isFIFO","FS_isSocket","FS_flagsToPermissionString","FS_nodePermissions","FS_mayLookup","FS_mayCreate","FS_mayDelete","FS_mayOpen","FS_checkOpExists","FS_nextfd","FS_getStreamChecked","FS_getStream","FS_createStream","FS_closeStream","FS_dupStream","FS_doSetAttr","FS_chrdev_stream_ops","FS_major","FS_minor","FS_makedev","FS_registerDevice","FS_getDevice","FS_getMounts","FS_syncfs","FS_mount","FS_unmount","FS_lookup","FS_mknod","FS_statfs","FS_statfsStream","FS_statfsNode","FS_create","FS_mkdir","FS_mkdev","FS_symlink","FS_rename","FS_rmdir","FS_readdir","FS_readlink","FS_stat","FS_fstat","FS_lstat","FS_doChmod","FS_chmod","FS_lchmod","FS_fchmod","FS_doChown","FS_chown","FS_lchown","FS_fchown","FS_doTruncate","FS_truncate","FS_ftruncate","FS_utime","FS_open","FS_close","FS_isClosed","FS_llseek","FS_read","FS_write","FS_mmap","FS_msync","FS_ioctl","FS_writeFile","FS_cwd","FS_chdir","FS_createDefaultDirectories","FS_createDefaultDevices","FS_createSpecialDirectories","FS_createStandardStreams","FS_staticInit","FS_init","FS_quit","FS_findObject","FS_analyzePath","FS_createFile","FS_forceLoadFile","FS_absolutePath","FS_createFolder","FS_createLink","FS_joinPath","FS_mmapAlloc","FS_standardizePath","TTY","PIPEFS","SOCKFS","tempFixedLengthArray","miniTempWebGLFloatBuffers","miniTempWebGLIntBuffers","GL","AL","GLUT","EGL","GLEW","IDBStore","SDL","SDL_gfx","allocateUTF8","allocateUTF8OnStack","print","printErr","jstoi_s","InternalError","BindingError","throwInternalError","throwBindingError","registeredTypes","awaitingDependencies","typeDependencies","tupleRegistrations","structRegistrations","sharedRegisterType","whenDependentTypesAreResolved","getTypeName","getFunctionName","heap32VectorToArray","requireRegisteredType","usesDestructorStack","checkArgCount","getRequiredArgCount","createJsInvoker","UnboundTypeError","GenericWireTypeSize","EmValType","EmValOptionalType","throwUnboundTypeError","ensureOverloadTable","exposePublicSymbol","replacePublicSymbol","createNamedFunction","embindRepr","registeredInstances","getBasestPointer","getInheritedInstance","registeredPointers","registerType","integerReadValueFromPointer","enumReadValueFromPointer","floatReadValueFromPointer","assertIntegerRange","readPointer","runDestructors","craftInvokerFunction","embind__requireFunction","genericPointerToWireType","constNoSmartPtrRawPointerToWireType","nonConstNoSmartPtrRawPointerToWireType","init_RegisteredPointer","RegisteredPointer","RegisteredPointer_fromWireType","runDestructor","releaseClassHandle","finalizationRegistry","detachFinalizer_deps","detachFinalizer","attachFinalizer","makeClassHandle","init_ClassHandle","ClassHandle","throwInstanceAlreadyDeleted","deletionQueue","flushPendingDeletes","delayFunction","RegisteredClass","shallowCopyInternalPointer","downcastPointer","upcastPointer","validateThis","char_0","char_9","makeLegalFunctionName","emval_freelist","emval_handles","emval_symbols","getStringOrSymbol","Emval","emval_get_global","emval_returnValue","emval_lookupTypes","emval_methodCallers","emval_addMethodCaller"];Rm.forEach(Et),t.incrementExceptionRefcount=Em,t.decrementExceptionRefcount=Tm,t.getExceptionMessage=Zh;function Pm(){je("fetchSettings")}var Jh={679512:()=>{typeof t<"u"&&"mjDISABLESTRING mjENABLESTRING mjFRAMESTRING mjLABELSTRING mjRNDSTRING mjTIMERSTRING mjVISSTRING".split(" ").forEach(function(r){Object.defineProperty(t,r,{get:function(){return t["get_"+r]()},set:function(a){},enumerable:!0,configurable:!0})})}},Kh=Pe("___getTypeName"),$l=Pe("_malloc"),Im=Pe("___cxa_free_exception"),ql=Pe("_fflush"),Hn=Pe("_free"),Yl=Pe("_emscripten_stack_get_end"),Dm=Pe("_emscripten_stack_get_base"),Qh=Pe("_strerror"),xe=Pe("_setThrew"),eu=Pe("__emscripten_tempret_set"),tu=Pe("_emscripten_stack_init"),Lm=Pe("_emscripten_stack_get_free"),nu=Pe("__emscripten_stack_restore"),iu=Pe("__emscripten_stack_alloc"),ru=Pe("_emscripten_stack_get_current"),jl=Pe("___cxa_decrement_exception_refcount"),Ca=Pe("___cxa_increment_exception_refcount"),su=Pe("___get_exception_message"),au=Pe("___cxa_can_catch"),ou=Pe("___cxa_get_exception_ptr");function Fm(r){Kh=Me("__getTypeName",1),$l=Me("malloc",1),Im=Me("__cxa_free_exception",1),ql=Me("fflush",1),Hn=Me("free",1),Yl=r.emscripten_stack_get_end,Dm=r.emscripten_stack_get_base,Qh=Me("strerror",1),xe=Me("setThrew",2),eu=Me("_emscripten_tempret_set",1),tu=r.emscripten_stack_init,Lm=r.emscripten_stack_get_free,nu=r._emscripten_stack_restore,iu=r._emscripten_stack_alloc,ru=r.emscripten_stack_get_current,jl=Me("__cxa_decrement_exception_refcount",1),Ca=Me("__cxa_increment_exception_refcount",1),su=Me("__get_exception_message",3),au=Me("__cxa_can_catch",3),ou=Me("__cxa_get_exception_ptr",1)}var lu={__assert_fail:is,__cxa_begin_catch:gr,__cxa_current_primary_exception:ca,__cxa_end_catch:Zi,__cxa_find_matching_catch_2:Ll,__cxa_find_matching_catch_3:Fl,__cxa_find_matching_catch_4:Nl,__cxa_rethrow:rs,__cxa_rethrow_primary_exception:C,__cxa_throw:V,__cxa_uncaught_exceptions:te,__resumeException:K,__syscall_dup3:An,__syscall_fcntl64:Gn,__syscall_fstat64:ha,__syscall_ioctl:bf,__syscall_lstat64:wf,__syscall_newfstatat:Ef,__syscall_openat:Tf,__syscall_stat64:Af,_abort_js:Cf,_embind_register_bigint:Pf,_embind_register_bool:If,_embind_register_class:jf,_embind_register_class_class_function:Jf,_embind_register_class_constructor:Kf,_embind_register_class_function:Qf,_embind_register_class_property:ep,_embind_register_constant:tp,_embind_register_emval:zh,_embind_register_enum:ip,_embind_register_enum_value:rp,_embind_register_float:ap,_embind_register_function:op,_embind_register_integer:lp,_embind_register_memory_view:cp,_embind_register_optional:up,_embind_register_std_string:dp,_embind_register_std_wstring:yp,_embind_register_user_type:xp,_embind_register_void:Sp,_emscripten_throw_longjmp:Mp,_emval_as:bp,_emval_call:wp,_emval_call_method:Tp,_emval_decref:Gl,_emval_get_global:Ap,_emval_get_method_caller:Pp,_emval_get_property:Ip,_emval_incref:Dp,_emval_is_number:Lp,_emval_is_string:Fp,_emval_new_array:Np,_emval_new_cstring:Up,_emval_run_destructors:Op,_emval_take_value:Bp,_emval_throw:kp,_localtime_js:Xp,_mktime_js:$p,_tzset_js:qp,clock_time_get:Zp,emscripten_asm_const_int:Qp,emscripten_date_now:Xh,emscripten_get_heap_max:em,emscripten_get_now:Wh,emscripten_resize_heap:im,environ_get:sm,environ_sizes_get:am,exit:cm,fd_close:hm,fd_read:dm,fd_seek:fm,fd_write:mm,invoke_ddd:o_,invoke_dddi:wg,invoke_dddidi:Eg,invoke_ddidi:bg,invoke_di:Tg,invoke_dii:pg,invoke_diii:Ym,invoke_diiii:Mg,invoke_diiiidd:xg,invoke_diiiidi:Jm,invoke_diiiii:Hm,invoke_diiiiii:ig,invoke_diiiiiii:Ag,invoke_diiiiiiiii:tg,invoke_diiiiiiiiiiii:ng,invoke_fiii:v_,invoke_i:Wm,invoke_id:$g,invoke_ii:Om,invoke_iid:Og,invoke_iidddd:d_,invoke_iidiii:ug,invoke_iidiiid:cg,invoke_iidiiiiidi:dg,invoke_iif:u_,invoke_iii:Nm,invoke_iiid:fg,invoke_iiididdddddd:hg,invoke_iiidiiiiiiii:lg,invoke_iiii:zm,invoke_iiiidddiiiii:Rg,invoke_iiiii:qm,invoke_iiiiid:Yg,invoke_iiiiii:Vg,invoke_iiiiiii:kg,invoke_iiiiiiii:Ug,invoke_iiiiiiiidd:jg,invoke_iiiiiiiii:yg,invoke_iiiiiiiiii:zg,invoke_iiiiiiiiiidddiiiiiiiii:og,invoke_iiiiiiiiiii:__,invoke_iiiiiiiiiiii:y_,invoke_iiiiiiiiiiiii:e_,invoke_iiij:Gg,invoke_iiji:qg,invoke_j:m_,invoke_ji:s_,invoke_jiiii:Hg,invoke_jij:a_,invoke_v:km,invoke_vi:Bm,invoke_vid:Bg,invoke_viddd:Wg,invoke_vidddd:Xg,invoke_vidi:Sg,invoke_vidiii:sg,invoke_vii:Vm,invoke_viid:_g,invoke_viiddi:Qg,invoke_viiddidi:Kg,invoke_viiddii:Cg,invoke_viidi:gg,invoke_viidii:Zm,invoke_viidiii:Fg,invoke_viidiiid:Dg,invoke_viidiiiii:ag,invoke_viidiiiiidi:Ng,invoke_viidiiiiiiii:rg,invoke_viii:Um,invoke_viiid:Qm,invoke_viiidd:Jg,invoke_viiidi:mg,invoke_viiididdddddd:Lg,invoke_viiidiiiiiiii:Ig,invoke_viiii:$m,invoke_viiiiddd:Zg,invoke_viiiidi:l_,invoke_viiiifi:c_,invoke_viiiii:Gm,invoke_viiiiid:Km,invoke_viiiiii:Xm,invoke_viiiiiii:jm,invoke_viiiiiiii:vg,invoke_viiiiiiiiii:i_,invoke_viiiiiiiiiidddiiiiiiiii:Pg,invoke_viiiiiiiiiiid:eg,invoke_viiiiiiiiiiiii:n_,invoke_viiiiiiiiiiiiiii:x_,invoke_viiiiiiiiiiiiiiiiii:r_,invoke_viiiij:f_,invoke_viij:p_,invoke_viijii:g_,invoke_vij:h_,invoke_vijjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjj:t_,llvm_eh_typeid_for:gm},nr=await Ee();function Nm(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Um(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Om(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Bm(r,a){var c=_e();try{be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function km(r){var a=_e();try{be(r)()}catch(c){if(ye(a),!(c instanceof H))throw c;xe(1,0)}}function zm(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Gm(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Vm(r,a,c){var u=_e();try{be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Hm(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Wm(r){var a=_e();try{return be(r)()}catch(c){if(ye(a),!(c instanceof H))throw c;xe(1,0)}}function Xm(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function $m(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function qm(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Ym(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function jm(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Zm(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Jm(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Km(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Qm(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function eg(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function tg(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function ng(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function ig(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function rg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function sg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function ag(r,a,c,u,p,_,w,A,F){var X=_e();try{be(r)(a,c,u,p,_,w,A,F)}catch(Q){if(ye(X),!(Q instanceof H))throw Q;xe(1,0)}}function og(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,qt,Kt){var yn=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,qt,Kt)}catch(Nt){if(ye(yn),!(Nt instanceof H))throw Nt;xe(1,0)}}function lg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function cg(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function hg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function ug(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function dg(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function fg(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function pg(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function mg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function gg(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function _g(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function vg(r,a,c,u,p,_,w,A,F){var X=_e();try{be(r)(a,c,u,p,_,w,A,F)}catch(Q){if(ye(X),!(Q instanceof H))throw Q;xe(1,0)}}function yg(r,a,c,u,p,_,w,A,F){var X=_e();try{return be(r)(a,c,u,p,_,w,A,F)}catch(Q){if(ye(X),!(Q instanceof H))throw Q;xe(1,0)}}function xg(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Sg(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Mg(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function bg(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function wg(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Eg(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Tg(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Ag(r,a,c,u,p,_,w,A){var F=_e();try{return be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Cg(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Rg(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function Pg(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,qt,Kt,yn){var Nt=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,qt,Kt,yn)}catch(ir){if(ye(Nt),!(ir instanceof H))throw ir;xe(1,0)}}function Ig(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Dg(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Lg(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Fg(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Ng(r,a,c,u,p,_,w,A,F,X,Q){var oe=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function Ug(r,a,c,u,p,_,w,A){var F=_e();try{return be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Og(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Bg(r,a,c){var u=_e();try{be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function kg(r,a,c,u,p,_,w){var A=_e();try{return be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function zg(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function Gg(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Vg(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Hg(r,a,c,u,p){var _=_e();try{return be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;return xe(1,0),0n}}function Wg(r,a,c,u,p){var _=_e();try{be(r)(a,c,u,p)}catch(w){if(ye(_),!(w instanceof H))throw w;xe(1,0)}}function Xg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function $g(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function qg(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function Yg(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function jg(r,a,c,u,p,_,w,A,F,X){var Q=_e();try{return be(r)(a,c,u,p,_,w,A,F,X)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function Zg(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Jg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function Kg(r,a,c,u,p,_,w,A){var F=_e();try{be(r)(a,c,u,p,_,w,A)}catch(X){if(ye(F),!(X instanceof H))throw X;xe(1,0)}}function Qg(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function e_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe){var ce=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function t_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,qt,Kt,yn,Nt,ir,w_,E_,T_,A_,C_,R_,P_,I_,D_,L_,F_,N_,U_,O_,B_,k_,z_,G_,V_,H_,W_,X_,$_,q_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,C0,R0,P0){var I0=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,qt,Kt,yn,Nt,ir,w_,E_,T_,A_,C_,R_,P_,I_,D_,L_,F_,N_,U_,O_,B_,k_,z_,G_,V_,H_,W_,X_,$_,q_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,C0,R0,P0)}catch(hu){if(ye(I0),!(hu instanceof H))throw hu;xe(1,0)}}function n_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce){var me=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce)}catch(Ye){if(ye(me),!(Ye instanceof H))throw Ye;xe(1,0)}}function i_(r,a,c,u,p,_,w,A,F,X,Q){var oe=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function r_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt){var tt=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye,vt,st,bt)}catch(qt){if(ye(tt),!(qt instanceof H))throw qt;xe(1,0)}}function s_(r,a){var c=_e();try{return be(r)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;return xe(1,0),0n}}function a_(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;return xe(1,0),0n}}function o_(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function l_(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function c_(r,a,c,u,p,_,w){var A=_e();try{be(r)(a,c,u,p,_,w)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function h_(r,a,c){var u=_e();try{be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function u_(r,a,c){var u=_e();try{return be(r)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function d_(r,a,c,u,p,_){var w=_e();try{return be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function f_(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function p_(r,a,c,u){var p=_e();try{be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function m_(r){var a=_e();try{return be(r)()}catch(c){if(ye(a),!(c instanceof H))throw c;return xe(1,0),0n}}function g_(r,a,c,u,p,_){var w=_e();try{be(r)(a,c,u,p,_)}catch(A){if(ye(w),!(A instanceof H))throw A;xe(1,0)}}function __(r,a,c,u,p,_,w,A,F,X,Q){var oe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function v_(r,a,c,u){var p=_e();try{return be(r)(a,c,u)}catch(_){if(ye(p),!(_ instanceof H))throw _;xe(1,0)}}function y_(r,a,c,u,p,_,w,A,F,X,Q,oe){var fe=_e();try{return be(r)(a,c,u,p,_,w,A,F,X,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function x_(r,a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye){var vt=_e();try{be(r)(a,c,u,p,_,w,A,F,X,Q,oe,fe,ce,me,Ye)}catch(st){if(ye(vt),!(st instanceof H))throw st;xe(1,0)}}var cu;function S_(){tu(),Se()}function Zl(){if(Je>0){L=Zl;return}if(S_(),Le(),Je>0){L=Zl;return}function r(){G(!cu),cu=!0,t.calledRun=!0,!z&&($t(),Ct?.(t),t.onRuntimeInitialized?.(),Fe("onRuntimeInitialized"),G(!t._main,'compiled without a main, but one is present. if you added it from JS, use Module["onRuntimeInitialized"]'),Ze())}t.setStatus?(t.setStatus("Running..."),setTimeout(()=>{setTimeout(()=>t.setStatus(""),1),r()},1)):r(),re()}function M_(){var r=U,a=I,c=!1;U=I=u=>{c=!0};try{ql(0),["stdout","stderr"].forEach(u=>{var p=M.analyzePath("/dev/"+u);if(p){var _=p.object,w=_.rdev,A=lt.ttys[w];A?.output?.length&&(c=!0)}})}catch{}U=r,I=a,c&&Jn("stdio streams had content in them that was not flushed. you should set EXIT_RUNTIME to 1 (see the Emscripten FAQ), or make sure to emit a newline when you printf etc.")}function b_(){if(t.preInit)for(typeof t.preInit=="function"&&(t.preInit=[t.preInit]);t.preInit.length>0;)t.preInit.shift()();Fe("preInit")}b_(),Zl(),Rt?e=t:e=new Promise((r,a)=>{Ct=r,mt=a});for(let r of Object.keys(t))r in i||Object.defineProperty(i,r,{configurable:!0,get(){pe(`Access to module property ('${r}') is no longer possible via the module constructor argument; Instead, use the result of the module constructor.`)}});return e}),fu=z0;var pu=i=>fu({wasmBinary:i});function G0([i,e,t,n]){return[1-2*(t*t+n*n),2*(e*t-i*n),2*(e*n+i*t),2*(e*t+i*n),1-2*(e*e+n*n),2*(t*n-i*e),2*(e*n-i*t),2*(t*n+i*e),1-2*(e*e+t*t)]}var V0=([i,e,t,n])=>Math.atan2(2*(i*n+e*t),1-2*(t*t+n*n)),H0=i=>Math.abs(i%1)===.5?2*Math.round(i/2):Math.round(i),ls=class{constructor(e,t,n){this.mujoco=e,this.robot=n,this.model=e.MjModel.from_xml_string(t.xml),t.heights&&this.model.hfield_data.set(t.heights),this.data=new e.MjData(this.model),this.base=e.mj_name2id(this.model,e.mjtObj.mjOBJ_BODY.value,n.base),this.gravity=Math.hypot(...this.model.opt.gravity),this.compiled={mass:this.model.body_mass[this.base],inertia:this.model.body_inertia.slice(3*this.base,3*this.base+3)},this.play=new Float64Array(n.start.length-7),this.reset()}delete(){this.data.delete(),this.model.delete()}reset(e=this.robot.start){let{mujoco:t,model:n,data:s}=this,o=e.slice(7);if(t.mj_resetData(n,s),s.qpos.set(e),s.ctrl.set(o),this.play.set(o),n.nhistory){let{actuator_historyadr:l,actuator_history:h}=n,f=h.length/n.nu;o.forEach((d,m)=>{let y=l[m]+2+h[f*m];l[m]>=0&&s.history.fill(d,y,y+h[f*m])})}t.mj_forward(n,s),this.settled=!0}step(e){let{mujoco:t,model:n,data:s,robot:o}=this;s.ctrl.set(o.servo?this.servoTarget(e):e);for(let l=0;l<o.decimation;l++)this.settled||t.mj_step1(n,s),t.mj_step2(n,s),t.mj_step1(n,s),this.settled=!0}servoTarget(e){let{target_step:t,backlash:n,dead_band:s}=this.robot.servo,o=this.reading("joint_position");return Array.from(e,(l,h)=>{let f=t[h]>0?t[h]*H0(l/t[h]):l;this.play[h]=Math.min(Math.max(this.play[h],f-n[h]/2),f+n[h]/2);let d=this.play[h]-o[h];return this.play[h]-Math.min(Math.max(d,-s[h]),s[h])})}reading(e){return this.data.sensordata.slice(...this.robot.columns[e])}projectedGravity(){let e=G0(this.reading("orientation")),t=this.model.opt.gravity;return[0,1,2].map(n=>(e[n]*t[0]+e[3+n]*t[1]+e[6+n]*t[2])/this.gravity)}position(){return this.data.qpos.slice(0,3)}yaw(){return V0(this.data.qpos.slice(3,7))}fallen(){return!(this.projectedGravity()[2]<-.5)||this.reading("trunk_force")[0]>0||!Number.isFinite(this.data.qpos[0])}push(e){let{qvel:t}=this.data;e.forEach((n,s)=>{t[s]+=n}),this.settled=!1}setFriction(e){let{geom_friction:t}=this.model;for(let n=0;n<t.length;n+=3)t[n]=e;this.settled=!1}setPayload(e){let{mujoco:t,model:n,base:s,compiled:o}=this,l=o.mass+e;n.body_mass[s]=l,o.inertia.forEach((f,d)=>{n.body_inertia[3*s+d]=f*l/o.mass});let h=new t.MjData(n);t.mj_setConst(n,h),h.delete(),this.settled=!1}setSlope(e){this.model.opt.gravity.set([-this.gravity*Math.sin(e),0,-this.gravity*Math.cos(e)]),this.settled=!1}};var Xi={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},$i={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},$u=0,Pc=1,qu=2;var hr=1,Yu=2,qr=3,qi=0,dn=1,di=2,ur=0,Yr=1,Ic=2,Dc=3,Lc=4,ju=5;var dr=100,Zu=101,Ju=102,Ku=103,Qu=104,ed=200,td=201,nd=202,id=203,Fc=204,Nc=205,rd=206,sd=207,ad=208,od=209,ld=210,cd=211,hd=212,ud=213,dd=214,ro=0,so=1,ao=2,Nr=3,oo=4,lo=5,co=6,ho=7,Uo=0,fd=1,pd=2,fi=0,Uc=1,Oc=2,Bc=3,kc=4,zc=5,Gc=6,Ys=7;var Vc=300,fr=301,jr=302,Oo=303,Bo=304,Ur=1e3,ai=1001,uo=1002,cn=1003,md=1004;var js=1005;var Sn=1006,ko=1007;var Ci=1008;var En=1009,Hc=1010,Wc=1011,Zr=1012,zo=1013,Yn=1014,zn=1015,jn=1016,Go=1017,Vo=1018,pr=1020,Xc=35902,$c=35899,qc=1021,Yc=1022,Zn=1023,wi=1026,Ri=1027,Ho=1028,Wo=1029,Yi=1030,Xo=1031;var $o=1033,Zs=33776,Js=33777,Ks=33778,Qs=33779,qo=35840,Yo=35841,jo=35842,Zo=35843,Jo=36196,Ko=37492,Qo=37496,el=37488,tl=37489,ea=37490,nl=37491,il=37808,rl=37809,sl=37810,al=37811,ol=37812,ll=37813,cl=37814,hl=37815,ul=37816,dl=37817,fl=37818,pl=37819,ml=37820,gl=37821,_l=36492,vl=36494,yl=36495,xl=36283,Sl=36284,ta=36285,Ml=36286;var ys=2300,fo=2301,no=2302,Sc=2303,Mc=2400,bc=2401,wc=2402;var gd=3200;var na=0,_d=1,Pi="",mn="srgb",xs="srgb-linear",Ss="linear",Pt="srgb";var io=7680;var vd=519,yd=512,xd=513,Sd=514,jc=515,Md=516,bd=517,Zc=518,Jc=519,wd=35044;var Kc="300 es",Bn=2e3,Or=2001;function W0(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function X0(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ms(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Ed(){let i=Ms("canvas");return i.style.display="block",i}var mu={},Br=null;function Qc(...i){let e="THREE."+i.shift();Br?Br("log",e,...i):console.log(e,...i)}function Td(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Qe(...i){i=Td(i);let e="THREE."+i.shift();if(Br)Br("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=Td(i);let e="THREE."+i.shift();if(Br)Br("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function gs(...i){let e=i.join(" ");e in mu||(mu[e]=!0,Qe(...i))}function Ad(i,e,t){return new Promise(function(n,s){function o(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(o,t);break;default:n()}}setTimeout(o,t)})}var Cd={[ro]:ro,[ao]:co,[oo]:oo,[Nr]:lo,[so]:so,[co]:ao,[ho]:ho,[lo]:Nr},qn=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let o=s.indexOf(t);o!==-1&&s.splice(o,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let o=0,l=s.length;o<l;o++)s[o].call(this,e);e.target=null}}},fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],gu=1234567,_s=Math.PI/180,kr=180/Math.PI;function Jr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(fn[i&255]+fn[i>>8&255]+fn[i>>16&255]+fn[i>>24&255]+"-"+fn[e&255]+fn[e>>8&255]+"-"+fn[e>>16&15|64]+fn[e>>24&255]+"-"+fn[t&63|128]+fn[t>>8&255]+"-"+fn[t>>16&255]+fn[t>>24&255]+fn[n&255]+fn[n>>8&255]+fn[n>>16&255]+fn[n>>24&255]).toLowerCase()}function yt(i,e,t){return Math.max(e,Math.min(t,i))}function eh(i,e){return(i%e+e)%e}function $0(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function q0(i,e,t){return i!==e?(t-i)/(e-i):0}function vs(i,e,t){return(1-t)*i+t*e}function Y0(i,e,t,n){return vs(i,e,1-Math.exp(-t*n))}function j0(i,e=1){return e-Math.abs(eh(i,e*2)-e)}function Z0(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function J0(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function K0(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Q0(i,e){return i+Math.random()*(e-i)}function ev(i){return i*(.5-Math.random())}function tv(i){i!==void 0&&(gu=i);let e=gu+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function nv(i){return i*_s}function iv(i){return i*kr}function rv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function sv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function th(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function av(i,e,t,n,s){let o=Math.cos,l=Math.sin,h=o(t/2),f=l(t/2),d=o((e+n)/2),m=l((e+n)/2),y=o((e-n)/2),g=l((e-n)/2),S=o((n-e)/2),E=l((n-e)/2);switch(s){case"XYX":i.set(h*m,f*y,f*g,h*d);break;case"YZY":i.set(f*g,h*m,f*y,h*d);break;case"ZXZ":i.set(f*y,f*g,h*m,h*d);break;case"XZX":i.set(h*m,f*E,f*S,h*d);break;case"YXY":i.set(f*S,h*m,f*E,h*d);break;case"ZYZ":i.set(f*E,f*S,h*m,h*d);break;default:Qe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function nh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Rd(i,e){if(e.constructor===Float32Array)return i;let t=nh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Pd(i,e){if(e.constructor===Float32Array)return i;let t=nh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var ih={DEG2RAD:_s,RAD2DEG:kr,generateUUID:Jr,clamp:yt,euclideanModulo:eh,mapLinear:$0,inverseLerp:q0,lerp:vs,damp:Y0,pingpong:j0,smoothstep:Z0,smootherstep:J0,randInt:K0,randFloat:Q0,randFloatSpread:ev,seededRandom:tv,degToRad:nv,radToDeg:iv,isPowerOfTwo:rv,ceilPowerOfTwo:sv,floorPowerOfTwo:th,setQuaternionFromProperEuler:av,normalize:Pd,denormalize:Rd},et=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),o=this.x-e.x,l=this.y-e.y;return this.x=o*n-l*s+e.x,this.y=o*s+l*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Mn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,o,l,h){let f=n[s+0],d=n[s+1],m=n[s+2],y=n[s+3],g=o[l+0],S=o[l+1],E=o[l+2],R=o[l+3];if(y!==R||f!==g||d!==S||m!==E){let x=f*g+d*S+m*E+y*R;x<0&&(g=-g,S=-S,E=-E,R=-R,x=-x);let v=1-h;if(x<.9995){let P=Math.acos(x),U=Math.sin(P);v=Math.sin(v*P)/U,h=Math.sin(h*P)/U,f=f*v+g*h,d=d*v+S*h,m=m*v+E*h,y=y*v+R*h}else{f=f*v+g*h,d=d*v+S*h,m=m*v+E*h,y=y*v+R*h;let P=1/Math.sqrt(f*f+d*d+m*m+y*y);f*=P,d*=P,m*=P,y*=P}}e[t]=f,e[t+1]=d,e[t+2]=m,e[t+3]=y}static multiplyQuaternionsFlat(e,t,n,s,o,l){let h=n[s],f=n[s+1],d=n[s+2],m=n[s+3],y=o[l],g=o[l+1],S=o[l+2],E=o[l+3];return e[t]=h*E+m*y+f*S-d*g,e[t+1]=f*E+m*g+d*y-h*S,e[t+2]=d*E+m*S+h*g-f*y,e[t+3]=m*E-h*y-f*g-d*S,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,o=e._z,l=e._order,h=Math.cos,f=Math.sin,d=h(n/2),m=h(s/2),y=h(o/2),g=f(n/2),S=f(s/2),E=f(o/2);switch(l){case"XYZ":this._x=g*m*y+d*S*E,this._y=d*S*y-g*m*E,this._z=d*m*E+g*S*y,this._w=d*m*y-g*S*E;break;case"YXZ":this._x=g*m*y+d*S*E,this._y=d*S*y-g*m*E,this._z=d*m*E-g*S*y,this._w=d*m*y+g*S*E;break;case"ZXY":this._x=g*m*y-d*S*E,this._y=d*S*y+g*m*E,this._z=d*m*E+g*S*y,this._w=d*m*y-g*S*E;break;case"ZYX":this._x=g*m*y-d*S*E,this._y=d*S*y+g*m*E,this._z=d*m*E-g*S*y,this._w=d*m*y+g*S*E;break;case"YZX":this._x=g*m*y+d*S*E,this._y=d*S*y+g*m*E,this._z=d*m*E-g*S*y,this._w=d*m*y-g*S*E;break;case"XZY":this._x=g*m*y-d*S*E,this._y=d*S*y-g*m*E,this._z=d*m*E+g*S*y,this._w=d*m*y+g*S*E;break;default:Qe("Quaternion: .setFromEuler() encountered an unknown order: "+l)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],o=t[8],l=t[1],h=t[5],f=t[9],d=t[2],m=t[6],y=t[10],g=n+h+y;if(g>0){let S=.5/Math.sqrt(g+1);this._w=.25/S,this._x=(m-f)*S,this._y=(o-d)*S,this._z=(l-s)*S}else if(n>h&&n>y){let S=2*Math.sqrt(1+n-h-y);this._w=(m-f)/S,this._x=.25*S,this._y=(s+l)/S,this._z=(o+d)/S}else if(h>y){let S=2*Math.sqrt(1+h-n-y);this._w=(o-d)/S,this._x=(s+l)/S,this._y=.25*S,this._z=(f+m)/S}else{let S=2*Math.sqrt(1+y-n-h);this._w=(l-s)/S,this._x=(o+d)/S,this._y=(f+m)/S,this._z=.25*S}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,o=e._z,l=e._w,h=t._x,f=t._y,d=t._z,m=t._w;return this._x=n*m+l*h+s*d-o*f,this._y=s*m+l*f+o*h-n*d,this._z=o*m+l*d+n*f-s*h,this._w=l*m-n*h-s*f-o*d,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,o=e._z,l=e._w,h=this.dot(e);h<0&&(n=-n,s=-s,o=-o,l=-l,h=-h);let f=1-t;if(h<.9995){let d=Math.acos(h),m=Math.sin(d);f=Math.sin(f*d)/m,t=Math.sin(t*d)/m,this._x=this._x*f+n*t,this._y=this._y*f+s*t,this._z=this._z*f+o*t,this._w=this._w*f+l*t,this._onChangeCallback()}else this._x=this._x*f+n*t,this._y=this._y*f+s*t,this._z=this._z*f+o*t,this._w=this._w*f+l*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),o=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),o*Math.sin(t),o*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},j=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(_u.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(_u.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[3]*n+o[6]*s,this.y=o[1]*t+o[4]*n+o[7]*s,this.z=o[2]*t+o[5]*n+o[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,o=e.elements,l=1/(o[3]*t+o[7]*n+o[11]*s+o[15]);return this.x=(o[0]*t+o[4]*n+o[8]*s+o[12])*l,this.y=(o[1]*t+o[5]*n+o[9]*s+o[13])*l,this.z=(o[2]*t+o[6]*n+o[10]*s+o[14])*l,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,o=e.x,l=e.y,h=e.z,f=e.w,d=2*(l*s-h*n),m=2*(h*t-o*s),y=2*(o*n-l*t);return this.x=t+f*d+l*y-h*m,this.y=n+f*m+h*d-o*y,this.z=s+f*y+o*m-l*d,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s,this.y=o[1]*t+o[5]*n+o[9]*s,this.z=o[2]*t+o[6]*n+o[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,o=e.z,l=t.x,h=t.y,f=t.z;return this.x=s*f-o*h,this.y=o*l-n*f,this.z=n*h-s*l,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Ql.copy(this).projectOnVector(e),this.sub(Ql)}reflect(e){return this.sub(Ql.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ql=new j,_u=new Mn,ct=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,o,l,h,f,d){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,l,h,f,d)}set(e,t,n,s,o,l,h,f,d){let m=this.elements;return m[0]=e,m[1]=s,m[2]=h,m[3]=t,m[4]=o,m[5]=f,m[6]=n,m[7]=l,m[8]=d,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,o=this.elements,l=n[0],h=n[3],f=n[6],d=n[1],m=n[4],y=n[7],g=n[2],S=n[5],E=n[8],R=s[0],x=s[3],v=s[6],P=s[1],U=s[4],I=s[7],O=s[2],N=s[5],b=s[8];return o[0]=l*R+h*P+f*O,o[3]=l*x+h*U+f*N,o[6]=l*v+h*I+f*b,o[1]=d*R+m*P+y*O,o[4]=d*x+m*U+y*N,o[7]=d*v+m*I+y*b,o[2]=g*R+S*P+E*O,o[5]=g*x+S*U+E*N,o[8]=g*v+S*I+E*b,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8];return t*l*m-t*h*d-n*o*m+n*h*f+s*o*d-s*l*f}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8],y=m*l-h*d,g=h*f-m*o,S=d*o-l*f,E=t*y+n*g+s*S;if(E===0)return this.set(0,0,0,0,0,0,0,0,0);let R=1/E;return e[0]=y*R,e[1]=(s*d-m*n)*R,e[2]=(h*n-s*l)*R,e[3]=g*R,e[4]=(m*t-s*f)*R,e[5]=(s*o-h*t)*R,e[6]=S*R,e[7]=(n*f-d*t)*R,e[8]=(l*t-n*o)*R,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,o,l,h){let f=Math.cos(o),d=Math.sin(o);return this.set(n*f,n*d,-n*(f*l+d*h)+l+e,-s*d,s*f,-s*(-d*l+f*h)+h+t,0,0,1),this}scale(e,t){return gs("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ec.makeScale(e,t)),this}rotate(e){return gs("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ec.makeRotation(-e)),this}translate(e,t){return gs("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ec.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ec=new ct,vu=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),yu=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ov(){let i={enabled:!0,workingColorSpace:xs,spaces:{},convert:function(s,o,l){return this.enabled===!1||o===l||!o||!l||(this.spaces[o].transfer===Pt&&(s.r=bi(s.r),s.g=bi(s.g),s.b=bi(s.b)),this.spaces[o].primaries!==this.spaces[l].primaries&&(s.applyMatrix3(this.spaces[o].toXYZ),s.applyMatrix3(this.spaces[l].fromXYZ)),this.spaces[l].transfer===Pt&&(s.r=Fr(s.r),s.g=Fr(s.g),s.b=Fr(s.b))),s},workingToColorSpace:function(s,o){return this.convert(s,this.workingColorSpace,o)},colorSpaceToWorking:function(s,o){return this.convert(s,o,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Pi?Ss:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,o=this.workingColorSpace){return s.fromArray(this.spaces[o].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,o,l){return s.copy(this.spaces[l].fromXYZ).multiply(this.spaces[o].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[xs]:{primaries:e,whitePoint:n,transfer:Ss,toXYZ:vu,fromXYZ:yu,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:mn},outputColorSpaceConfig:{drawingBufferColorSpace:mn}},[mn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:vu,fromXYZ:yu,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:mn}}}),i}var St=ov();function bi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Fr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xr,po=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{xr===void 0&&(xr=Ms("canvas")),xr.width=e.width,xr.height=e.height;let s=xr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=xr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ms("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),o=s.data;for(let l=0;l<o.length;l++)o[l]=bi(o[l]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(bi(t[n]/255)*255):t[n]=bi(t[n]);return{data:t,width:e.width,height:e.height}}else return Qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},lv=0,zr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:lv++}),this.uuid=Jr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let o;if(Array.isArray(s)){o=[];for(let l=0,h=s.length;l<h;l++)s[l].isDataTexture?o.push(tc(s[l].image)):o.push(tc(s[l]))}else o=tc(s);n.url=o}return t||(e.images[this.uuid]=n),n}};function tc(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?po.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Qe("Texture: Unable to serialize Texture."),{})}var cv=0,nc=new j,bn=class i extends qn{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ai,s=ai,o=Sn,l=Ci,h=Zn,f=En,d=i.DEFAULT_ANISOTROPY,m=Pi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:cv++}),this.uuid=Jr(),this.name="",this.source=new zr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=o,this.minFilter=l,this.anisotropy=d,this.format=h,this.internalFormat=null,this.type=f,this.offset=new et(0,0),this.repeat=new et(1,1),this.center=new et(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=m,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(nc).x}get height(){return this.source.getSize(nc).y}get depth(){return this.source.getSize(nc).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Qe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Vc)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ur:e.x=e.x-Math.floor(e.x);break;case ai:e.x=e.x<0?0:1;break;case uo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ur:e.y=e.y-Math.floor(e.y);break;case ai:e.y=e.y<0?0:1;break;case uo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};bn.DEFAULT_IMAGE=null;bn.DEFAULT_MAPPING=Vc;bn.DEFAULT_ANISOTROPY=1;var Gt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,o=this.w,l=e.elements;return this.x=l[0]*t+l[4]*n+l[8]*s+l[12]*o,this.y=l[1]*t+l[5]*n+l[9]*s+l[13]*o,this.z=l[2]*t+l[6]*n+l[10]*s+l[14]*o,this.w=l[3]*t+l[7]*n+l[11]*s+l[15]*o,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,o,f=e.elements,d=f[0],m=f[4],y=f[8],g=f[1],S=f[5],E=f[9],R=f[2],x=f[6],v=f[10];if(Math.abs(m-g)<.01&&Math.abs(y-R)<.01&&Math.abs(E-x)<.01){if(Math.abs(m+g)<.1&&Math.abs(y+R)<.1&&Math.abs(E+x)<.1&&Math.abs(d+S+v-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let U=(d+1)/2,I=(S+1)/2,O=(v+1)/2,N=(m+g)/4,b=(y+R)/4,D=(E+x)/4;return U>I&&U>O?U<.01?(n=0,s=.707106781,o=.707106781):(n=Math.sqrt(U),s=N/n,o=b/n):I>O?I<.01?(n=.707106781,s=0,o=.707106781):(s=Math.sqrt(I),n=N/s,o=D/s):O<.01?(n=.707106781,s=.707106781,o=0):(o=Math.sqrt(O),n=b/o,s=D/o),this.set(n,s,o,t),this}let P=Math.sqrt((x-E)*(x-E)+(y-R)*(y-R)+(g-m)*(g-m));return Math.abs(P)<.001&&(P=1),this.x=(x-E)/P,this.y=(y-R)/P,this.z=(g-m)/P,this.w=Math.acos((d+S+v-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},mo=class extends qn{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Sn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t),this.textures=[];let s=n.count;for(let o=0;o<s;o++)this.textures[o]=new bn({width:e,height:t,depth:n.depth}),this.textures[o].isRenderTargetTexture=!0,this.textures[o].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Sn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,o=this.textures.length;s<o;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new zr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Dn=class extends mo{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},bs=class extends bn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=ai,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var go=class extends bn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=ai,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Lt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,o,l,h,f,d,m,y,g,S,E,R,x){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,l,h,f,d,m,y,g,S,E,R,x)}set(e,t,n,s,o,l,h,f,d,m,y,g,S,E,R,x){let v=this.elements;return v[0]=e,v[4]=t,v[8]=n,v[12]=s,v[1]=o,v[5]=l,v[9]=h,v[13]=f,v[2]=d,v[6]=m,v[10]=y,v[14]=g,v[3]=S,v[7]=E,v[11]=R,v[15]=x,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Sr.setFromMatrixColumn(e,0).length(),o=1/Sr.setFromMatrixColumn(e,1).length(),l=1/Sr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*o,t[5]=n[5]*o,t[6]=n[6]*o,t[7]=0,t[8]=n[8]*l,t[9]=n[9]*l,t[10]=n[10]*l,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,o=e.z,l=Math.cos(n),h=Math.sin(n),f=Math.cos(s),d=Math.sin(s),m=Math.cos(o),y=Math.sin(o);if(e.order==="XYZ"){let g=l*m,S=l*y,E=h*m,R=h*y;t[0]=f*m,t[4]=-f*y,t[8]=d,t[1]=S+E*d,t[5]=g-R*d,t[9]=-h*f,t[2]=R-g*d,t[6]=E+S*d,t[10]=l*f}else if(e.order==="YXZ"){let g=f*m,S=f*y,E=d*m,R=d*y;t[0]=g+R*h,t[4]=E*h-S,t[8]=l*d,t[1]=l*y,t[5]=l*m,t[9]=-h,t[2]=S*h-E,t[6]=R+g*h,t[10]=l*f}else if(e.order==="ZXY"){let g=f*m,S=f*y,E=d*m,R=d*y;t[0]=g-R*h,t[4]=-l*y,t[8]=E+S*h,t[1]=S+E*h,t[5]=l*m,t[9]=R-g*h,t[2]=-l*d,t[6]=h,t[10]=l*f}else if(e.order==="ZYX"){let g=l*m,S=l*y,E=h*m,R=h*y;t[0]=f*m,t[4]=E*d-S,t[8]=g*d+R,t[1]=f*y,t[5]=R*d+g,t[9]=S*d-E,t[2]=-d,t[6]=h*f,t[10]=l*f}else if(e.order==="YZX"){let g=l*f,S=l*d,E=h*f,R=h*d;t[0]=f*m,t[4]=R-g*y,t[8]=E*y+S,t[1]=y,t[5]=l*m,t[9]=-h*m,t[2]=-d*m,t[6]=S*y+E,t[10]=g-R*y}else if(e.order==="XZY"){let g=l*f,S=l*d,E=h*f,R=h*d;t[0]=f*m,t[4]=-y,t[8]=d*m,t[1]=g*y+R,t[5]=l*m,t[9]=S*y-E,t[2]=E*y-S,t[6]=h*m,t[10]=R*y+g}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(hv,e,uv)}lookAt(e,t,n){let s=this.elements;return Cn.subVectors(e,t),Cn.lengthSq()===0&&(Cn.z=1),Cn.normalize(),Li.crossVectors(n,Cn),Li.lengthSq()===0&&(Math.abs(n.z)===1?Cn.x+=1e-4:Cn.z+=1e-4,Cn.normalize(),Li.crossVectors(n,Cn)),Li.normalize(),Da.crossVectors(Cn,Li),s[0]=Li.x,s[4]=Da.x,s[8]=Cn.x,s[1]=Li.y,s[5]=Da.y,s[9]=Cn.y,s[2]=Li.z,s[6]=Da.z,s[10]=Cn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,o=this.elements,l=n[0],h=n[4],f=n[8],d=n[12],m=n[1],y=n[5],g=n[9],S=n[13],E=n[2],R=n[6],x=n[10],v=n[14],P=n[3],U=n[7],I=n[11],O=n[15],N=s[0],b=s[4],D=s[8],q=s[12],k=s[1],Y=s[5],J=s[9],ee=s[13],z=s[2],ie=s[6],G=s[10],ne=s[14],Se=s[3],re=s[7],H=s[11],ge=s[15];return o[0]=l*N+h*k+f*z+d*Se,o[4]=l*b+h*Y+f*ie+d*re,o[8]=l*D+h*J+f*G+d*H,o[12]=l*q+h*ee+f*ne+d*ge,o[1]=m*N+y*k+g*z+S*Se,o[5]=m*b+y*Y+g*ie+S*re,o[9]=m*D+y*J+g*G+S*H,o[13]=m*q+y*ee+g*ne+S*ge,o[2]=E*N+R*k+x*z+v*Se,o[6]=E*b+R*Y+x*ie+v*re,o[10]=E*D+R*J+x*G+v*H,o[14]=E*q+R*ee+x*ne+v*ge,o[3]=P*N+U*k+I*z+O*Se,o[7]=P*b+U*Y+I*ie+O*re,o[11]=P*D+U*J+I*G+O*H,o[15]=P*q+U*ee+I*ne+O*ge,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],o=e[12],l=e[1],h=e[5],f=e[9],d=e[13],m=e[2],y=e[6],g=e[10],S=e[14],E=e[3],R=e[7],x=e[11],v=e[15],P=f*S-d*g,U=h*S-d*y,I=h*g-f*y,O=l*S-d*m,N=l*g-f*m,b=l*y-h*m;return t*(R*P-x*U+v*I)-n*(E*P-x*O+v*N)+s*(E*U-R*O+v*b)-o*(E*I-R*N+x*b)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],o=e[1],l=e[5],h=e[9],f=e[2],d=e[6],m=e[10];return t*(l*m-h*d)-n*(o*m-h*f)+s*(o*d-l*f)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8],y=e[9],g=e[10],S=e[11],E=e[12],R=e[13],x=e[14],v=e[15],P=t*h-n*l,U=t*f-s*l,I=t*d-o*l,O=n*f-s*h,N=n*d-o*h,b=s*d-o*f,D=m*R-y*E,q=m*x-g*E,k=m*v-S*E,Y=y*x-g*R,J=y*v-S*R,ee=g*v-S*x,z=P*ee-U*J+I*Y+O*k-N*q+b*D;if(z===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let ie=1/z;return e[0]=(h*ee-f*J+d*Y)*ie,e[1]=(s*J-n*ee-o*Y)*ie,e[2]=(R*b-x*N+v*O)*ie,e[3]=(g*N-y*b-S*O)*ie,e[4]=(f*k-l*ee-d*q)*ie,e[5]=(t*ee-s*k+o*q)*ie,e[6]=(x*I-E*b-v*U)*ie,e[7]=(m*b-g*I+S*U)*ie,e[8]=(l*J-h*k+d*D)*ie,e[9]=(n*k-t*J-o*D)*ie,e[10]=(E*N-R*I+v*P)*ie,e[11]=(y*I-m*N-S*P)*ie,e[12]=(h*q-l*Y-f*D)*ie,e[13]=(t*Y-n*q+s*D)*ie,e[14]=(R*U-E*O-x*P)*ie,e[15]=(m*O-y*U+g*P)*ie,this}scale(e){let t=this.elements,n=e.x,s=e.y,o=e.z;return t[0]*=n,t[4]*=s,t[8]*=o,t[1]*=n,t[5]*=s,t[9]*=o,t[2]*=n,t[6]*=s,t[10]*=o,t[3]*=n,t[7]*=s,t[11]*=o,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),o=1-n,l=e.x,h=e.y,f=e.z,d=o*l,m=o*h;return this.set(d*l+n,d*h-s*f,d*f+s*h,0,d*h+s*f,m*h+n,m*f-s*l,0,d*f-s*h,m*f+s*l,o*f*f+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,o,l){return this.set(1,n,o,0,e,1,l,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,o=t._x,l=t._y,h=t._z,f=t._w,d=o+o,m=l+l,y=h+h,g=o*d,S=o*m,E=o*y,R=l*m,x=l*y,v=h*y,P=f*d,U=f*m,I=f*y,O=n.x,N=n.y,b=n.z;return s[0]=(1-(R+v))*O,s[1]=(S+I)*O,s[2]=(E-U)*O,s[3]=0,s[4]=(S-I)*N,s[5]=(1-(g+v))*N,s[6]=(x+P)*N,s[7]=0,s[8]=(E+U)*b,s[9]=(x-P)*b,s[10]=(1-(g+R))*b,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let o=this.determinantAffine();if(o===0)return n.set(1,1,1),t.identity(),this;let l=Sr.set(s[0],s[1],s[2]).length(),h=Sr.set(s[4],s[5],s[6]).length(),f=Sr.set(s[8],s[9],s[10]).length();o<0&&(l=-l),Wn.copy(this);let d=1/l,m=1/h,y=1/f;return Wn.elements[0]*=d,Wn.elements[1]*=d,Wn.elements[2]*=d,Wn.elements[4]*=m,Wn.elements[5]*=m,Wn.elements[6]*=m,Wn.elements[8]*=y,Wn.elements[9]*=y,Wn.elements[10]*=y,t.setFromRotationMatrix(Wn),n.x=l,n.y=h,n.z=f,this}makePerspective(e,t,n,s,o,l,h=Bn,f=!1){let d=this.elements,m=2*o/(t-e),y=2*o/(n-s),g=(t+e)/(t-e),S=(n+s)/(n-s),E,R;if(f)E=o/(l-o),R=l*o/(l-o);else if(h===Bn)E=-(l+o)/(l-o),R=-2*l*o/(l-o);else if(h===Or)E=-l/(l-o),R=-l*o/(l-o);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+h);return d[0]=m,d[4]=0,d[8]=g,d[12]=0,d[1]=0,d[5]=y,d[9]=S,d[13]=0,d[2]=0,d[6]=0,d[10]=E,d[14]=R,d[3]=0,d[7]=0,d[11]=-1,d[15]=0,this}makeOrthographic(e,t,n,s,o,l,h=Bn,f=!1){let d=this.elements,m=2/(t-e),y=2/(n-s),g=-(t+e)/(t-e),S=-(n+s)/(n-s),E,R;if(f)E=1/(l-o),R=l/(l-o);else if(h===Bn)E=-2/(l-o),R=-(l+o)/(l-o);else if(h===Or)E=-1/(l-o),R=-o/(l-o);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+h);return d[0]=m,d[4]=0,d[8]=0,d[12]=g,d[1]=0,d[5]=y,d[9]=0,d[13]=S,d[2]=0,d[6]=0,d[10]=E,d[14]=R,d[3]=0,d[7]=0,d[11]=0,d[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Sr=new j,Wn=new Lt,hv=new j(0,0,0),uv=new j(1,1,1),Li=new j,Da=new j,Cn=new j,xu=new Lt,Su=new Mn,oi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,o=s[0],l=s[4],h=s[8],f=s[1],d=s[5],m=s[9],y=s[2],g=s[6],S=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(-m,S),this._z=Math.atan2(-l,o)):(this._x=Math.atan2(g,d),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(m,-1,1)),Math.abs(m)<.9999999?(this._y=Math.atan2(h,S),this._z=Math.atan2(f,d)):(this._y=Math.atan2(-y,o),this._z=0);break;case"ZXY":this._x=Math.asin(yt(g,-1,1)),Math.abs(g)<.9999999?(this._y=Math.atan2(-y,S),this._z=Math.atan2(-l,d)):(this._y=0,this._z=Math.atan2(f,o));break;case"ZYX":this._y=Math.asin(-yt(y,-1,1)),Math.abs(y)<.9999999?(this._x=Math.atan2(g,S),this._z=Math.atan2(f,o)):(this._x=0,this._z=Math.atan2(-l,d));break;case"YZX":this._z=Math.asin(yt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(-m,d),this._y=Math.atan2(-y,o)):(this._x=0,this._y=Math.atan2(h,S));break;case"XZY":this._z=Math.asin(-yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(g,d),this._y=Math.atan2(h,o)):(this._x=Math.atan2(-m,S),this._y=0);break;default:Qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return xu.makeRotationFromQuaternion(e),this.setFromRotationMatrix(xu,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Su.setFromEuler(this),this.setFromQuaternion(Su,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};oi.DEFAULT_ORDER="XYZ";var Gr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},dv=0,Mu=new j,Mr=new Mn,vi=new Lt,La=new j,cs=new j,fv=new j,pv=new Mn,bu=new j(1,0,0),wu=new j(0,1,0),Eu=new j(0,0,1),Tu={type:"added"},mv={type:"removed"},br={type:"childadded",child:null},ic={type:"childremoved",child:null},Qt=class i extends qn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:dv++}),this.uuid=Jr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new j,t=new oi,n=new Mn,s=new j(1,1,1);function o(){n.setFromEuler(t,!1)}function l(){t.setFromQuaternion(n,void 0,!1)}t._onChange(o),n._onChange(l),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Lt},normalMatrix:{value:new ct}}),this.matrix=new Lt,this.matrixWorld=new Lt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Gr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Mr.setFromAxisAngle(e,t),this.quaternion.multiply(Mr),this}rotateOnWorldAxis(e,t){return Mr.setFromAxisAngle(e,t),this.quaternion.premultiply(Mr),this}rotateX(e){return this.rotateOnAxis(bu,e)}rotateY(e){return this.rotateOnAxis(wu,e)}rotateZ(e){return this.rotateOnAxis(Eu,e)}translateOnAxis(e,t){return Mu.copy(e).applyQuaternion(this.quaternion),this.position.add(Mu.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(bu,e)}translateY(e){return this.translateOnAxis(wu,e)}translateZ(e){return this.translateOnAxis(Eu,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(vi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?La.copy(e):La.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),cs.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?vi.lookAt(cs,La,this.up):vi.lookAt(La,cs,this.up),this.quaternion.setFromRotationMatrix(vi),s&&(vi.extractRotation(s.matrixWorld),Mr.setFromRotationMatrix(vi),this.quaternion.premultiply(Mr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Tu),br.child=e,this.dispatchEvent(br),br.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(mv),ic.child=e,this.dispatchEvent(ic),ic.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),vi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),vi.multiply(e.parent.matrixWorld)),e.applyMatrix4(vi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Tu),br.child=e,this.dispatchEvent(br),br.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let l=this.children[n].getObjectByProperty(e,t);if(l!==void 0)return l}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let o=0,l=s.length;o<l;o++)s[o].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cs,e,fv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cs,pv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,o=this.matrix.elements;o[12]+=t-o[0]*t-o[4]*n-o[8]*s,o[13]+=n-o[1]*t-o[5]*n-o[9]*s,o[14]+=s-o[2]*t-o[6]*n-o[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let o=this.children;for(let l=0,h=o.length;l<h;l++)o[l].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(h=>({...h,boundingBox:h.boundingBox?h.boundingBox.toJSON():void 0,boundingSphere:h.boundingSphere?h.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(h=>({...h})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function o(h,f){return h[f.uuid]===void 0&&(h[f.uuid]=f.toJSON(e)),f.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=o(e.geometries,this.geometry);let h=this.geometry.parameters;if(h!==void 0&&h.shapes!==void 0){let f=h.shapes;if(Array.isArray(f))for(let d=0,m=f.length;d<m;d++){let y=f[d];o(e.shapes,y)}else o(e.shapes,f)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(o(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let h=[];for(let f=0,d=this.material.length;f<d;f++)h.push(o(e.materials,this.material[f]));s.material=h}else s.material=o(e.materials,this.material);if(this.children.length>0){s.children=[];for(let h=0;h<this.children.length;h++)s.children.push(this.children[h].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let h=0;h<this.animations.length;h++){let f=this.animations[h];s.animations.push(o(e.animations,f))}}if(t){let h=l(e.geometries),f=l(e.materials),d=l(e.textures),m=l(e.images),y=l(e.shapes),g=l(e.skeletons),S=l(e.animations),E=l(e.nodes);h.length>0&&(n.geometries=h),f.length>0&&(n.materials=f),d.length>0&&(n.textures=d),m.length>0&&(n.images=m),y.length>0&&(n.shapes=y),g.length>0&&(n.skeletons=g),S.length>0&&(n.animations=S),E.length>0&&(n.nodes=E)}return n.object=s,n;function l(h){let f=[];for(let d in h){let m=h[d];delete m.metadata,f.push(m)}return f}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Qt.DEFAULT_UP=new j(0,1,0);Qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Qt{constructor(){super(),this.isGroup=!0,this.type="Group"}},gv={type:"move"},Vr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new j,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new j),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new j,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new j,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,o=null,l=null,h=this._targetRay,f=this._grip,d=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(d&&e.hand){l=!0;for(let R of e.hand.values()){let x=t.getJointPose(R,n),v=this._getHandJoint(d,R);x!==null&&(v.matrix.fromArray(x.transform.matrix),v.matrix.decompose(v.position,v.quaternion,v.scale),v.matrixWorldNeedsUpdate=!0,v.jointRadius=x.radius),v.visible=x!==null}let m=d.joints["index-finger-tip"],y=d.joints["thumb-tip"],g=m.position.distanceTo(y.position),S=.02,E=.005;d.inputState.pinching&&g>S+E?(d.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!d.inputState.pinching&&g<=S-E&&(d.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else f!==null&&e.gripSpace&&(o=t.getPose(e.gripSpace,n),o!==null&&(f.matrix.fromArray(o.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,o.linearVelocity?(f.hasLinearVelocity=!0,f.linearVelocity.copy(o.linearVelocity)):f.hasLinearVelocity=!1,o.angularVelocity?(f.hasAngularVelocity=!0,f.angularVelocity.copy(o.angularVelocity)):f.hasAngularVelocity=!1,f.eventsEnabled&&f.dispatchEvent({type:"gripUpdated",data:e,target:this})));h!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&o!==null&&(s=o),s!==null&&(h.matrix.fromArray(s.transform.matrix),h.matrix.decompose(h.position,h.quaternion,h.scale),h.matrixWorldNeedsUpdate=!0,s.linearVelocity?(h.hasLinearVelocity=!0,h.linearVelocity.copy(s.linearVelocity)):h.hasLinearVelocity=!1,s.angularVelocity?(h.hasAngularVelocity=!0,h.angularVelocity.copy(s.angularVelocity)):h.hasAngularVelocity=!1,this.dispatchEvent(gv)))}return h!==null&&(h.visible=s!==null),f!==null&&(f.visible=o!==null),d!==null&&(d.visible=l!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new kn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Id={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fi={h:0,s:0,l:0},Fa={h:0,s:0,l:0};function rc(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ht=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=mn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=St.workingColorSpace){if(e=eh(e,1),t=yt(t,0,1),n=yt(n,0,1),t===0)this.r=this.g=this.b=n;else{let o=n<=.5?n*(1+t):n+t-n*t,l=2*n-o;this.r=rc(l,o,e+1/3),this.g=rc(l,o,e),this.b=rc(l,o,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=mn){function n(o){o!==void 0&&parseFloat(o)<1&&Qe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let o,l=s[1],h=s[2];switch(l){case"rgb":case"rgba":if(o=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setRGB(Math.min(255,parseInt(o[1],10))/255,Math.min(255,parseInt(o[2],10))/255,Math.min(255,parseInt(o[3],10))/255,t);if(o=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setRGB(Math.min(100,parseFloat(o[1]))/100,Math.min(100,parseFloat(o[2]))/100,Math.min(100,parseFloat(o[3]))/100,t);break;case"hsl":case"hsla":if(o=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setHSL(parseFloat(o[1])/360,parseFloat(o[2])/100,parseFloat(o[3])/100,t);break;default:Qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let o=s[1],l=o.length;if(l===3)return this.setRGB(parseInt(o.charAt(0),16)/15,parseInt(o.charAt(1),16)/15,parseInt(o.charAt(2),16)/15,t);if(l===6)return this.setHex(parseInt(o,16),t);Qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=mn){let n=Id[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=bi(e.r),this.g=bi(e.g),this.b=bi(e.b),this}copyLinearToSRGB(e){return this.r=Fr(e.r),this.g=Fr(e.g),this.b=Fr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=mn){return St.workingToColorSpace(pn.copy(this),e),Math.round(yt(pn.r*255,0,255))*65536+Math.round(yt(pn.g*255,0,255))*256+Math.round(yt(pn.b*255,0,255))}getHexString(e=mn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(pn.copy(this),t);let n=pn.r,s=pn.g,o=pn.b,l=Math.max(n,s,o),h=Math.min(n,s,o),f,d,m=(h+l)/2;if(h===l)f=0,d=0;else{let y=l-h;switch(d=m<=.5?y/(l+h):y/(2-l-h),l){case n:f=(s-o)/y+(s<o?6:0);break;case s:f=(o-n)/y+2;break;case o:f=(n-s)/y+4;break}f/=6}return e.h=f,e.s=d,e.l=m,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(pn.copy(this),t),e.r=pn.r,e.g=pn.g,e.b=pn.b,e}getStyle(e=mn){St.workingToColorSpace(pn.copy(this),e);let t=pn.r,n=pn.g,s=pn.b;return e!==mn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Fi),this.setHSL(Fi.h+e,Fi.s+t,Fi.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Fi),e.getHSL(Fa);let n=vs(Fi.h,Fa.h,t),s=vs(Fi.s,Fa.s,t),o=vs(Fi.l,Fa.l,t);return this.setHSL(n,s,o),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,o=e.elements;return this.r=o[0]*t+o[3]*n+o[6]*s,this.g=o[1]*t+o[4]*n+o[7]*s,this.b=o[2]*t+o[5]*n+o[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},pn=new ht;ht.NAMES=Id;var ws=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ht(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},cr=class extends Qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new oi,this.environmentIntensity=1,this.environmentRotation=new oi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Xn=new j,yi=new j,sc=new j,xi=new j,wr=new j,Er=new j,Au=new j,ac=new j,oc=new j,lc=new j,cc=new Gt,hc=new Gt,uc=new Gt,Bi=class i{constructor(e=new j,t=new j,n=new j){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Xn.subVectors(e,t),s.cross(Xn);let o=s.lengthSq();return o>0?s.multiplyScalar(1/Math.sqrt(o)):s.set(0,0,0)}static getBarycoord(e,t,n,s,o){Xn.subVectors(s,t),yi.subVectors(n,t),sc.subVectors(e,t);let l=Xn.dot(Xn),h=Xn.dot(yi),f=Xn.dot(sc),d=yi.dot(yi),m=yi.dot(sc),y=l*d-h*h;if(y===0)return o.set(0,0,0),null;let g=1/y,S=(d*f-h*m)*g,E=(l*m-h*f)*g;return o.set(1-S-E,E,S)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,xi)===null?!1:xi.x>=0&&xi.y>=0&&xi.x+xi.y<=1}static getInterpolation(e,t,n,s,o,l,h,f){return this.getBarycoord(e,t,n,s,xi)===null?(f.x=0,f.y=0,"z"in f&&(f.z=0),"w"in f&&(f.w=0),null):(f.setScalar(0),f.addScaledVector(o,xi.x),f.addScaledVector(l,xi.y),f.addScaledVector(h,xi.z),f)}static getInterpolatedAttribute(e,t,n,s,o,l){return cc.setScalar(0),hc.setScalar(0),uc.setScalar(0),cc.fromBufferAttribute(e,t),hc.fromBufferAttribute(e,n),uc.fromBufferAttribute(e,s),l.setScalar(0),l.addScaledVector(cc,o.x),l.addScaledVector(hc,o.y),l.addScaledVector(uc,o.z),l}static isFrontFacing(e,t,n,s){return Xn.subVectors(n,t),yi.subVectors(e,t),Xn.cross(yi).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Xn.subVectors(this.c,this.b),yi.subVectors(this.a,this.b),Xn.cross(yi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,o){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,o)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,o=this.c,l,h;wr.subVectors(s,n),Er.subVectors(o,n),ac.subVectors(e,n);let f=wr.dot(ac),d=Er.dot(ac);if(f<=0&&d<=0)return t.copy(n);oc.subVectors(e,s);let m=wr.dot(oc),y=Er.dot(oc);if(m>=0&&y<=m)return t.copy(s);let g=f*y-m*d;if(g<=0&&f>=0&&m<=0&&f-m>0)return l=f/(f-m),t.copy(n).addScaledVector(wr,l);lc.subVectors(e,o);let S=wr.dot(lc),E=Er.dot(lc);if(E>=0&&S<=E)return t.copy(o);let R=S*d-f*E;if(R<=0&&d>=0&&E<=0)return h=d/(d-E),t.copy(n).addScaledVector(Er,h);let x=m*E-S*y;if(x<=0&&y-m>=0&&S-E>=0)return Au.subVectors(o,s),h=(y-m)/(y-m+(S-E)),t.copy(s).addScaledVector(Au,h);let v=1/(x+R+g);return l=R*v,h=g*v,t.copy(n).addScaledVector(wr,l).addScaledVector(Er,h)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},li=class{constructor(e=new j(1/0,1/0,1/0),t=new j(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint($n.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint($n.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=$n.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let o=n.getAttribute("position");if(t===!0&&o!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let l=0,h=o.count;l<h;l++)e.isMesh===!0?e.getVertexPosition(l,$n):$n.fromBufferAttribute(o,l),$n.applyMatrix4(e.matrixWorld),this.expandByPoint($n);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Na.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Na.copy(n.boundingBox)),Na.applyMatrix4(e.matrixWorld),this.union(Na)}let s=e.children;for(let o=0,l=s.length;o<l;o++)this.expandByObject(s[o],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$n),$n.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(hs),Ua.subVectors(this.max,hs),Tr.subVectors(e.a,hs),Ar.subVectors(e.b,hs),Cr.subVectors(e.c,hs),Ni.subVectors(Ar,Tr),Ui.subVectors(Cr,Ar),sr.subVectors(Tr,Cr);let t=[0,-Ni.z,Ni.y,0,-Ui.z,Ui.y,0,-sr.z,sr.y,Ni.z,0,-Ni.x,Ui.z,0,-Ui.x,sr.z,0,-sr.x,-Ni.y,Ni.x,0,-Ui.y,Ui.x,0,-sr.y,sr.x,0];return!dc(t,Tr,Ar,Cr,Ua)||(t=[1,0,0,0,1,0,0,0,1],!dc(t,Tr,Ar,Cr,Ua))?!1:(Oa.crossVectors(Ni,Ui),t=[Oa.x,Oa.y,Oa.z],dc(t,Tr,Ar,Cr,Ua))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$n).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($n).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Si[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Si[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Si[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Si[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Si[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Si[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Si[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Si[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Si),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Si=[new j,new j,new j,new j,new j,new j,new j,new j],$n=new j,Na=new li,Tr=new j,Ar=new j,Cr=new j,Ni=new j,Ui=new j,sr=new j,hs=new j,Ua=new j,Oa=new j,ar=new j;function dc(i,e,t,n,s){for(let o=0,l=i.length-3;o<=l;o+=3){ar.fromArray(i,o);let h=s.x*Math.abs(ar.x)+s.y*Math.abs(ar.y)+s.z*Math.abs(ar.z),f=e.dot(ar),d=t.dot(ar),m=n.dot(ar);if(Math.max(-Math.max(f,d,m),Math.min(f,d,m))>h)return!1}return!0}var Yt=new j,Ba=new et,_v=0,In=class extends qn{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:_v++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=wd,this.updateRanges=[],this.gpuType=zn,this.version=0,this._normalizationScale=e!==void 0?nh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,o=this.itemSize;s<o;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ba.fromBufferAttribute(this,t),Ba.applyMatrix3(e),this.setXY(t,Ba.x,Ba.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix3(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix4(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyNormalMatrix(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.transformDirection(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,o){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),o=this._normalize(o)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=o,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Rd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Pd(e,this.array)}};var Es=class extends In{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ts=class extends In{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Xt=class extends In{constructor(e,t,n){super(new Float32Array(e),t,n)}},vv=new li,us=new j,fc=new j,Ei=class{constructor(e=new j,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):vv.setFromPoints(e).getCenter(n);let s=0;for(let o=0,l=e.length;o<l;o++)s=Math.max(s,n.distanceToSquared(e[o]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;us.subVectors(e,this.center);let t=us.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(us,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(fc.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(us.copy(e.center).add(fc)),this.expandByPoint(us.copy(e.center).sub(fc))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},yv=0,On=new Lt,pc=new Qt,Rr=new j,Rn=new li,ds=new li,ln=new j,wn=class i extends qn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:yv++}),this.uuid=Jr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(W0(e)?Ts:Es)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let o=new ct().getNormalMatrix(e);n.applyNormalMatrix(o),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return On.makeRotationFromQuaternion(e),this.applyMatrix4(On),this}rotateX(e){return On.makeRotationX(e),this.applyMatrix4(On),this}rotateY(e){return On.makeRotationY(e),this.applyMatrix4(On),this}rotateZ(e){return On.makeRotationZ(e),this.applyMatrix4(On),this}translate(e,t,n){return On.makeTranslation(e,t,n),this.applyMatrix4(On),this}scale(e,t,n){return On.makeScale(e,t,n),this.applyMatrix4(On),this}lookAt(e){return pc.lookAt(e),pc.updateMatrix(),this.applyMatrix4(pc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Rr).negate(),this.translate(Rr.x,Rr.y,Rr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,o=e.length;s<o;s++){let l=e[s];n.push(l.x,l.y,l.z||0)}this.setAttribute("position",new Xt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let o=e[s];t.setXYZ(s,o.x,o.y,o.z||0)}e.length>t.count&&Qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new li);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new j(-1/0,-1/0,-1/0),new j(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let o=t[n];Rn.setFromBufferAttribute(o),this.morphTargetsRelative?(ln.addVectors(this.boundingBox.min,Rn.min),this.boundingBox.expandByPoint(ln),ln.addVectors(this.boundingBox.max,Rn.max),this.boundingBox.expandByPoint(ln)):(this.boundingBox.expandByPoint(Rn.min),this.boundingBox.expandByPoint(Rn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ei);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new j,1/0);return}if(e){let n=this.boundingSphere.center;if(Rn.setFromBufferAttribute(e),t)for(let o=0,l=t.length;o<l;o++){let h=t[o];ds.setFromBufferAttribute(h),this.morphTargetsRelative?(ln.addVectors(Rn.min,ds.min),Rn.expandByPoint(ln),ln.addVectors(Rn.max,ds.max),Rn.expandByPoint(ln)):(Rn.expandByPoint(ds.min),Rn.expandByPoint(ds.max))}Rn.getCenter(n);let s=0;for(let o=0,l=e.count;o<l;o++)ln.fromBufferAttribute(e,o),s=Math.max(s,n.distanceToSquared(ln));if(t)for(let o=0,l=t.length;o<l;o++){let h=t[o],f=this.morphTargetsRelative;for(let d=0,m=h.count;d<m;d++)ln.fromBufferAttribute(h,d),f&&(Rr.fromBufferAttribute(e,d),ln.add(Rr)),s=Math.max(s,n.distanceToSquared(ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,o=t.uv,l=this.getAttribute("tangent");(l===void 0||l.count!==n.count)&&(l=new In(new Float32Array(4*n.count),4),this.setAttribute("tangent",l));let h=[],f=[],d=new Uint8Array(n.count);for(let q=0;q<n.count;q++)h[q]=new j,f[q]=new j;let m=new j,y=new j,g=new j,S=new et,E=new et,R=new et,x=new j,v=new j;function P(q,k,Y){d[q]=d[k]=d[Y]=1,m.fromBufferAttribute(n,q),y.fromBufferAttribute(n,k),g.fromBufferAttribute(n,Y),S.fromBufferAttribute(o,q),E.fromBufferAttribute(o,k),R.fromBufferAttribute(o,Y),y.sub(m),g.sub(m),E.sub(S),R.sub(S);let J=1/(E.x*R.y-R.x*E.y);isFinite(J)&&(x.copy(y).multiplyScalar(R.y).addScaledVector(g,-E.y).multiplyScalar(J),v.copy(g).multiplyScalar(E.x).addScaledVector(y,-R.x).multiplyScalar(J),h[q].add(x),h[k].add(x),h[Y].add(x),f[q].add(v),f[k].add(v),f[Y].add(v))}let U=this.groups;U.length===0&&(U=[{start:0,count:e.count}]);for(let q=0,k=U.length;q<k;++q){let Y=U[q],J=Y.start,ee=Y.count;for(let z=J,ie=J+ee;z<ie;z+=3)P(e.getX(z+0),e.getX(z+1),e.getX(z+2))}let I=new j,O=new j,N=new j,b=new j;function D(q){N.fromBufferAttribute(s,q),b.copy(N);let k=h[q];I.copy(k),I.sub(N.multiplyScalar(N.dot(k))).normalize(),O.crossVectors(b,k);let J=O.dot(f[q])<0?-1:1;l.setXYZW(q,I.x,I.y,I.z,J)}for(let q=0,k=n.count;q<k;++q)d[q]&&D(q);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new In(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let g=0,S=n.count;g<S;g++)n.setXYZ(g,0,0,0);let s=new j,o=new j,l=new j,h=new j,f=new j,d=new j,m=new j,y=new j;if(e)for(let g=0,S=e.count;g<S;g+=3){let E=e.getX(g+0),R=e.getX(g+1),x=e.getX(g+2);s.fromBufferAttribute(t,E),o.fromBufferAttribute(t,R),l.fromBufferAttribute(t,x),m.subVectors(l,o),y.subVectors(s,o),m.cross(y),h.fromBufferAttribute(n,E),f.fromBufferAttribute(n,R),d.fromBufferAttribute(n,x),h.add(m),f.add(m),d.add(m),n.setXYZ(E,h.x,h.y,h.z),n.setXYZ(R,f.x,f.y,f.z),n.setXYZ(x,d.x,d.y,d.z)}else for(let g=0,S=t.count;g<S;g+=3)s.fromBufferAttribute(t,g+0),o.fromBufferAttribute(t,g+1),l.fromBufferAttribute(t,g+2),m.subVectors(l,o),y.subVectors(s,o),m.cross(y),n.setXYZ(g+0,m.x,m.y,m.z),n.setXYZ(g+1,m.x,m.y,m.z),n.setXYZ(g+2,m.x,m.y,m.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)ln.fromBufferAttribute(e,t),ln.normalize(),e.setXYZ(t,ln.x,ln.y,ln.z)}toNonIndexed(){function e(h,f){let d=h.array,m=h.itemSize,y=h.normalized,g=new d.constructor(f.length*m),S=0,E=0;for(let R=0,x=f.length;R<x;R++){h.isInterleavedBufferAttribute?S=f[R]*h.data.stride+h.offset:S=f[R]*m;for(let v=0;v<m;v++)g[E++]=d[S++]}return new In(g,m,y)}if(this.index===null)return Qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let h in s){let f=s[h],d=e(f,n);t.setAttribute(h,d)}let o=this.morphAttributes;for(let h in o){let f=[],d=o[h];for(let m=0,y=d.length;m<y;m++){let g=d[m],S=e(g,n);f.push(S)}t.morphAttributes[h]=f}t.morphTargetsRelative=this.morphTargetsRelative;let l=this.groups;for(let h=0,f=l.length;h<f;h++){let d=l[h];t.addGroup(d.start,d.count,d.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let f=this.parameters;for(let d in f)f[d]!==void 0&&(e[d]=f[d]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let f in n){let d=n[f];e.data.attributes[f]=d.toJSON(e.data)}let s={},o=!1;for(let f in this.morphAttributes){let d=this.morphAttributes[f],m=[];for(let y=0,g=d.length;y<g;y++){let S=d[y];m.push(S.toJSON(e.data))}m.length>0&&(s[f]=m,o=!0)}o&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let l=this.groups;l.length>0&&(e.data.groups=JSON.parse(JSON.stringify(l)));let h=this.boundingSphere;return h!==null&&(e.data.boundingSphere=h.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let d in s){let m=s[d];this.setAttribute(d,m.clone(t))}let o=e.morphAttributes;for(let d in o){let m=[],y=o[d];for(let g=0,S=y.length;g<S;g++)m.push(y[g].clone(t));this.morphAttributes[d]=m}this.morphTargetsRelative=e.morphTargetsRelative;let l=e.groups;for(let d=0,m=l.length;d<m;d++){let y=l[d];this.addGroup(y.start,y.count,y.materialIndex)}let h=e.boundingBox;h!==null&&(this.boundingBox=h.clone());let f=e.boundingSphere;return f!==null&&(this.boundingSphere=f.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var mc=new j,xv=new j,Sv=new ct,Pn=class{constructor(e=new j(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=mc.subVectors(n,t).cross(xv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(mc),o=this.normal.dot(s);if(o===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let l=-(e.start.dot(this.normal)+this.constant)/o;return n===!0&&(l<0||l>1)?null:t.copy(e.start).addScaledVector(s,l)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Sv.getNormalMatrix(e),s=this.coplanarPoint(mc).applyMatrix4(e),o=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(o),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Mv=0,ci=class extends qn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Mv++}),this.uuid=Jr(),this.name="",this.type="Material",this.blending=Yr,this.side=qi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Fc,this.blendDst=Nc,this.blendEquation=dr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=Nr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=vd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=io,this.stencilZFail=io,this.stencilZPass=io,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Qe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(o=>o.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(o){let l=[];for(let h in o){let f=o[h];delete f.metadata,l.push(f)}return l}if(t){let o=s(e.textures),l=s(e.images);o.length>0&&(n.textures=o),l.length>0&&(n.images=l)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Pn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new et().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new et().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let o=0;o!==s;++o)n[o]=t[o].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Mi=new j,gc=new j,ka=new j,za=new j,ki=class{constructor(e=new j,t=new j(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Mi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Mi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Mi.copy(this.origin).addScaledVector(this.direction,t),Mi.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){gc.copy(e).add(t).multiplyScalar(.5),ka.copy(t).sub(e).normalize(),za.copy(this.origin).sub(gc);let o=e.distanceTo(t)*.5,l=-this.direction.dot(ka),h=za.dot(this.direction),f=-za.dot(ka),d=za.lengthSq(),m=Math.abs(1-l*l),y,g,S,E;if(m>0)if(y=l*f-h,g=l*h-f,E=o*m,y>=0)if(g>=-E)if(g<=E){let R=1/m;y*=R,g*=R,S=y*(y+l*g+2*h)+g*(l*y+g+2*f)+d}else g=o,y=Math.max(0,-(l*g+h)),S=-y*y+g*(g+2*f)+d;else g=-o,y=Math.max(0,-(l*g+h)),S=-y*y+g*(g+2*f)+d;else g<=-E?(y=Math.max(0,-(-l*o+h)),g=y>0?-o:Math.min(Math.max(-o,-f),o),S=-y*y+g*(g+2*f)+d):g<=E?(y=0,g=Math.min(Math.max(-o,-f),o),S=g*(g+2*f)+d):(y=Math.max(0,-(l*o+h)),g=y>0?o:Math.min(Math.max(-o,-f),o),S=-y*y+g*(g+2*f)+d);else g=l>0?-o:o,y=Math.max(0,-(l*g+h)),S=-y*y+g*(g+2*f)+d;return n&&n.copy(this.origin).addScaledVector(this.direction,y),s&&s.copy(gc).addScaledVector(ka,g),S}intersectSphere(e,t){if(e.radius<0)return null;Mi.subVectors(e.center,this.origin);let n=Mi.dot(this.direction),s=Mi.dot(Mi)-n*n,o=e.radius*e.radius;if(s>o)return null;let l=Math.sqrt(o-s),h=n-l,f=n+l;return f<0?null:h<0?this.at(f,t):this.at(h,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,o,l,h,f,d=1/this.direction.x,m=1/this.direction.y,y=1/this.direction.z,g=this.origin;return d>=0?(n=(e.min.x-g.x)*d,s=(e.max.x-g.x)*d):(n=(e.max.x-g.x)*d,s=(e.min.x-g.x)*d),m>=0?(o=(e.min.y-g.y)*m,l=(e.max.y-g.y)*m):(o=(e.max.y-g.y)*m,l=(e.min.y-g.y)*m),n>l||o>s||((o>n||isNaN(n))&&(n=o),(l<s||isNaN(s))&&(s=l),y>=0?(h=(e.min.z-g.z)*y,f=(e.max.z-g.z)*y):(h=(e.max.z-g.z)*y,f=(e.min.z-g.z)*y),n>f||h>s)||((h>n||n!==n)&&(n=h),(f<s||s!==s)&&(s=f),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Mi)!==null}intersectTriangle(e,t,n,s,o){let l=this.origin,h=this.direction,f=h.x,d=h.y,m=h.z,y=e.x-l.x,g=e.y-l.y,S=e.z-l.z,E=t.x-l.x,R=t.y-l.y,x=t.z-l.z,v=n.x-l.x,P=n.y-l.y,U=n.z-l.z,I=Math.abs(f),O=Math.abs(d),N=Math.abs(m),b,D,q,k,Y,J,ee,z,ie,G,ne,Se;if(I>=O&&I>=N?(q=f,J=y,ie=E,Se=v,f>=0?(b=d,D=m,k=g,Y=S,ee=R,z=x,G=P,ne=U):(b=m,D=d,k=S,Y=g,ee=x,z=R,G=U,ne=P)):O>=N?(q=d,J=g,ie=R,Se=P,d>=0?(b=m,D=f,k=S,Y=y,ee=x,z=E,G=U,ne=v):(b=f,D=m,k=y,Y=S,ee=E,z=x,G=v,ne=U)):(q=m,J=S,ie=x,Se=U,m>=0?(b=f,D=d,k=y,Y=g,ee=E,z=R,G=v,ne=P):(b=d,D=f,k=g,Y=y,ee=R,z=E,G=P,ne=v)),q===0)return null;let re=b/q,H=D/q,ge=1/q,We=k-re*J,it=Y-H*J,ue=ee-re*ie,Fe=z-H*ie,Pe=G-re*Se,je=ne-H*Se,Ue=Pe*Fe-je*ue,ot=We*je-it*Pe,Vt=ue*it-Fe*We;if(s){if(Ue<0||ot<0||Vt<0)return null}else if((Ue<0||ot<0||Vt<0)&&(Ue>0||ot>0||Vt>0))return null;let Ke=Ue+ot+Vt;if(Ke===0)return null;let Et=ge*(Ue*J+ot*ie+Vt*Se);return(Ke>0?Et<0:Et>0)?null:this.at(Et/Ke,o)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},As=class extends ci{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new oi,this.combine=Uo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Cu=new Lt,or=new ki,Ga=new Ei,Ru=new j,Va=new j,Ha=new j,Wa=new j,_c=new j,Xa=new j,Pu=new j,$a=new j,zt=class extends Qt{constructor(e=new wn,t=new As){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,l=s.length;o<l;o++){let h=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[h]=o}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,o=n.morphAttributes.position,l=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let h=this.morphTargetInfluences;if(o&&h){Xa.set(0,0,0);for(let f=0,d=o.length;f<d;f++){let m=h[f],y=o[f];m!==0&&(_c.fromBufferAttribute(y,e),l?Xa.addScaledVector(_c,m):Xa.addScaledVector(_c.sub(t),m))}t.add(Xa)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,o=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ga.copy(n.boundingSphere),Ga.applyMatrix4(o),or.copy(e.ray).recast(e.near),!(Ga.containsPoint(or.origin)===!1&&(or.intersectSphere(Ga,Ru)===null||or.origin.distanceToSquared(Ru)>(e.far-e.near)**2))&&(Cu.copy(o).invert(),or.copy(e.ray).applyMatrix4(Cu),!(n.boundingBox!==null&&or.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,or)))}_computeIntersections(e,t,n){let s,o=this.geometry,l=this.material,h=o.index,f=o.attributes.position,d=o.attributes.uv,m=o.attributes.uv1,y=o.attributes.normal,g=o.groups,S=o.drawRange;if(h!==null)if(Array.isArray(l))for(let E=0,R=g.length;E<R;E++){let x=g[E],v=l[x.materialIndex],P=Math.max(x.start,S.start),U=Math.min(h.count,Math.min(x.start+x.count,S.start+S.count));for(let I=P,O=U;I<O;I+=3){let N=h.getX(I),b=h.getX(I+1),D=h.getX(I+2);s=qa(this,v,e,n,d,m,y,N,b,D),s&&(s.faceIndex=Math.floor(I/3),s.face.materialIndex=x.materialIndex,t.push(s))}}else{let E=Math.max(0,S.start),R=Math.min(h.count,S.start+S.count);for(let x=E,v=R;x<v;x+=3){let P=h.getX(x),U=h.getX(x+1),I=h.getX(x+2);s=qa(this,l,e,n,d,m,y,P,U,I),s&&(s.faceIndex=Math.floor(x/3),t.push(s))}}else if(f!==void 0)if(Array.isArray(l))for(let E=0,R=g.length;E<R;E++){let x=g[E],v=l[x.materialIndex],P=Math.max(x.start,S.start),U=Math.min(f.count,Math.min(x.start+x.count,S.start+S.count));for(let I=P,O=U;I<O;I+=3){let N=I,b=I+1,D=I+2;s=qa(this,v,e,n,d,m,y,N,b,D),s&&(s.faceIndex=Math.floor(I/3),s.face.materialIndex=x.materialIndex,t.push(s))}}else{let E=Math.max(0,S.start),R=Math.min(f.count,S.start+S.count);for(let x=E,v=R;x<v;x+=3){let P=x,U=x+1,I=x+2;s=qa(this,l,e,n,d,m,y,P,U,I),s&&(s.faceIndex=Math.floor(x/3),t.push(s))}}}};function bv(i,e,t,n,s,o,l,h){let f;if(e.side===dn?f=n.intersectTriangle(l,o,s,!0,h):f=n.intersectTriangle(s,o,l,e.side===qi,h),f===null)return null;$a.copy(h),$a.applyMatrix4(i.matrixWorld);let d=t.ray.origin.distanceTo($a);return d<t.near||d>t.far?null:{distance:d,point:$a.clone(),object:i}}function qa(i,e,t,n,s,o,l,h,f,d){i.getVertexPosition(h,Va),i.getVertexPosition(f,Ha),i.getVertexPosition(d,Wa);let m=bv(i,e,t,n,Va,Ha,Wa,Pu);if(m){let y=new j;Bi.getBarycoord(Pu,Va,Ha,Wa,y),s&&(m.uv=Bi.getInterpolatedAttribute(s,h,f,d,y,new et)),o&&(m.uv1=Bi.getInterpolatedAttribute(o,h,f,d,y,new et)),l&&(m.normal=Bi.getInterpolatedAttribute(l,h,f,d,y,new j),m.normal.dot(n.direction)>0&&m.normal.multiplyScalar(-1));let g={a:h,b:f,c:d,normal:new j,materialIndex:0};Bi.getNormal(Va,Ha,Wa,g.normal),m.face=g,m.barycoord=y}return m}var Cs=class extends bn{constructor(e=null,t=1,n=1,s,o,l,h,f,d=cn,m=cn,y,g){super(null,l,h,f,d,m,s,o,y,g),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Rs=class extends In{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Pr=new Lt,Iu=new Lt,Ya=[],Du=new li,wv=new Lt,fs=new zt,ps=new Ei,Ps=class extends zt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Rs(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,wv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new li),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Pr),Du.copy(e.boundingBox).applyMatrix4(Pr),this.boundingBox.union(Du)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ei),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Pr),ps.copy(e.boundingSphere).applyMatrix4(Pr),this.boundingSphere.union(ps)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,o=n.length+1,l=e*o+1;for(let h=0;h<n.length;h++)n[h]=s[l+h]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(fs.geometry=this.geometry,fs.material=this.material,fs.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ps.copy(this.boundingSphere),ps.applyMatrix4(n),e.ray.intersectsSphere(ps)!==!1))for(let o=0;o<s;o++){this.getMatrixAt(o,Pr),Iu.multiplyMatrices(n,Pr),fs.matrixWorld=Iu,fs.raycast(e,Ya);for(let l=0,h=Ya.length;l<h;l++){let f=Ya[l];f.instanceId=o,f.object=this,t.push(f)}Ya.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Rs(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Cs(new Float32Array(s*this.count),s,this.count,Ho,zn));let o=this.morphTexture.source.data.data,l=0;for(let d=0;d<n.length;d++)l+=n[d];let h=this.geometry.morphTargetsRelative?1:1-l,f=s*e;return o[f]=h,o.set(n,f+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},lr=new Ei,Ev=new et(.5,.5),ja=new j,zi=class{constructor(e=new Pn,t=new Pn,n=new Pn,s=new Pn,o=new Pn,l=new Pn){this.planes=[e,t,n,s,o,l]}set(e,t,n,s,o,l){let h=this.planes;return h[0].copy(e),h[1].copy(t),h[2].copy(n),h[3].copy(s),h[4].copy(o),h[5].copy(l),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Bn,n=!1){let s=this.planes,o=e.elements,l=o[0],h=o[1],f=o[2],d=o[3],m=o[4],y=o[5],g=o[6],S=o[7],E=o[8],R=o[9],x=o[10],v=o[11],P=o[12],U=o[13],I=o[14],O=o[15];if(s[0].setComponents(d-l,S-m,v-E,O-P).normalize(),s[1].setComponents(d+l,S+m,v+E,O+P).normalize(),s[2].setComponents(d+h,S+y,v+R,O+U).normalize(),s[3].setComponents(d-h,S-y,v-R,O-U).normalize(),n)s[4].setComponents(f,g,x,I).normalize(),s[5].setComponents(d-f,S-g,v-x,O-I).normalize();else if(s[4].setComponents(d-f,S-g,v-x,O-I).normalize(),t===Bn)s[5].setComponents(d+f,S+g,v+x,O+I).normalize();else if(t===Or)s[5].setComponents(f,g,x,I).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),lr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),lr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(lr)}intersectsSprite(e){lr.center.set(0,0,0);let t=Ev.distanceTo(e.center);return lr.radius=.7071067811865476+t,lr.applyMatrix4(e.matrixWorld),this.intersectsSphere(lr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let o=0;o<6;o++)if(t[o].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(ja.x=s.normal.x>0?e.max.x:e.min.x,ja.y=s.normal.y>0?e.max.y:e.min.y,ja.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ja)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Lu=new Lt,_o=class i{constructor(){this.coordinateSystem=Bn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let o=t[s];Lu.multiplyMatrices(o.projectionMatrix,o.matrixWorldInverse),n[s]===void 0&&(n[s]=new zi),n[s].setFromProjectionMatrix(Lu,o.coordinateSystem,o.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new zi),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Is=class extends ci{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},vo=new j,yo=new j,Fu=new Lt,ms=new ki,Za=new Ei,vc=new j,Nu=new j,xo=class extends Qt{constructor(e=new wn,t=new Is){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,o=t.count;s<o;s++)vo.fromBufferAttribute(t,s-1),yo.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=vo.distanceTo(yo);e.setAttribute("lineDistance",new Xt(n,1))}else Qe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,o=e.params.Line.threshold,l=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Za.copy(n.boundingSphere),Za.applyMatrix4(s),Za.radius+=o,e.ray.intersectsSphere(Za)===!1)return;Fu.copy(s).invert(),ms.copy(e.ray).applyMatrix4(Fu);let h=o/((this.scale.x+this.scale.y+this.scale.z)/3),f=h*h,d=this.isLineSegments?2:1,m=n.index,g=n.attributes.position;if(m!==null){let S=Math.max(0,l.start),E=Math.min(m.count,l.start+l.count);for(let R=S,x=E-1;R<x;R+=d){let v=m.getX(R),P=m.getX(R+1),U=Ja(this,e,ms,f,v,P,R);U&&t.push(U)}if(this.isLineLoop){let R=m.getX(E-1),x=m.getX(S),v=Ja(this,e,ms,f,R,x,E-1);v&&t.push(v)}}else{let S=Math.max(0,l.start),E=Math.min(g.count,l.start+l.count);for(let R=S,x=E-1;R<x;R+=d){let v=Ja(this,e,ms,f,R,R+1,R);v&&t.push(v)}if(this.isLineLoop){let R=Ja(this,e,ms,f,E-1,S,E-1);R&&t.push(R)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,l=s.length;o<l;o++){let h=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[h]=o}}}}};function Ja(i,e,t,n,s,o,l){let h=i.geometry.attributes.position;if(vo.fromBufferAttribute(h,s),yo.fromBufferAttribute(h,o),t.distanceSqToSegment(vo,yo,vc,Nu)>n)return;vc.applyMatrix4(i.matrixWorld);let d=e.ray.origin.distanceTo(vc);if(!(d<e.near||d>e.far))return{distance:d,point:Nu.clone().applyMatrix4(i.matrixWorld),index:l,face:null,faceIndex:null,barycoord:null,object:i}}var Ds=class extends bn{constructor(e=[],t=fr,n,s,o,l,h,f,d,m){super(e,t,n,s,o,l,h,f,d,m),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Ls=class extends bn{constructor(e,t,n,s,o,l,h,f,d){super(e,t,n,s,o,l,h,f,d),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ti=class extends bn{constructor(e,t,n=Yn,s,o,l,h=cn,f=cn,d,m=wi,y=1){if(m!==wi&&m!==Ri)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let g={width:e,height:t,depth:y};super(g,s,o,l,h,f,m,n,d),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new zr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Fs=class extends Ti{constructor(e,t=Yn,n=fr,s,o,l=cn,h=cn,f,d=wi){let m={width:e,height:e,depth:1},y=[m,m,m,m,m,m];super(e,e,t,n,s,o,l,h,f,d),this.image=y,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ns=class extends bn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},hi=class i extends wn{constructor(e=1,t=1,n=1,s=1,o=1,l=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:o,depthSegments:l};let h=this;s=Math.floor(s),o=Math.floor(o),l=Math.floor(l);let f=[],d=[],m=[],y=[],g=0,S=0;E("z","y","x",-1,-1,n,t,e,l,o,0),E("z","y","x",1,-1,n,t,-e,l,o,1),E("x","z","y",1,1,e,n,t,s,l,2),E("x","z","y",1,-1,e,n,-t,s,l,3),E("x","y","z",1,-1,e,t,n,s,o,4),E("x","y","z",-1,-1,e,t,-n,s,o,5),this.setIndex(f),this.setAttribute("position",new Xt(d,3)),this.setAttribute("normal",new Xt(m,3)),this.setAttribute("uv",new Xt(y,2));function E(R,x,v,P,U,I,O,N,b,D,q){let k=I/b,Y=O/D,J=I/2,ee=O/2,z=N/2,ie=b+1,G=D+1,ne=0,Se=0,re=new j;for(let H=0;H<G;H++){let ge=H*Y-ee;for(let We=0;We<ie;We++){let it=We*k-J;re[R]=it*P,re[x]=ge*U,re[v]=z,d.push(re.x,re.y,re.z),re[R]=0,re[x]=0,re[v]=N>0?1:-1,m.push(re.x,re.y,re.z),y.push(We/b),y.push(1-H/D),ne+=1}}for(let H=0;H<D;H++)for(let ge=0;ge<b;ge++){let We=g+ge+ie*H,it=g+ge+ie*(H+1),ue=g+(ge+1)+ie*(H+1),Fe=g+(ge+1)+ie*H;f.push(We,it,Fe),f.push(it,ue,Fe),Se+=6}h.addGroup(S,Se,q),S+=Se,g+=ne}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},Us=class i extends wn{constructor(e=1,t=1,n=4,s=8,o=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:s,heightSegments:o},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),o=Math.max(1,Math.floor(o));let l=[],h=[],f=[],d=[],m=t/2,y=Math.PI/2*e,g=t,S=2*y+g,E=n*2+o,R=s+1,x=new j,v=new j;for(let P=0;P<=E;P++){let U=0,I=0,O=0,N=0;if(P<=n){let q=P/n,k=q*Math.PI/2;I=-m-e*Math.cos(k),O=e*Math.sin(k),N=-e*Math.cos(k),U=q*y}else if(P<=n+o){let q=(P-n)/o;I=-m+q*t,O=e,N=0,U=y+q*g}else{let q=(P-n-o)/n,k=q*Math.PI/2;I=m+e*Math.sin(k),O=e*Math.cos(k),N=e*Math.sin(k),U=y+g+q*y}let b=Math.max(0,Math.min(1,U/S)),D=0;P===0?D=.5/s:P===E&&(D=-.5/s);for(let q=0;q<=s;q++){let k=q/s,Y=k*Math.PI*2,J=Math.sin(Y),ee=Math.cos(Y);v.x=-O*ee,v.y=I,v.z=O*J,h.push(v.x,v.y,v.z),x.set(-O*ee,N,O*J),x.normalize(),f.push(x.x,x.y,x.z),d.push(k+D,b)}if(P>0){let q=(P-1)*R;for(let k=0;k<s;k++){let Y=q+k,J=q+k+1,ee=P*R+k,z=P*R+k+1;l.push(Y,J,ee),l.push(J,z,ee)}}}this.setIndex(l),this.setAttribute("position",new Xt(h,3)),this.setAttribute("normal",new Xt(f,3)),this.setAttribute("uv",new Xt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var Hr=class i extends wn{constructor(e=1,t=1,n=1,s=32,o=1,l=!1,h=0,f=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:o,openEnded:l,thetaStart:h,thetaLength:f};let d=this;s=Math.floor(s),o=Math.floor(o);let m=[],y=[],g=[],S=[],E=0,R=[],x=n/2,v=0;P(),l===!1&&(e>0&&U(!0),t>0&&U(!1)),this.setIndex(m),this.setAttribute("position",new Xt(y,3)),this.setAttribute("normal",new Xt(g,3)),this.setAttribute("uv",new Xt(S,2));function P(){let I=new j,O=new j,N=0,b=(t-e)/n;for(let D=0;D<=o;D++){let q=[],k=D/o,Y=k*(t-e)+e;for(let J=0;J<=s;J++){let ee=J/s,z=ee*f+h,ie=Math.sin(z),G=Math.cos(z);O.x=Y*ie,O.y=-k*n+x,O.z=Y*G,y.push(O.x,O.y,O.z),I.set(ie,b,G).normalize(),g.push(I.x,I.y,I.z),S.push(ee,1-k),q.push(E++)}R.push(q)}for(let D=0;D<s;D++)for(let q=0;q<o;q++){let k=R[q][D],Y=R[q+1][D],J=R[q+1][D+1],ee=R[q][D+1];(e>0||q!==0)&&(m.push(k,Y,ee),N+=3),(t>0||q!==o-1)&&(m.push(Y,J,ee),N+=3)}d.addGroup(v,N,0),v+=N}function U(I){let O=E,N=new et,b=new j,D=0,q=I===!0?e:t,k=I===!0?1:-1;for(let J=1;J<=s;J++)y.push(0,x*k,0),g.push(0,k,0),S.push(.5,.5),E++;let Y=E;for(let J=0;J<=s;J++){let z=J/s*f+h,ie=Math.cos(z),G=Math.sin(z);b.x=q*G,b.y=x*k,b.z=q*ie,y.push(b.x,b.y,b.z),g.push(0,k,0),N.x=ie*.5+.5,N.y=G*.5*k+.5,S.push(N.x,N.y),E++}for(let J=0;J<s;J++){let ee=O+J,z=Y+J;I===!0?m.push(z,z+1,ee):m.push(z+1,z,ee),D+=3}d.addGroup(v,D,I===!0?1:2),v+=D}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},So=class i extends Hr{constructor(e=1,t=1,n=32,s=1,o=!1,l=0,h=Math.PI*2){super(0,e,t,n,s,o,l,h),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:o,thetaStart:l,thetaLength:h}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Gi=class i extends wn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let o=e/2,l=t/2,h=Math.floor(n),f=Math.floor(s),d=h+1,m=f+1,y=e/h,g=t/f,S=[],E=[],R=[],x=[];for(let v=0;v<m;v++){let P=v*g-l;for(let U=0;U<d;U++){let I=U*y-o;E.push(I,-P,0),R.push(0,0,1),x.push(U/h),x.push(1-v/f)}}for(let v=0;v<f;v++)for(let P=0;P<h;P++){let U=P+d*v,I=P+d*(v+1),O=P+1+d*(v+1),N=P+1+d*v;S.push(U,I,N),S.push(I,O,N)}this.setIndex(S),this.setAttribute("position",new Xt(E,3)),this.setAttribute("normal",new Xt(R,3)),this.setAttribute("uv",new Xt(x,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Wr=class i extends wn{constructor(e=1,t=32,n=16,s=0,o=Math.PI*2,l=0,h=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:o,thetaStart:l,thetaLength:h},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let f=Math.min(l+h,Math.PI),d=0,m=[],y=new j,g=new j,S=[],E=[],R=[],x=[];for(let v=0;v<=n;v++){let P=[],U=v/n,I=l+U*h,O=e*Math.cos(I),N=Math.sqrt(e*e-O*O),b=0;v===0&&l===0?b=.5/t:v===n&&f===Math.PI&&(b=-.5/t);for(let D=0;D<=t;D++){let q=D/t,k=s+q*o;y.x=-N*Math.cos(k),y.y=O,y.z=N*Math.sin(k),E.push(y.x,y.y,y.z),g.copy(y).normalize(),R.push(g.x,g.y,g.z),x.push(q+b,1-U),P.push(d++)}m.push(P)}for(let v=0;v<n;v++)for(let P=0;P<t;P++){let U=m[v][P+1],I=m[v][P],O=m[v+1][P],N=m[v+1][P+1];(v!==0||l>0)&&S.push(U,I,N),(v!==n-1||f<Math.PI)&&S.push(I,O,N)}this.setIndex(S),this.setAttribute("position",new Xt(E,3)),this.setAttribute("normal",new Xt(R,3)),this.setAttribute("uv",new Xt(x,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function mr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Uu(s))s.isRenderTargetTexture?(Qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Uu(s[0])){let o=[];for(let l=0,h=s.length;l<h;l++)o[l]=s[l].clone();e[t][n]=o}else e[t][n]=s.slice();else e[t][n]=s}}return e}function _n(i){let e={};for(let t=0;t<i.length;t++){let n=mr(i[t]);for(let s in n)e[s]=n[s]}return e}function Uu(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Tv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function rh(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Dd={clone:mr,merge:_n},Av=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Cv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ui=class extends ci{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Av,this.fragmentShader=Cv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=mr(e.uniforms),this.uniformsGroups=Tv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let l=this.uniforms[s].value;l&&l.isTexture?t.uniforms[s]={type:"t",value:l.toJSON(e).uuid}:l&&l.isColor?t.uniforms[s]={type:"c",value:l.getHex()}:l&&l.isVector2?t.uniforms[s]={type:"v2",value:l.toArray()}:l&&l.isVector3?t.uniforms[s]={type:"v3",value:l.toArray()}:l&&l.isVector4?t.uniforms[s]={type:"v4",value:l.toArray()}:l&&l.isMatrix3?t.uniforms[s]={type:"m3",value:l.toArray()}:l&&l.isMatrix4?t.uniforms[s]={type:"m4",value:l.toArray()}:t.uniforms[s]={value:l}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ht().setHex(s.value);break;case"v2":this.uniforms[n].value=new et().fromArray(s.value);break;case"v3":this.uniforms[n].value=new j().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Gt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ct().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Lt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Mo=class extends ui{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ai=class extends ci{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=na,this.normalScale=new et(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new oi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Os=class extends ci{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=na,this.normalScale=new et(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new oi,this.combine=Uo,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},bo=class extends ci{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=gd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},wo=class extends ci{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ir(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ka(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Vi=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],o=t[n-1];e:{t:{let l;n:{i:if(!(e<s)){for(let h=n+2;;){if(s===void 0){if(e<o)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===h)break;if(o=s,s=t[++n],e<s)break t}l=t.length;break n}if(!(e>=o)){let h=t[1];e<h&&(n=2,o=h);for(let f=n-2;;){if(o===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===f)break;if(s=o,o=t[--n-1],e>=o)break t}l=n,n=0;break n}break e}for(;n<l;){let h=n+l>>>1;e<t[h]?l=h:n=h+1}if(s=t[n],o=t[n-1],o===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,o,s)}return this.interpolate_(n,o,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,o=e*s;for(let l=0;l!==s;++l)t[l]=n[o+l];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Eo=class extends Vi{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Mc,endingEnd:Mc}}intervalChanged_(e,t,n){let s=this.parameterPositions,o=e-2,l=e+1,h=s[o],f=s[l];if(h===void 0)switch(this.getSettings_().endingStart){case bc:o=e,h=2*t-n;break;case wc:o=s.length-2,h=t+s[o]-s[o+1];break;default:o=e,h=n}if(f===void 0)switch(this.getSettings_().endingEnd){case bc:l=e,f=2*n-t;break;case wc:l=1,f=n+s[1]-s[0];break;default:l=e-1,f=t}let d=(n-t)*.5,m=this.valueSize;this._weightPrev=d/(t-h),this._weightNext=d/(f-n),this._offsetPrev=o*m,this._offsetNext=l*m}interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=this._offsetPrev,y=this._offsetNext,g=this._weightPrev,S=this._weightNext,E=(n-t)/(s-t),R=E*E,x=R*E,v=-g*x+2*g*R-g*E,P=(1+g)*x+(-1.5-2*g)*R+(-.5+g)*E+1,U=(-1-S)*x+(1.5+S)*R+.5*E,I=S*x-S*R;for(let O=0;O!==h;++O)o[O]=v*l[m+O]+P*l[d+O]+U*l[f+O]+I*l[y+O];return o}},To=class extends Vi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=(n-t)/(s-t),y=1-m;for(let g=0;g!==h;++g)o[g]=l[d+g]*y+l[f+g]*m;return o}},Ao=class extends Vi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Co=class extends Vi{interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=this.inTangents,y=this.outTangents;if(!m||!y){let E=(n-t)/(s-t),R=1-E;for(let x=0;x!==h;++x)o[x]=l[d+x]*R+l[f+x]*E;return o}let g=h*2,S=e-1;for(let E=0;E!==h;++E){let R=l[d+E],x=l[f+E],v=S*g+E*2,P=y[v],U=y[v+1],I=e*g+E*2,O=m[I],N=m[I+1],b=Pv(n,t,P,O,s);o[E]=Ld(b,R,U,N,x)}return o}};function Ld(i,e,t,n,s){let o=1-i;return o*o*o*e+3*o*o*i*t+3*o*i*i*n+i*i*i*s}function Rv(i,e,t,n,s){let o=1-i;return 3*o*o*(t-e)+6*o*i*(n-t)+3*i*i*(s-n)}function Pv(i,e,t,n,s){let o=(i-e)/(s-e);for(let l=0;l<8;l++){let h=Ld(o,e,t,n,s)-i;if(Math.abs(h)<1e-10)break;let f=Rv(o,e,t,n,s);if(Math.abs(f)<1e-10)break;o=Math.max(0,Math.min(1,o-h/f))}return o}var Ln=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ir(t,this.TimeBufferType),this.values=Ir(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ir(e.times,Array),values:Ir(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Ka(e.settings)&&(n.settings={inTangents:Ir(e.settings.inTangents,Array),outTangents:Ir(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ao(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new To(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Eo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Co(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ys:t=this.InterpolantFactoryMethodDiscrete;break;case fo:t=this.InterpolantFactoryMethodLinear;break;case no:t=this.InterpolantFactoryMethodSmooth;break;case Sc:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ys;case this.InterpolantFactoryMethodLinear:return fo;case this.InterpolantFactoryMethodSmooth:return no;case this.InterpolantFactoryMethodBezier:return Sc}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Ka(this.settings)&&(Ou(this.settings.inTangents,e),Ou(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Ka(this.settings)&&(Bu(this.settings.inTangents,e),Bu(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,o=0,l=s-1;for(;o!==s&&n[o]<e;)++o;for(;l!==-1&&n[l]>t;)--l;if(++l,o!==0||l!==s){o>=l&&(l=Math.max(l,1),o=l-1);let h=this.getValueSize();this.times=n.slice(o,l),this.values=this.values.slice(o*h,l*h)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,o=n.length;o===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let l=null;for(let h=0;h!==o;h++){let f=n[h];if(typeof f=="number"&&isNaN(f)){nt("KeyframeTrack: Time is not a valid number.",this,h,f),e=!1;break}if(l!==null&&l>f){nt("KeyframeTrack: Out of order keys.",this,h,f,l),e=!1;break}l=f}if(s!==void 0&&X0(s))for(let h=0,f=s.length;h!==f;++h){let d=s[h];if(isNaN(d)){nt("KeyframeTrack: Value is not a valid number.",this,h,d),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===no,o=e.length-1,l=1;for(let h=1;h<o;++h){let f=!1,d=e[h],m=e[h+1];if(d!==m&&(h!==1||d!==e[0]))if(s)f=!0;else{let y=h*n,g=y-n,S=y+n;for(let E=0;E!==n;++E){let R=t[y+E];if(R!==t[g+E]||R!==t[S+E]){f=!0;break}}}if(f){if(h!==l){e[l]=e[h];let y=h*n,g=l*n;for(let S=0;S!==n;++S)t[g+S]=t[y+S]}++l}}if(o>0){e[l]=e[o];for(let h=o*n,f=l*n,d=0;d!==n;++d)t[f+d]=t[h+d];++l}return l!==e.length?(this.times=e.slice(0,l),this.values=t.slice(0,l*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ka(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Ou(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Bu(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Ln.prototype.ValueTypeName="";Ln.prototype.TimeBufferType=Float32Array;Ln.prototype.ValueBufferType=Float32Array;Ln.prototype.DefaultInterpolation=fo;var Hi=class extends Ln{constructor(e,t,n){super(e,t,n)}};Hi.prototype.ValueTypeName="bool";Hi.prototype.ValueBufferType=Array;Hi.prototype.DefaultInterpolation=ys;Hi.prototype.InterpolantFactoryMethodLinear=void 0;Hi.prototype.InterpolantFactoryMethodSmooth=void 0;var Ro=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}};Ro.prototype.ValueTypeName="color";var Po=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}};Po.prototype.ValueTypeName="number";var Io=class extends Vi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=(n-t)/(s-t),d=e*h;for(let m=d+h;d!==m;d+=4)Mn.slerpFlat(o,0,l,d-h,l,d,f);return o}},Bs=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Io(this.times,this.values,this.getValueSize(),e)}};Bs.prototype.ValueTypeName="quaternion";Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Wi=class extends Ln{constructor(e,t,n){super(e,t,n)}};Wi.prototype.ValueTypeName="string";Wi.prototype.ValueBufferType=Array;Wi.prototype.DefaultInterpolation=ys;Wi.prototype.InterpolantFactoryMethodLinear=void 0;Wi.prototype.InterpolantFactoryMethodSmooth=void 0;var Do=class extends Ln{constructor(e,t,n,s){super(e,t,n,s)}};Do.prototype.ValueTypeName="vector";var Lo=class{constructor(e,t,n){let s=this,o=!1,l=0,h=0,f,d=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(m){h++,o===!1&&s.onStart!==void 0&&s.onStart(m,l,h),o=!0},this.itemEnd=function(m){l++,s.onProgress!==void 0&&s.onProgress(m,l,h),l===h&&(o=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(m){s.onError!==void 0&&s.onError(m)},this.resolveURL=function(m){return m=m.normalize("NFC"),f?f(m):m},this.setURLModifier=function(m){return f=m,this},this.addHandler=function(m,y){return d.push(m,y),this},this.removeHandler=function(m){let y=d.indexOf(m);return y!==-1&&d.splice(y,2),this},this.getHandler=function(m){for(let y=0,g=d.length;y<g;y+=2){let S=d[y],E=d[y+1];if(S.global&&(S.lastIndex=0),S.test(m))return E}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Fd=new Lo,Fo=class{constructor(e){this.manager=e!==void 0?e:Fd,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,o){n.load(e,s,t,o)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Fo.DEFAULT_MATERIAL_NAME="__DEFAULT";var ks=class extends Qt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var yc=new Lt,ku=new j,zu=new j,zs=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new et(512,512),this.mapType=En,this.map=null,this.mapPass=null,this.matrix=new Lt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new zi,this._frameExtents=new et(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;ku.setFromMatrixPosition(e.matrixWorld),t.position.copy(ku),zu.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(zu),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){yc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(yc,e.coordinateSystem,e.reversedDepth);let o=this._frameExtents,l=s?s.z/o.x:1,h=s?s.w/o.y:1,f=s?s.x/o.x:0,d=s?s.y/o.y:0;e.coordinateSystem===Or||e.reversedDepth?t.set(.5*l,0,0,.5*l+f,0,.5*h,0,.5*h+d,0,0,1,0,0,0,0,1):t.set(.5*l,0,0,.5*l+f,0,.5*h,0,.5*h+d,0,0,.5,.5,0,0,0,1),t.multiply(yc)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Qa=new j,eo=new Mn,si=new j,Gs=class extends Qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Lt,this.projectionMatrix=new Lt,this.projectionMatrixInverse=new Lt,this.coordinateSystem=Bn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Qa,eo,si),si.x===1&&si.y===1&&si.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Qa,eo,si.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Qa,eo,si),si.x===1&&si.y===1&&si.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Qa,eo,si.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Oi=new j,Gu=new et,Vu=new et,gn=class extends Gs{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=kr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(_s*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return kr*2*Math.atan(Math.tan(_s*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Oi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Oi.x,Oi.y).multiplyScalar(-e/Oi.z),Oi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Oi.x,Oi.y).multiplyScalar(-e/Oi.z)}getViewSize(e,t){return this.getViewBounds(e,Gu,Vu),t.subVectors(Vu,Gu)}setViewOffset(e,t,n,s,o,l){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(_s*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,o=-.5*s,l=this.view;if(this.view!==null&&this.view.enabled){let f=l.fullWidth,d=l.fullHeight;o+=l.offsetX*s/f,t-=l.offsetY*n/d,s*=l.width/f,n*=l.height/d}let h=this.filmOffset;h!==0&&(o+=e*h/this.getFilmWidth()),this.projectionMatrix.makePerspective(o,o+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ec=class extends zs{constructor(){super(new gn(90,1,.5,500)),this.isPointLightShadow=!0}},Vs=class extends ks{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new Ec}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Hs=class extends Gs{constructor(e=-1,t=1,n=1,s=-1,o=.1,l=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=o,this.far=l,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,o,l){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,o=n-e,l=n+e,h=s+t,f=s-t;if(this.view!==null&&this.view.enabled){let d=(this.right-this.left)/this.view.fullWidth/this.zoom,m=(this.top-this.bottom)/this.view.fullHeight/this.zoom;o+=d*this.view.offsetX,l=o+d*this.view.width,h-=m*this.view.offsetY,f=h-m*this.view.height}this.projectionMatrix.makeOrthographic(o,l,h,f,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Tc=class extends zs{constructor(){super(new Hs(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ws=class extends ks{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.shadow=new Tc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Dr=-90,Lr=1,Xr=class extends Qt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new gn(Dr,Lr,e,t);s.layers=this.layers,this.add(s);let o=new gn(Dr,Lr,e,t);o.layers=this.layers,this.add(o);let l=new gn(Dr,Lr,e,t);l.layers=this.layers,this.add(l);let h=new gn(Dr,Lr,e,t);h.layers=this.layers,this.add(h);let f=new gn(Dr,Lr,e,t);f.layers=this.layers,this.add(f);let d=new gn(Dr,Lr,e,t);d.layers=this.layers,this.add(d)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,o,l,h,f]=t;for(let d of t)this.remove(d);if(e===Bn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),o.up.set(0,0,-1),o.lookAt(0,1,0),l.up.set(0,0,1),l.lookAt(0,-1,0),h.up.set(0,1,0),h.lookAt(0,0,1),f.up.set(0,1,0),f.lookAt(0,0,-1);else if(e===Or)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),o.up.set(0,0,1),o.lookAt(0,1,0),l.up.set(0,0,-1),l.lookAt(0,-1,0),h.up.set(0,-1,0),h.lookAt(0,0,1),f.up.set(0,-1,0),f.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let d of t)this.add(d),d.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[o,l,h,f,d,m]=this.children,y=e.getRenderTarget(),g=e.getActiveCubeFace(),S=e.getActiveMipmapLevel(),E=e.xr.enabled;e.xr.enabled=!1;let R=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let x=!1;e.isWebGLRenderer===!0?x=e.state.buffers.depth.getReversed():x=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,1,s),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,2,s),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(n,3,s),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,f),e.setRenderTarget(n,4,s),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,d),n.texture.mipmapsAutoUpdate=R,e.setRenderTarget(n,5,s),x&&e.autoClear===!1&&e.clearDepth(),e.render(t,m),e.setRenderTarget(y,g,S),e.xr.enabled=E,n.texture.needsPMREMUpdate=!0}},No=class extends gn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var sh="\\[\\]\\.:\\/",Iv=new RegExp("["+sh+"]","g"),ah="[^"+sh+"]",Dv="[^"+sh.replace("\\.","")+"]",Lv=/((?:WC+[\/:])*)/.source.replace("WC",ah),Fv=/(WCOD+)?/.source.replace("WCOD",Dv),Nv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ah),Uv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ah),Ov=new RegExp("^"+Lv+Fv+Nv+Uv+"$"),Bv=["material","materials","bones","map"],Ac=class{constructor(e,t,n){let s=n||kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,o=n.length;s!==o;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Iv,"")}static parseTrackName(e){let t=Ov.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let o=n.nodeName.substring(s+1);Bv.indexOf(o)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=o)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(o){for(let l=0;l<o.length;l++){let h=o[l];if(h.name===t||h.uuid===t)return h;let f=n(h.children);if(f)return f}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,o=n.length;s!==o;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,o=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let d=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let m=0;m<e.length;m++)if(e[m].name===d){d=m;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(d!==void 0){if(e[d]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[d]}}let l=e[s];if(l===void 0){let d=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+d+"."+s+" but it wasn't found.",e);return}let h=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?h=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(h=this.Versioning.MatrixWorldNeedsUpdate);let f=this.BindingType.Direct;if(o!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[o]!==void 0&&(o=e.morphTargetDictionary[o])}f=this.BindingType.ArrayElement,this.resolvedProperty=l,this.propertyIndex=o}else l.fromArray!==void 0&&l.toArray!==void 0?(f=this.BindingType.HasFromToArray,this.resolvedProperty=l):Array.isArray(l)?(f=this.BindingType.EntireArray,this.resolvedProperty=l):this.propertyName=s;this.getValue=this.GetterByBindingType[f],this.setValue=this.SetterByBindingTypeAndVersioning[f][h]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};kt.Composite=Ac;kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};kt.prototype.GetterByBindingType=[kt.prototype._getValue_direct,kt.prototype._getValue_array,kt.prototype._getValue_arrayElement,kt.prototype._getValue_toArray];kt.prototype.SetterByBindingTypeAndVersioning=[[kt.prototype._setValue_direct,kt.prototype._setValue_direct_setNeedsUpdate,kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_array,kt.prototype._setValue_array_setNeedsUpdate,kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_arrayElement,kt.prototype._setValue_arrayElement_setNeedsUpdate,kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_fromArray,kt.prototype._setValue_fromArray_setNeedsUpdate,kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var bw=new Float32Array(1);var Hu=new Lt,Xs=class{constructor(e,t,n=0,s=1/0){this.ray=new ki(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Gr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Hu.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Hu),this}intersectObject(e,t=!0,n=[]){return Cc(e,this,n,t),n.sort(Wu),n}intersectObjects(e,t=!0,n=[]){for(let s=0,o=e.length;s<o;s++)Cc(e[s],this,n,t);return n.sort(Wu),n}};function Wu(i,e){return i.distance-e.distance}function Cc(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let o=i.children;for(let l=0,h=o.length;l<h;l++)Cc(o[l],e,t,!0)}}var $r=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(yt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Rc=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let o=this.elements;return o[0]=e,o[2]=t,o[1]=n,o[3]=s,this}};var Xu=new j,to,xc,$s=class extends Qt{constructor(e=new j(0,0,1),t=new j(0,0,0),n=1,s=16776960,o=n*.2,l=o*.2){super(),this.type="ArrowHelper",to===void 0&&(to=new wn,to.setAttribute("position",new Xt([0,0,0,0,1,0],3)),xc=new So(.5,1,5,1),xc.translate(0,-.5,0)),this.position.copy(t),this.line=new xo(to,new Is({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new zt(xc,new As({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,o,l)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{Xu.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(Xu,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var qs=class extends qn{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function oh(i,e,t,n){let s=kv(n);switch(t){case qc:return i*e;case Ho:return i*e/s.components*s.byteLength;case Wo:return i*e/s.components*s.byteLength;case Yi:return i*e*2/s.components*s.byteLength;case Xo:return i*e*2/s.components*s.byteLength;case Yc:return i*e*3/s.components*s.byteLength;case Zn:return i*e*4/s.components*s.byteLength;case $o:return i*e*4/s.components*s.byteLength;case Zs:case Js:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ks:case Qs:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Yo:case Zo:return Math.max(i,16)*Math.max(e,8)/4;case qo:case jo:return Math.max(i,8)*Math.max(e,8)/2;case Jo:case Ko:case el:case tl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Qo:case ea:case nl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case il:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case rl:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case sl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case al:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ol:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case ll:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case cl:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case hl:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ul:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case dl:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case fl:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case pl:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case ml:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case gl:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case _l:case vl:case yl:return Math.ceil(i/4)*Math.ceil(e/4)*16;case xl:case Sl:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ta:case Ml:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function kv(i){switch(i){case En:case Hc:return{byteLength:1,components:1};case Zr:case Wc:case jn:return{byteLength:2,components:1};case Go:case Vo:return{byteLength:2,components:4};case Yn:case zo:case zn:return{byteLength:4,components:1};case Xc:case $c:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function nf(){let i=null,e=!1,t=null,n=null;function s(o,l){n=i.requestAnimationFrame(s),t(o,l)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(o){t=o},setContext:function(o){i=o}}}function Gv(i){let e=new WeakMap;function t(h,f){let d=h.array,m=h.usage,y=d.byteLength,g=i.createBuffer();i.bindBuffer(f,g),i.bufferData(f,d,m),h.onUploadCallback();let S;if(d instanceof Float32Array)S=i.FLOAT;else if(typeof Float16Array<"u"&&d instanceof Float16Array)S=i.HALF_FLOAT;else if(d instanceof Uint16Array)h.isFloat16BufferAttribute?S=i.HALF_FLOAT:S=i.UNSIGNED_SHORT;else if(d instanceof Int16Array)S=i.SHORT;else if(d instanceof Uint32Array)S=i.UNSIGNED_INT;else if(d instanceof Int32Array)S=i.INT;else if(d instanceof Int8Array)S=i.BYTE;else if(d instanceof Uint8Array)S=i.UNSIGNED_BYTE;else if(d instanceof Uint8ClampedArray)S=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+d);return{buffer:g,type:S,bytesPerElement:d.BYTES_PER_ELEMENT,version:h.version,size:y}}function n(h,f,d){let m=f.array,y=f.updateRanges;if(i.bindBuffer(d,h),y.length===0)i.bufferSubData(d,0,m);else{y.sort((S,E)=>S.start-E.start);let g=0;for(let S=1;S<y.length;S++){let E=y[g],R=y[S];R.start<=E.start+E.count+1?E.count=Math.max(E.count,R.start+R.count-E.start):(++g,y[g]=R)}y.length=g+1;for(let S=0,E=y.length;S<E;S++){let R=y[S];i.bufferSubData(d,R.start*m.BYTES_PER_ELEMENT,m,R.start,R.count)}f.clearUpdateRanges()}f.onUploadCallback()}function s(h){return h.isInterleavedBufferAttribute&&(h=h.data),e.get(h)}function o(h){h.isInterleavedBufferAttribute&&(h=h.data);let f=e.get(h);f&&(i.deleteBuffer(f.buffer),e.delete(h))}function l(h,f){if(h.isInterleavedBufferAttribute&&(h=h.data),h.isGLBufferAttribute){let m=e.get(h);(!m||m.version<h.version)&&e.set(h,{buffer:h.buffer,type:h.type,bytesPerElement:h.elementSize,version:h.version});return}let d=e.get(h);if(d===void 0)e.set(h,t(h,f));else if(d.version<h.version){if(d.size!==h.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(d.buffer,h,f),d.version=h.version}}return{get:s,remove:o,update:l}}var Vv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Hv=`#ifdef USE_ALPHAHASH
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
#endif`,Wv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Xv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,$v=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,qv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Yv=`#ifdef USE_AOMAP
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
#endif`,jv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Zv=`#ifdef USE_BATCHING
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
#endif`,Jv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Kv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Qv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ey=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ty=`#ifdef USE_IRIDESCENCE
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
#endif`,ny=`#ifdef USE_BUMPMAP
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
#endif`,iy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,ry=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,sy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ay=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,oy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ly=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,cy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,hy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,uy=`#define PI 3.141592653589793
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
} // validated`,dy=`vec3 transformedNormal = objectNormal;
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
#endif`,fy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,py=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,my=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,gy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,_y="gl_FragColor = linearToOutputTexel( gl_FragColor );",vy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,yy=`#ifdef USE_ENVMAP
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
#endif`,xy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Sy=`#ifdef USE_ENVMAP
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
#endif`,My=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,by=`#ifdef USE_ENVMAP
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
#endif`,wy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ey=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ty=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Ay=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Cy=`#ifdef USE_GRADIENTMAP
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
}`,Ry=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Py=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Iy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Dy=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Ly=`#ifdef USE_ENVMAP
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
#endif`,Fy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ny=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Uy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Oy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,By=`PhysicalMaterial material;
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
#endif`,ky=`uniform sampler2D dfgLUT;
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
}`,zy=`
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
#endif`,Gy=`#if defined( RE_IndirectDiffuse )
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
#endif`,Vy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Hy=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Wy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Xy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$y=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Yy=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,jy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Zy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Jy=`#if defined( USE_POINTS_UV )
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
#endif`,Ky=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Qy=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ex=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,tx=`#if defined( USE_MORPHCOLORS )
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
#endif`,nx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ix=`#ifdef USE_MORPHTARGETS
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
#endif`,rx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,sx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ax=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,ox=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,lx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,cx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,hx=`#ifdef USE_NORMALMAP
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
#endif`,ux=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,dx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,fx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,px=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,mx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,gx=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,_x=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,vx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,yx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,xx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Sx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Mx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,bx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,wx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Ex=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Tx=`float getShadowMask() {
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
}`,Ax=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Cx=`#ifdef USE_SKINNING
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
#endif`,Rx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Px=`#ifdef USE_SKINNING
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
#endif`,Ix=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Dx=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Lx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Fx=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Nx=`#ifdef USE_TRANSMISSION
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
#endif`,Ux=`#ifdef USE_TRANSMISSION
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
#endif`,Ox=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Bx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,kx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,zx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Gx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Vx=`uniform sampler2D t2D;
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
}`,Hx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Wx=`uniform float backgroundBlurriness;
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
}`,Xx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$x=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qx=`#include <common>
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
}`,Yx=`#if DEPTH_PACKING == 3200
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
}`,jx=`#define DISTANCE
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
}`,Zx=`#define DISTANCE
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
}`,Jx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Kx=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Qx=`uniform float scale;
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
}`,eS=`uniform vec3 diffuse;
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
}`,tS=`#include <common>
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
}`,nS=`uniform vec3 diffuse;
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
}`,iS=`#define LAMBERT
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
}`,rS=`#define LAMBERT
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
}`,sS=`#define MATCAP
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
}`,aS=`#define MATCAP
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
}`,oS=`#define NORMAL
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
}`,lS=`#define NORMAL
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
}`,cS=`#define PHONG
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
}`,hS=`#define PHONG
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
}`,uS=`#define STANDARD
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
}`,dS=`#define STANDARD
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
}`,fS=`#define TOON
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
}`,pS=`#define TOON
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
}`,mS=`uniform float size;
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
}`,gS=`uniform vec3 diffuse;
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
}`,_S=`#include <common>
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
}`,vS=`uniform vec3 color;
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
}`,yS=`uniform float rotation;
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
}`,xS=`uniform vec3 diffuse;
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
}`,_t={alphahash_fragment:Vv,alphahash_pars_fragment:Hv,alphamap_fragment:Wv,alphamap_pars_fragment:Xv,alphatest_fragment:$v,alphatest_pars_fragment:qv,aomap_fragment:Yv,aomap_pars_fragment:jv,batching_pars_vertex:Zv,batching_vertex:Jv,begin_vertex:Kv,beginnormal_vertex:Qv,bsdfs:ey,iridescence_fragment:ty,bumpmap_pars_fragment:ny,clipping_planes_fragment:iy,clipping_planes_pars_fragment:ry,clipping_planes_pars_vertex:sy,clipping_planes_vertex:ay,color_fragment:oy,color_pars_fragment:ly,color_pars_vertex:cy,color_vertex:hy,common:uy,defaultnormal_vertex:dy,displacementmap_pars_vertex:fy,displacementmap_vertex:py,emissivemap_fragment:my,emissivemap_pars_fragment:gy,colorspace_fragment:_y,colorspace_pars_fragment:vy,envmap_fragment:yy,envmap_common_pars_fragment:xy,envmap_pars_fragment:Sy,envmap_pars_vertex:My,envmap_physical_pars_fragment:Ly,envmap_vertex:by,fog_vertex:wy,fog_pars_vertex:Ey,fog_fragment:Ty,fog_pars_fragment:Ay,gradientmap_pars_fragment:Cy,lightmap_pars_fragment:Ry,lights_lambert_fragment:Py,lights_lambert_pars_fragment:Iy,lights_pars_begin:Dy,lights_toon_fragment:Fy,lights_toon_pars_fragment:Ny,lights_phong_fragment:Uy,lights_phong_pars_fragment:Oy,lights_physical_fragment:By,lights_physical_pars_fragment:ky,lights_fragment_begin:zy,lights_fragment_maps:Gy,lights_fragment_end:Vy,lightprobes_pars_fragment:Hy,logdepthbuf_fragment:Wy,logdepthbuf_pars_fragment:Xy,logdepthbuf_pars_vertex:$y,logdepthbuf_vertex:qy,map_fragment:Yy,map_pars_fragment:jy,map_particle_fragment:Zy,map_particle_pars_fragment:Jy,metalnessmap_fragment:Ky,metalnessmap_pars_fragment:Qy,morphinstance_vertex:ex,morphcolor_vertex:tx,morphnormal_vertex:nx,morphtarget_pars_vertex:ix,morphtarget_vertex:rx,normal_fragment_begin:sx,normal_fragment_maps:ax,normal_pars_fragment:ox,normal_pars_vertex:lx,normal_vertex:cx,normalmap_pars_fragment:hx,clearcoat_normal_fragment_begin:ux,clearcoat_normal_fragment_maps:dx,clearcoat_pars_fragment:fx,iridescence_pars_fragment:px,opaque_fragment:mx,packing:gx,premultiplied_alpha_fragment:_x,project_vertex:vx,dithering_fragment:yx,dithering_pars_fragment:xx,roughnessmap_fragment:Sx,roughnessmap_pars_fragment:Mx,shadowmap_pars_fragment:bx,shadowmap_pars_vertex:wx,shadowmap_vertex:Ex,shadowmask_pars_fragment:Tx,skinbase_vertex:Ax,skinning_pars_vertex:Cx,skinning_vertex:Rx,skinnormal_vertex:Px,specularmap_fragment:Ix,specularmap_pars_fragment:Dx,tonemapping_fragment:Lx,tonemapping_pars_fragment:Fx,transmission_fragment:Nx,transmission_pars_fragment:Ux,uv_pars_fragment:Ox,uv_pars_vertex:Bx,uv_vertex:kx,worldpos_vertex:zx,background_vert:Gx,background_frag:Vx,backgroundCube_vert:Hx,backgroundCube_frag:Wx,cube_vert:Xx,cube_frag:$x,depth_vert:qx,depth_frag:Yx,distance_vert:jx,distance_frag:Zx,equirect_vert:Jx,equirect_frag:Kx,linedashed_vert:Qx,linedashed_frag:eS,meshbasic_vert:tS,meshbasic_frag:nS,meshlambert_vert:iS,meshlambert_frag:rS,meshmatcap_vert:sS,meshmatcap_frag:aS,meshnormal_vert:oS,meshnormal_frag:lS,meshphong_vert:cS,meshphong_frag:hS,meshphysical_vert:uS,meshphysical_frag:dS,meshtoon_vert:fS,meshtoon_frag:pS,points_vert:mS,points_frag:gS,shadow_vert:_S,shadow_frag:vS,sprite_vert:yS,sprite_frag:xS},Be={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new et(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new et(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},mi={basic:{uniforms:_n([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.fog]),vertexShader:_t.meshbasic_vert,fragmentShader:_t.meshbasic_frag},lambert:{uniforms:_n([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:_t.meshlambert_vert,fragmentShader:_t.meshlambert_frag},phong:{uniforms:_n([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_t.meshphong_vert,fragmentShader:_t.meshphong_frag},standard:{uniforms:_n([Be.common,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.roughnessmap,Be.metalnessmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag},toon:{uniforms:_n([Be.common,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.gradientmap,Be.fog,Be.lights,{emissive:{value:new ht(0)}}]),vertexShader:_t.meshtoon_vert,fragmentShader:_t.meshtoon_frag},matcap:{uniforms:_n([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,{matcap:{value:null}}]),vertexShader:_t.meshmatcap_vert,fragmentShader:_t.meshmatcap_frag},points:{uniforms:_n([Be.points,Be.fog]),vertexShader:_t.points_vert,fragmentShader:_t.points_frag},dashed:{uniforms:_n([Be.common,Be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_t.linedashed_vert,fragmentShader:_t.linedashed_frag},depth:{uniforms:_n([Be.common,Be.displacementmap]),vertexShader:_t.depth_vert,fragmentShader:_t.depth_frag},normal:{uniforms:_n([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,{opacity:{value:1}}]),vertexShader:_t.meshnormal_vert,fragmentShader:_t.meshnormal_frag},sprite:{uniforms:_n([Be.sprite,Be.fog]),vertexShader:_t.sprite_vert,fragmentShader:_t.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_t.background_vert,fragmentShader:_t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:_t.backgroundCube_vert,fragmentShader:_t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_t.cube_vert,fragmentShader:_t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_t.equirect_vert,fragmentShader:_t.equirect_frag},distance:{uniforms:_n([Be.common,Be.displacementmap,{referencePosition:{value:new j},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_t.distance_vert,fragmentShader:_t.distance_frag},shadow:{uniforms:_n([Be.lights,Be.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:_t.shadow_vert,fragmentShader:_t.shadow_frag}};mi.physical={uniforms:_n([mi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new et(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ct},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new et},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new et},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag};var bl={r:0,b:0,g:0},SS=new Lt,rf=new ct;rf.set(-1,0,0,0,1,0,0,0,1);function MS(i,e,t,n,s,o){let l=new ht(0),h=s===!0?0:1,f,d,m=null,y=0,g=null;function S(P){let U=P.isScene===!0?P.background:null;if(U&&U.isTexture){let I=P.backgroundBlurriness>0;U=e.get(U,I)}return U}function E(P){let U=!1,I=S(P);I===null?x(l,h):I&&I.isColor&&(x(I,1),U=!0);let O=i.xr.getEnvironmentBlendMode();O==="additive"?t.buffers.color.setClear(0,0,0,1,o):O==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,o),(i.autoClear||U)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function R(P,U){let I=S(U);I&&I.isCubeTexture?(d===void 0&&(d=new zt(new hi(1,1,1),new ui({name:"BackgroundCubeMaterial",uniforms:mr(mi.backgroundCube.uniforms),vertexShader:mi.backgroundCube.vertexShader,fragmentShader:mi.backgroundCube.fragmentShader,side:dn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),d.geometry.deleteAttribute("normal"),d.geometry.deleteAttribute("uv"),d.onBeforeRender=function(O,N,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(d.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(d)),d.material.uniforms.envMap.value=I,d.material.uniforms.backgroundBlurriness.value=U.backgroundBlurriness,d.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,d.material.uniforms.backgroundRotation.value.setFromMatrix4(SS.makeRotationFromEuler(U.backgroundRotation)).transpose(),I.isRenderTargetTexture===!1&&d.material.uniforms.backgroundRotation.value.premultiply(rf),d.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,(m!==I||y!==I.version||g!==i.toneMapping)&&(d.material.needsUpdate=!0,m=I,y=I.version,g=i.toneMapping),d.layers.enableAll(),P.unshift(d,d.geometry,d.material,0,0,null)):I&&I.isTexture&&(f===void 0&&(f=new zt(new Gi(2,2),new ui({name:"BackgroundMaterial",uniforms:mr(mi.background.uniforms),vertexShader:mi.background.vertexShader,fragmentShader:mi.background.fragmentShader,side:qi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),f.geometry.deleteAttribute("normal"),Object.defineProperty(f.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(f)),f.material.uniforms.t2D.value=I,f.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,f.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,I.matrixAutoUpdate===!0&&I.updateMatrix(),f.material.uniforms.uvTransform.value.copy(I.matrix),(m!==I||y!==I.version||g!==i.toneMapping)&&(f.material.needsUpdate=!0,m=I,y=I.version,g=i.toneMapping),f.layers.enableAll(),P.unshift(f,f.geometry,f.material,0,0,null))}function x(P,U){P.getRGB(bl,rh(i)),t.buffers.color.setClear(bl.r,bl.g,bl.b,U,o)}function v(){d!==void 0&&(d.geometry.dispose(),d.material.dispose(),d=void 0),f!==void 0&&(f.geometry.dispose(),f.material.dispose(),f=void 0)}return{getClearColor:function(){return l},setClearColor:function(P,U=1){l.set(P),h=U,x(l,h)},getClearAlpha:function(){return h},setClearAlpha:function(P){h=P,x(l,h)},render:E,addToRenderList:R,dispose:v}}function bS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=g(null),o=s,l=!1;function h(Y,J,ee,z,ie){let G=!1,ne=y(Y,z,ee,J);o!==ne&&(o=ne,d(o.object)),G=S(Y,z,ee,ie),G&&E(Y,z,ee,ie),ie!==null&&e.update(ie,i.ELEMENT_ARRAY_BUFFER),(G||l)&&(l=!1,I(Y,J,ee,z),ie!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(ie).buffer))}function f(){return i.createVertexArray()}function d(Y){return i.bindVertexArray(Y)}function m(Y){return i.deleteVertexArray(Y)}function y(Y,J,ee,z){let ie=z.wireframe===!0,G=n[J.id];G===void 0&&(G={},n[J.id]=G);let ne=Y.isInstancedMesh===!0?Y.id:0,Se=G[ne];Se===void 0&&(Se={},G[ne]=Se);let re=Se[ee.id];re===void 0&&(re={},Se[ee.id]=re);let H=re[ie];return H===void 0&&(H=g(f()),re[ie]=H),H}function g(Y){let J=[],ee=[],z=[];for(let ie=0;ie<t;ie++)J[ie]=0,ee[ie]=0,z[ie]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:J,enabledAttributes:ee,attributeDivisors:z,object:Y,attributes:{},index:null}}function S(Y,J,ee,z){let ie=o.attributes,G=J.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=ie[re],We=G[re];if(We===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(We=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(We=Y.instanceColor)),ge===void 0||ge.attribute!==We||We&&ge.data!==We.data)return!0;ne++}return o.attributesNum!==ne||o.index!==z}function E(Y,J,ee,z){let ie={},G=J.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=G[re];ge===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(ge=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(ge=Y.instanceColor));let We={};We.attribute=ge,ge&&ge.data&&(We.data=ge.data),ie[re]=We,ne++}o.attributes=ie,o.attributesNum=ne,o.index=z}function R(){let Y=o.newAttributes;for(let J=0,ee=Y.length;J<ee;J++)Y[J]=0}function x(Y){v(Y,0)}function v(Y,J){let ee=o.newAttributes,z=o.enabledAttributes,ie=o.attributeDivisors;ee[Y]=1,z[Y]===0&&(i.enableVertexAttribArray(Y),z[Y]=1),ie[Y]!==J&&(i.vertexAttribDivisor(Y,J),ie[Y]=J)}function P(){let Y=o.newAttributes,J=o.enabledAttributes;for(let ee=0,z=J.length;ee<z;ee++)J[ee]!==Y[ee]&&(i.disableVertexAttribArray(ee),J[ee]=0)}function U(Y,J,ee,z,ie,G,ne){ne===!0?i.vertexAttribIPointer(Y,J,ee,ie,G):i.vertexAttribPointer(Y,J,ee,z,ie,G)}function I(Y,J,ee,z){R();let ie=z.attributes,G=ee.getAttributes(),ne=J.defaultAttributeValues;for(let Se in G){let re=G[Se];if(re.location>=0){let H=ie[Se];if(H===void 0&&(Se==="instanceMatrix"&&Y.instanceMatrix&&(H=Y.instanceMatrix),Se==="instanceColor"&&Y.instanceColor&&(H=Y.instanceColor)),H!==void 0){let ge=H.normalized,We=H.itemSize,it=e.get(H);if(it===void 0)continue;let ue=it.buffer,Fe=it.type,Pe=it.bytesPerElement,je=Fe===i.INT||Fe===i.UNSIGNED_INT||H.gpuType===zo;if(H.isInterleavedBufferAttribute){let Ue=H.data,ot=Ue.isInterleavedBuffer===!0?Ue.stride:Ue.itemSize,Vt=H.offset;if(Ue.isInstancedInterleavedBuffer||Ue.isInstancedBufferAttribute){for(let Ke=0;Ke<re.locationSize;Ke++)v(re.location+Ke,Ue.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=Ue.meshPerAttribute*Ue.count)}else for(let Ke=0;Ke<re.locationSize;Ke++)x(re.location+Ke);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Ke=0;Ke<re.locationSize;Ke++)U(re.location+Ke,We/re.locationSize,Fe,ge,ot*Pe,(Vt+We/re.locationSize*Ke)*Pe,je)}else{if(H.isInstancedBufferAttribute){for(let Ue=0;Ue<re.locationSize;Ue++)v(re.location+Ue,H.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=H.meshPerAttribute*H.count)}else for(let Ue=0;Ue<re.locationSize;Ue++)x(re.location+Ue);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Ue=0;Ue<re.locationSize;Ue++)U(re.location+Ue,We/re.locationSize,Fe,ge,We*Pe,We/re.locationSize*Ue*Pe,je)}}else if(ne!==void 0){let ge=ne[Se];if(ge!==void 0)switch(ge.length){case 2:i.vertexAttrib2fv(re.location,ge);break;case 3:i.vertexAttrib3fv(re.location,ge);break;case 4:i.vertexAttrib4fv(re.location,ge);break;default:i.vertexAttrib1fv(re.location,ge)}}}}P()}function O(){q();for(let Y in n){let J=n[Y];for(let ee in J){let z=J[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y]}}function N(Y){if(n[Y.id]===void 0)return;let J=n[Y.id];for(let ee in J){let z=J[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y.id]}function b(Y){for(let J in n){let ee=n[J];for(let z in ee){let ie=ee[z];if(ie[Y.id]===void 0)continue;let G=ie[Y.id];for(let ne in G)m(G[ne].object),delete G[ne];delete ie[Y.id]}}}function D(Y){for(let J in n){let ee=n[J],z=Y.isInstancedMesh===!0?Y.id:0,ie=ee[z];if(ie!==void 0){for(let G in ie){let ne=ie[G];for(let Se in ne)m(ne[Se].object),delete ne[Se];delete ie[G]}delete ee[z],Object.keys(ee).length===0&&delete n[J]}}}function q(){k(),l=!0,o!==s&&(o=s,d(o.object))}function k(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:h,reset:q,resetDefaultState:k,dispose:O,releaseStatesOfGeometry:N,releaseStatesOfObject:D,releaseStatesOfProgram:b,initAttributes:R,enableAttribute:x,disableUnusedAttributes:P}}function wS(i,e,t){let n;function s(f){n=f}function o(f,d){i.drawArrays(n,f,d),t.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawArraysInstanced(n,f,d,m),t.update(d,n,m))}function h(f,d,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,f,0,d,0,m);let g=0;for(let S=0;S<m;S++)g+=d[S];t.update(g,n,1)}this.setMode=s,this.render=o,this.renderInstances=l,this.renderMultiDraw=h}function ES(i,e,t,n){let s;function o(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let b=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function l(b){return!(b!==Zn&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function h(b){let D=b===jn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(b!==En&&b!==zn&&!D&&n.convert(b)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function f(b){if(b==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let d=t.precision!==void 0?t.precision:"highp",m=f(d);m!==d&&(Qe("WebGLRenderer:",d,"not supported, using",m,"instead."),d=m);let y=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),g=t.logarithmicDepthBuffer===!0&&y===!1;t.reversedDepthBuffer===!0&&y===!1&&Qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&y===!0&&Qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let S=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),E=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),R=i.getParameter(i.MAX_TEXTURE_SIZE),x=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),v=i.getParameter(i.MAX_VERTEX_ATTRIBS),P=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),U=i.getParameter(i.MAX_VARYING_VECTORS),I=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),O=i.getParameter(i.MAX_SAMPLES),N=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:o,getMaxPrecision:f,textureFormatReadable:l,textureTypeReadable:h,precision:d,logarithmicDepthBuffer:g,reversedDepthBuffer:y,maxTextures:S,maxVertexTextures:E,maxTextureSize:R,maxCubemapSize:x,maxAttributes:v,maxVertexUniforms:P,maxVaryings:U,maxFragmentUniforms:I,maxSamples:O,samples:N}}function TS(i){let e=this,t=null,n=0,s=!1,o=!1,l=new Pn,h=new ct,f={value:null,needsUpdate:!1};this.uniform=f,this.numPlanes=0,this.numIntersection=0,this.init=function(y,g){let S=y.length!==0||g||n!==0||s;return s=g,n=y.length,S},this.beginShadows=function(){o=!0,m(null)},this.endShadows=function(){o=!1},this.setGlobalState=function(y,g){t=m(y,g,0)},this.setState=function(y,g,S){let E=y.clippingPlanes,R=y.clipIntersection,x=y.clipShadows,v=i.get(y);if(!s||E===null||E.length===0||o&&!x)o?m(null):d();else{let P=o?0:n,U=P*4,I=v.clippingState||null;f.value=I,I=m(E,g,U,S);for(let O=0;O!==U;++O)I[O]=t[O];v.clippingState=I,this.numIntersection=R?this.numPlanes:0,this.numPlanes+=P}};function d(){f.value!==t&&(f.value=t,f.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function m(y,g,S,E){let R=y!==null?y.length:0,x=null;if(R!==0){if(x=f.value,E!==!0||x===null){let v=S+R*4,P=g.matrixWorldInverse;h.getNormalMatrix(P),(x===null||x.length<v)&&(x=new Float32Array(v));for(let U=0,I=S;U!==R;++U,I+=4)l.copy(y[U]).applyMatrix4(P,h),l.normal.toArray(x,I),x[I+3]=l.constant}f.value=x,f.needsUpdate=!0}return e.numPlanes=R,e.numIntersection=0,x}}var sa=class extends Dn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Ds(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new hi(5,5,5),o=new ui({name:"CubemapFromEquirect",uniforms:mr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:dn,blending:ur});o.uniforms.tEquirect.value=t;let l=new zt(s,o),h=t.minFilter;return t.minFilter===Ci&&(t.minFilter=Sn),new Xr(1,10,this).update(e,l),t.minFilter=h,l.geometry.dispose(),l.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let o=e.getRenderTarget();for(let l=0;l<6;l++)e.setRenderTarget(this,l),e.clear(t,n,s);e.setRenderTarget(o)}},Nd=256,AS=3,CS=20,sf=256,af=16,RS=3,PS=new j,IS=new ht,Qr=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Xr(1,10,null),this._boxMesh=new zt(new hi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,o={}){let{size:l=256,position:h=PS}=o,f=this._renderer;this._setSize(l);let d=this._allocateTarget(),m=this._getSourceTarget(!0);t>0&&(m.texture.mipmapsAutoUpdate=!1);let y=f.autoClear,g=f.autoClearColor,S=f.autoClearDepth,E=f.autoClearStencil,R=e.background;f.autoClear=!0,f.autoClearColor=!0,f.autoClearDepth=!0,f.autoClearStencil=!0,R===null&&(e.background=f.getClearColor(IS));let x=new Xr(n,s,m);return x.position.copy(h),x.update(f,e),f.autoClear=y,f.autoClearColor=g,f.autoClearDepth=S,f.autoClearStencil=E,e.background=R,t>0&&(m.texture.mipmapsAutoUpdate=!0,this._blur(d,t)),this._applyPMREM(d),d}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Bd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Od(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Nd,th(e))}_fromTexture(e,t){e.mapping===fr||e.mapping===jr?this._setSize(e.image.length===0?Nd:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Ud(e,!1,!1),n=Math.log2(e)-AS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Ud(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,o=this._cubeCamera;s.material=n,o.renderTarget=e,o.activeMipmapLevel=t;let l=e.width>>t;e.viewport.set(0,0,l,l),o.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===fr||e.mapping===jr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Bd()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Od()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=DS(),this._integrationMaterial=LS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let o=this._integrationMaterial.uniforms;o.envMap.value=this._sourceTarget.texture,o.sourceLod.value=Math.log2(t/af);for(let l=0;l<=n;l++){let h=i.lodToRoughness(l,n);if(l>n-RS)o.roughness.value=h,this._renderCube(e,l,this._integrationMaterial);else{let f=h>0?Math.log2(t)+.5*Math.log2(6/(sf*Math.pow(h,4)))+.5:0;s.roughness.value=h,s.lodBias.value=f,this._renderCube(e,l,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=FS());let n=this._blurMaterial,s=n.uniforms,o=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=o.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(o,0,n)}};function Ud(i,e,t){return new sa(i,{minFilter:Ci,generateMipmaps:e,type:jn,colorSpace:xs,depthBuffer:t})}function aa(i,e,t){return new ui({name:i,uniforms:e,vertexShader:_t.cube_vert,fragmentShader:t,side:dn,blending:ur,depthTest:!1,depthWrite:!1})}function DS(){return aa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${sf}u

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
	`)}function LS(){return aa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:af}},`

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
	`)}function FS(){return aa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${CS}
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
	`)}function Od(){return aa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Bd(){return aa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function NS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(g,S=!1){return g==null?null:S?l(g):o(g)}function o(g){if(g&&g.isTexture){let S=g.mapping;if(S===Oo||S===Bo)if(e.has(g)){let E=e.get(g).texture;return h(E,g.mapping)}else{let E=g.image;if(E&&E.height>0){let R=new sa(E.height);return R.fromEquirectangularTexture(i,g),e.set(g,R),g.addEventListener("dispose",d),h(R.texture,g.mapping)}else return null}}return g}function l(g){if(g&&g.isTexture&&g.isPMREMTexture!==!0){let S=g.mapping,E=S===Oo||S===Bo,R=S===fr||S===jr;if(E||R){let x=t.get(g),v=x!==void 0?x.texture.pmremVersion:0;if(g.isRenderTargetTexture&&g.pmremVersion!==v)return n===null&&(n=new Qr(i)),x=E?n.fromEquirectangular(g,x):n.fromCubemap(g,x),x.texture.pmremVersion=g.pmremVersion,t.set(g,x),x.texture;if(x!==void 0)return x.texture;{let P=g.image;return E&&P&&P.height>0||R&&P&&f(P)?(n===null&&(n=new Qr(i)),x=E?n.fromEquirectangular(g):n.fromCubemap(g),x.texture.pmremVersion=g.pmremVersion,t.set(g,x),g.addEventListener("dispose",m),x.texture):null}}}return g}function h(g,S){return S===Oo?g.mapping=fr:S===Bo&&(g.mapping=jr),g}function f(g){let S=0,E=6;for(let R=0;R<E;R++)g[R]!==void 0&&S++;return S===E}function d(g){let S=g.target;S.removeEventListener("dispose",d);let E=e.get(S);E!==void 0&&(e.delete(S),E.dispose())}function m(g){let S=g.target;S.removeEventListener("dispose",m);let E=t.get(S);E!==void 0&&(t.delete(S),E.dispose())}function y(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:y}}function US(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&gs("WebGLRenderer: "+n+" extension not supported."),s}}}function OS(i,e,t,n){let s={},o=new WeakMap,l=new FinalizationRegistry(E=>delete s[E]);function h(E){f(E.target)}function f(E){E.index!==null&&e.remove(E.index);for(let x in E.attributes)e.remove(E.attributes[x]);E.removeEventListener("dispose",h),delete s[E.id],l.unregister(E);let R=o.get(E);R&&(e.remove(R),o.delete(E)),n.releaseStatesOfGeometry(E),E.isInstancedBufferGeometry===!0&&delete E._maxInstanceCount,t.memory.geometries--}function d(E,R){return s[R.id]!==void 0||(R.addEventListener("dispose",h),s[R.id]=new WeakRef(R),l.register(R,R.id,R),t.memory.geometries++),R}function m(E){let R=E.attributes;for(let x in R)e.update(R[x],i.ARRAY_BUFFER)}function y(E){let R=E.index,x=E.attributes.position,v=0;if(x===void 0)return;let P=R!==null?R.array.length:x.array.length/3-1,U=x.count>=65535?Ts:Es,I=new U(Math.ceil(P/3)*6,1),O=I.array;if(R!==null){let b=R.array;v=R.version;for(let D=0,q=0;D<P;D+=3){let k=b[D+0],Y=b[D+1],J=b[D+2];O[q++]=k,O[q++]=Y,O[q++]=Y,O[q++]=J,O[q++]=J,O[q++]=k}}else{v=x.version;for(let b=0,D=0;b<P;b+=3){let q=b+0,k=b+1,Y=b+2;O[D++]=q,O[D++]=k,O[D++]=k,O[D++]=Y,O[D++]=Y,O[D++]=q}}I.version=v;let N=o.get(E);N&&e.remove(N),o.set(E,I)}function g(E){let R=o.get(E);if(R){let x=E.index;x!==null&&R.version<x.version&&y(E)}else y(E);return o.get(E)}function S(){for(let E in s){let R=s[E].deref();R!==void 0&&f(R)}}return{get:d,update:m,getWireframeAttribute:g,dispose:S}}function BS(i,e,t){let n;function s(y){n=y}let o,l;function h(y){o=y.type,l=y.bytesPerElement}function f(y,g){i.drawElements(n,g,o,y*l),t.update(g,n,1)}function d(y,g,S){S!==0&&(i.drawElementsInstanced(n,g,o,y*l,S),t.update(g,n,S))}function m(y,g,S){if(S===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,g,0,o,y,0,S);let R=0;for(let x=0;x<S;x++)R+=g[x];t.update(R,n,1)}this.setMode=s,this.setIndex=h,this.render=f,this.renderInstances=d,this.renderMultiDraw=m}function kS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(o,l,h){switch(t.calls++,l){case i.TRIANGLES:t.triangles+=h*(o/3);break;case i.LINES:t.lines+=h*(o/2);break;case i.LINE_STRIP:t.lines+=h*(o-1);break;case i.LINE_LOOP:t.lines+=h*o;break;case i.POINTS:t.points+=h*o;break;default:nt("WebGLInfo: Unknown draw mode:",l);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function zS(i,e,t){let n=new WeakMap,s=new Gt;function o(l,h,f){let d=l.morphTargetInfluences,m=h.morphAttributes.position||h.morphAttributes.normal||h.morphAttributes.color,y=m!==void 0?m.length:0,g=n.get(h);if(g===void 0||g.count!==y){let q=function(){b.dispose(),n.delete(h),h.removeEventListener("dispose",q)};g!==void 0&&g.texture.dispose();let S=h.morphAttributes.position!==void 0,E=h.morphAttributes.normal!==void 0,R=h.morphAttributes.color!==void 0,x=h.morphAttributes.position||[],v=h.morphAttributes.normal||[],P=h.morphAttributes.color||[],U=0;S===!0&&(U=1),E===!0&&(U=2),R===!0&&(U=3);let I=h.attributes.position.count*U,O=1;I>e.maxTextureSize&&(O=Math.ceil(I/e.maxTextureSize),I=e.maxTextureSize);let N=new Float32Array(I*O*4*y),b=new bs(N,I,O,y);b.type=zn,b.needsUpdate=!0;let D=U*4;for(let k=0;k<y;k++){let Y=x[k],J=v[k],ee=P[k],z=I*O*4*k;for(let ie=0;ie<Y.count;ie++){let G=ie*D;S===!0&&(s.fromBufferAttribute(Y,ie),N[z+G+0]=s.x,N[z+G+1]=s.y,N[z+G+2]=s.z,N[z+G+3]=0),E===!0&&(s.fromBufferAttribute(J,ie),N[z+G+4]=s.x,N[z+G+5]=s.y,N[z+G+6]=s.z,N[z+G+7]=0),R===!0&&(s.fromBufferAttribute(ee,ie),N[z+G+8]=s.x,N[z+G+9]=s.y,N[z+G+10]=s.z,N[z+G+11]=ee.itemSize===4?s.w:1)}}g={count:y,texture:b,size:new et(I,O)},n.set(h,g),h.addEventListener("dispose",q)}if(l.isInstancedMesh===!0&&l.morphTexture!==null)f.getUniforms().setValue(i,"morphTexture",l.morphTexture,t);else{let S=0;for(let R=0;R<d.length;R++)S+=d[R];let E=h.morphTargetsRelative?1:1-S;f.getUniforms().setValue(i,"morphTargetBaseInfluence",E),f.getUniforms().setValue(i,"morphTargetInfluences",d)}f.getUniforms().setValue(i,"morphTargetsTexture",g.texture,t),f.getUniforms().setValue(i,"morphTargetsTextureSize",g.size)}return{update:o}}function GS(i,e,t,n,s){let o=new WeakMap;function l(d){let m=s.render.frame,y=d.geometry,g=e.get(d,y);if(o.get(g)!==m&&(e.update(g),o.set(g,m)),d.isInstancedMesh&&(d.hasEventListener("dispose",f)===!1&&d.addEventListener("dispose",f),o.get(d)!==m&&(t.update(d.instanceMatrix,i.ARRAY_BUFFER),d.instanceColor!==null&&t.update(d.instanceColor,i.ARRAY_BUFFER),o.set(d,m))),d.isSkinnedMesh){let S=d.skeleton;o.get(S)!==m&&(S.update(),o.set(S,m))}return g}function h(){o=new WeakMap}function f(d){let m=d.target;m.removeEventListener("dispose",f),n.releaseStatesOfObject(m),t.remove(m.instanceMatrix),m.instanceColor!==null&&t.remove(m.instanceColor)}return{update:l,dispose:h}}var VS={[Uc]:"LINEAR_TONE_MAPPING",[Oc]:"REINHARD_TONE_MAPPING",[Bc]:"CINEON_TONE_MAPPING",[kc]:"ACES_FILMIC_TONE_MAPPING",[Gc]:"AGX_TONE_MAPPING",[Ys]:"NEUTRAL_TONE_MAPPING",[zc]:"CUSTOM_TONE_MAPPING"};function HS(i,e,t,n,s,o){let l=new Dn(e,t,{type:i,depthBuffer:s,stencilBuffer:o,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),h=null,f=null,d=null,m=new wn;m.setAttribute("position",new Xt([-1,3,0,-1,-1,0,3,-1,0],3)),m.setAttribute("uv",new Xt([0,2,0,0,2,0],2));let y=new Mo({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),g=new zt(m,y),S=new Hs(-1,1,1,-1,0,1),E=null,R=null,x=!1,v,P=null,U=[],I=!1;this.setSize=function(O,N){l.setSize(O,N),h!==null&&h.setSize(O,N),f!==null&&f.setSize(O,N);for(let b=0;b<U.length;b++){let D=U[b];D.setSize&&D.setSize(O,N)}},this.setEffects=function(O){U=O,I=U.length>0&&U[0].isRenderPass===!0;let N=l.width,b=l.height;U.length>0&&h===null&&(h=new Dn(N,b,{type:jn,depthBuffer:!1,stencilBuffer:!1}),f=new Dn(N,b,{type:jn,depthBuffer:!1,stencilBuffer:!1}));let D=s===!0&&U.some(q=>q.needsDepthTexture===!0);D!==(l.depthTexture!==null)&&(D===!0&&d===null&&(d=new Ti(N,b),o===!0&&(d.format=Ri,d.type=pr)),l.dispose(),l.depthTexture=D?d:null,l.resolveDepthBuffer=D,l.storeMultisampledDepthBuffer=D);for(let q=0;q<U.length;q++){let k=U[q];k.setSize&&k.setSize(N,b),D&&k.needsDepthTexture===!0&&k.setDepthTexture&&k.setDepthTexture(d)}},this.begin=function(O,N){if(x||O.toneMapping===fi&&U.length===0)return!1;if(P=N,N!==null){let b=N.width,D=N.height;(l.width!==b||l.height!==D)&&this.setSize(b,D)}return I===!1&&O.setRenderTarget(l),v=O.toneMapping,O.toneMapping=fi,!0},this.hasRenderPass=function(){return I},this.end=function(O,N){O.toneMapping=v,x=!0;let b=l,D=h;for(let q=0;q<U.length;q++){let k=U[q];k.enabled!==!1&&(k.render(O,D,b,N),k.needsSwap!==!1&&(b=D,D=D===h?f:h))}if(E!==O.outputColorSpace||R!==O.toneMapping){E=O.outputColorSpace,R=O.toneMapping,y.defines={},St.getTransfer(E)===Pt&&(y.defines.SRGB_TRANSFER="");let q=VS[R];q&&(y.defines[q]=""),y.needsUpdate=!0}y.uniforms.tDiffuse.value=b.texture,O.setRenderTarget(P),O.render(g,S),P=null,x=!1},this.isCompositing=function(){return x},this.dispose=function(){l.dispose(),h!==null&&h.dispose(),f!==null&&f.dispose(),m.dispose(),y.dispose()}}var of=new bn,lf=new Ti(1,1),cf=new Fs(1),hf=new bs,uf=new go,df=new Ds,kd=[],zd=[],Gd=new Float32Array(16),Vd=new Float32Array(9),Hd=new Float32Array(4);function es(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,o=kd[s];if(o===void 0&&(o=new Float32Array(s),kd[s]=o),e!==0){n.toArray(o,0);for(let l=1,h=0;l!==e;++l)h+=t,i[l].toArray(o,h)}return o}function en(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Tl(i,e){let t=zd[e];t===void 0&&(t=new Int32Array(e),zd[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function WS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function XS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2fv(this.addr,e),tn(t,e)}}function $S(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(en(t,e))return;i.uniform3fv(this.addr,e),tn(t,e)}}function qS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4fv(this.addr,e),tn(t,e)}}function YS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Hd.set(n),i.uniformMatrix2fv(this.addr,!1,Hd),tn(t,n)}}function jS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Vd.set(n),i.uniformMatrix3fv(this.addr,!1,Vd),tn(t,n)}}function ZS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Gd.set(n),i.uniformMatrix4fv(this.addr,!1,Gd),tn(t,n)}}function JS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function KS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2iv(this.addr,e),tn(t,e)}}function QS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3iv(this.addr,e),tn(t,e)}}function eM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4iv(this.addr,e),tn(t,e)}}function tM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function nM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2uiv(this.addr,e),tn(t,e)}}function iM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3uiv(this.addr,e),tn(t,e)}}function rM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4uiv(this.addr,e),tn(t,e)}}function Al(i){return i.version===0&&(i.compareFunction=Jc,i.needsUpdate=!0),i}function sM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_2D_SHADOW?o=Al(lf):o=of,t.setTexture2D(e||o,s)}function aM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||uf,s)}function oM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Al(cf):o=df,t.setTextureCube(e||o,s)}function lM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||hf,s)}function cM(i){switch(i){case 5126:return WS;case 35664:return XS;case 35665:return $S;case 35666:return qS;case 35674:return YS;case 35675:return jS;case 35676:return ZS;case 5124:case 35670:return JS;case 35667:case 35671:return KS;case 35668:case 35672:return QS;case 35669:case 35673:return eM;case 5125:return tM;case 36294:return nM;case 36295:return iM;case 36296:return rM;case 35678:case 36198:case 36298:case 36306:case 35682:return sM;case 35679:case 36299:case 36307:return aM;case 35680:case 36300:case 36308:case 36293:return oM;case 36289:case 36303:case 36311:case 36292:return lM}}function hM(i,e){i.uniform1fv(this.addr,e)}function uM(i,e){let t=es(e,this.size,2);i.uniform2fv(this.addr,t)}function dM(i,e){let t=es(e,this.size,3);i.uniform3fv(this.addr,t)}function fM(i,e){let t=es(e,this.size,4);i.uniform4fv(this.addr,t)}function pM(i,e){let t=es(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function mM(i,e){let t=es(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function gM(i,e){let t=es(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function _M(i,e){i.uniform1iv(this.addr,e)}function vM(i,e){i.uniform2iv(this.addr,e)}function yM(i,e){i.uniform3iv(this.addr,e)}function xM(i,e){i.uniform4iv(this.addr,e)}function SM(i,e){i.uniform1uiv(this.addr,e)}function MM(i,e){i.uniform2uiv(this.addr,e)}function bM(i,e){i.uniform3uiv(this.addr,e)}function wM(i,e){i.uniform4uiv(this.addr,e)}function EM(i,e,t){let n=this.cache,s=e.length,o=Tl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));let l;this.type===i.SAMPLER_2D_SHADOW?l=Al(lf):l=of;for(let h=0;h!==s;++h)t.setTexture2D(e[h]||l,o[h])}function TM(i,e,t){let n=this.cache,s=e.length,o=Tl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let l=0;l!==s;++l)t.setTexture3D(e[l]||uf,o[l])}function AM(i,e,t){let n=this.cache,s=e.length,o=Tl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));let l;this.type===i.SAMPLER_CUBE_SHADOW?l=Al(cf):l=df;for(let h=0;h!==s;++h)t.setTextureCube(e[h]||l,o[h])}function CM(i,e,t){let n=this.cache,s=e.length,o=Tl(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let l=0;l!==s;++l)t.setTexture2DArray(e[l]||hf,o[l])}function RM(i){switch(i){case 5126:return hM;case 35664:return uM;case 35665:return dM;case 35666:return fM;case 35674:return pM;case 35675:return mM;case 35676:return gM;case 5124:case 35670:return _M;case 35667:case 35671:return vM;case 35668:case 35672:return yM;case 35669:case 35673:return xM;case 5125:return SM;case 36294:return MM;case 36295:return bM;case 36296:return wM;case 35678:case 36198:case 36298:case 36306:case 35682:return EM;case 35679:case 36299:case 36307:return TM;case 35680:case 36300:case 36308:case 36293:return AM;case 36289:case 36303:case 36311:case 36292:return CM}}var hh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=cM(t.type)}},uh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=RM(t.type)}},dh=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let o=0,l=s.length;o!==l;++o){let h=s[o];h.setValue(e,t[h.id],n)}}},lh=/(\w+)(\])?(\[|\.)?/g;function Wd(i,e){i.seq.push(e),i.map[e.id]=e}function PM(i,e,t){let n=i.name,s=n.length;for(lh.lastIndex=0;;){let o=lh.exec(n),l=lh.lastIndex,h=o[1],f=o[2]==="]",d=o[3];if(f&&(h=h|0),d===void 0||d==="["&&l+2===s){Wd(t,d===void 0?new hh(h,i,e):new uh(h,i,e));break}else{let y=t.map[h];y===void 0&&(y=new dh(h),Wd(t,y)),t=y}}}var Kr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let l=0;l<n;++l){let h=e.getActiveUniform(t,l),f=e.getUniformLocation(t,h.name);PM(h,f,this)}let s=[],o=[];for(let l of this.seq)l.type===e.SAMPLER_2D_SHADOW||l.type===e.SAMPLER_CUBE_SHADOW||l.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(l):o.push(l);s.length>0&&(this.seq=s.concat(o))}setValue(e,t,n,s){let o=this.map[t];o!==void 0&&o.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let o=0,l=t.length;o!==l;++o){let h=t[o],f=n[h.id];f.needsUpdate!==!1&&h.setValue(e,f.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,o=e.length;s!==o;++s){let l=e[s];l.id in t&&n.push(l)}return n}};function Xd(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var IM=37297,DM=0;function LM(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),o=Math.min(e+6,t.length);for(let l=s;l<o;l++){let h=l+1;n.push(`${h===e?">":" "} ${h}: ${t[l]}`)}return n.join(`
`)}var $d=new ct;function FM(i){St._getMatrix($d,St.workingColorSpace,i);let e=`mat3( ${$d.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case Ss:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function qd(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),o=(i.getShaderInfoLog(e)||"").trim();if(n&&o==="")return"";let l=/ERROR: 0:(\d+)/.exec(o);if(l){let h=parseInt(l[1]);return t.toUpperCase()+`

`+o+`

`+LM(i.getShaderSource(e),h)}else return o}function NM(i,e){let t=FM(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var UM={[Uc]:"Linear",[Oc]:"Reinhard",[Bc]:"Cineon",[kc]:"ACESFilmic",[Gc]:"AgX",[Ys]:"Neutral",[zc]:"Custom"};function OM(i,e){let t=UM[e];return t===void 0?(Qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var wl=new j;function BM(){St.getLuminanceCoefficients(wl);let i=wl.x.toFixed(4),e=wl.y.toFixed(4),t=wl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function kM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ra).join(`
`)}function zM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function GM(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let o=i.getActiveAttrib(e,s),l=o.name,h=1;o.type===i.FLOAT_MAT2&&(h=2),o.type===i.FLOAT_MAT3&&(h=3),o.type===i.FLOAT_MAT4&&(h=4),t[l]={type:o.type,location:i.getAttribLocation(e,l),locationSize:h}}return t}function ra(i){return i!==""}function Yd(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function jd(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var VM=/^[ \t]*#include +<([\w\d./]+)>/gm;function fh(i){return i.replace(VM,HM)}function HM(i,e){let t=_t[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return fh(t)}var WM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Zd(i){return i.replace(WM,XM)}function XM(i,e,t,n){let s="";for(let o=parseInt(e);o<parseInt(t);o++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+o+" ]").replace(/UNROLLED_LOOP_INDEX/g,o);return s}function Jd(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var $M={[hr]:"SHADOWMAP_TYPE_PCF",[qr]:"SHADOWMAP_TYPE_VSM"};function qM(i){return $M[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var YM={[jr]:"ENVMAP_MODE_REFRACTION"};function jM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":YM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ZM={[Uo]:"ENVMAP_BLENDING_MULTIPLY",[fd]:"ENVMAP_BLENDING_MIX",[pd]:"ENVMAP_BLENDING_ADD"};function JM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":ZM[i.combine]||"ENVMAP_BLENDING_NONE"}function KM(i,e,t,n){let s=i.getContext(),o=t.defines,l=t.vertexShader,h=t.fragmentShader,f=qM(t),d=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",m=jM(t),y=JM(t),g=kM(t),S=zM(o),E=s.createProgram(),R,x,v=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(R=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,S].filter(ra).join(`
`),R.length>0&&(R+=`
`),x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,S].filter(ra).join(`
`),x.length>0&&(x+=`
`)):(R=[Jd(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,S,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+m:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ra).join(`
`),x=[Jd(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,S,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+d:"",t.envMap?"#define "+m:"",t.envMap?"#define "+y:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==fi?"#define TONE_MAPPING":"",t.toneMapping!==fi?_t.tonemapping_pars_fragment:"",t.toneMapping!==fi?OM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",_t.colorspace_pars_fragment,NM("linearToOutputTexel",t.outputColorSpace),BM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ra).join(`
`)),l=fh(l),l=Yd(l,t),l=jd(l,t),h=fh(h),h=Yd(h,t),h=jd(h,t),l=Zd(l),h=Zd(h),t.isRawShaderMaterial!==!0&&(v=`#version 300 es
`,R=[g,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+R,x=["#define varying in",t.glslVersion===Kc?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Kc?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+x);let P=v+R+l,U=v+x+h,I=Xd(s,s.VERTEX_SHADER,P),O=Xd(s,s.FRAGMENT_SHADER,U);s.attachShader(E,I),s.attachShader(E,O),t.index0AttributeName!==void 0?s.bindAttribLocation(E,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(E,0,"position"),s.linkProgram(E);function N(k){if(i.debug.checkShaderErrors){let Y=s.getProgramInfoLog(E)||"",J=s.getShaderInfoLog(I)||"",ee=s.getShaderInfoLog(O)||"",z=Y.trim(),ie=J.trim(),G=ee.trim(),ne=!0,Se=!0;if(s.getProgramParameter(E,s.LINK_STATUS)===!1)if(ne=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,E,I,O);else{let re=qd(s,I,"vertex"),H=qd(s,O,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(E,s.VALIDATE_STATUS)+`

Material Name: `+k.name+`
Material Type: `+k.type+`

Program Info Log: `+z+`
`+re+`
`+H)}else z!==""?Qe("WebGLProgram: Program Info Log:",z):(ie===""||G==="")&&(Se=!1);Se&&(k.diagnostics={runnable:ne,programLog:z,vertexShader:{log:ie,prefix:R},fragmentShader:{log:G,prefix:x}})}s.deleteShader(I),s.deleteShader(O),b=new Kr(s,E),D=GM(s,E)}let b;this.getUniforms=function(){return b===void 0&&N(this),b};let D;this.getAttributes=function(){return D===void 0&&N(this),D};let q=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return q===!1&&(q=s.getProgramParameter(E,IM)),q},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(E),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=DM++,this.cacheKey=e,this.usedTimes=1,this.program=E,this.vertexShader=I,this.fragmentShader=O,this}var QM=0,ph=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new mh(e),t.set(e,n)),n}},mh=class{constructor(e){this.id=QM++,this.code=e,this.usedTimes=0}};function eb(i){return i===Yi||i===ea||i===ta}function tb(i,e,t,n,s,o){let l=new Gr,h=new ph,f=new Set,d=[],m=new Map,y=n.logarithmicDepthBuffer,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function S(b){return f.add(b),b===0?"uv":`uv${b}`}function E(b,D,q,k,Y,J){let ee=k.fog,z=Y.geometry,ie=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?k.environment:null,G=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,ne=e.get(b.envMap||ie,G),Se=g[b.type],re=n.precision;b.precision!==null&&(re=n.getMaxPrecision(b.precision),re!==b.precision&&Qe("WebGLProgram.getParameters:",b.precision,"not supported, using",re,"instead."));let H=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,ge=H!==void 0?H.length:0,We=0;z.morphAttributes.position!==void 0&&(We=1),z.morphAttributes.normal!==void 0&&(We=2),z.morphAttributes.color!==void 0&&(We=3);let it,ue,Fe,Pe;if(Se){let Oe=mi[Se];it=Oe.vertexShader,ue=Oe.fragmentShader}else{it=b.vertexShader,ue=b.fragmentShader;let Oe=h.getVertexShaderStage(b),Tt=h.getFragmentShaderStage(b);h.update(b,Oe,Tt),Fe=Oe.id,Pe=Tt.id}let je=i.getRenderTarget(),Ue=i.state.buffers.depth.getReversed(),ot=Y.isInstancedMesh===!0,Vt=Y.isBatchedMesh===!0,Ke=!!b.map,Et=!!b.matcap,Ct=!!ne,mt=Ct&&ne.isPMREMTexture===!0,Ht=!!b.aoMap,pt=!!b.lightMap,It=!!b.bumpMap&&b.wireframe===!1,Mt=!!b.normalMap,rn=!!b.displacementMap,De=!!b.emissiveMap,$e=!!b.metalnessMap,hn=!!b.roughnessMap,sn=b.anisotropy>0,W=b.clearcoat>0,vn=b.diffuseRoughness>0,Rt=b.dispersion>0,Ut=b.retroreflectivity>0,Le=b.iridescence>0,$t=b.sheen>0,Ze=b.transmission>0,Je=sn&&!!b.anisotropyMap,L=W&&!!b.clearcoatMap,T=W&&!!b.clearcoatNormalMap,Z=W&&!!b.clearcoatRoughnessMap,ve=vn&&!!b.diffuseRoughnessMap,de=Le&&!!b.iridescenceMap,pe=Le&&!!b.iridescenceThicknessMap,Me=$t&&!!b.sheenColorMap,ae=$t&&!!b.sheenRoughnessMap,le=!!b.specularMap,Ce=!!b.specularColorMap,B=!!b.specularIntensityMap,he=Ze&&!!b.transmissionMap,se=Ze&&!!b.thicknessMap,Re=!!b.gradientMap,Ee=!!b.alphaMap,Ae=b.alphaTest>0,Xe=!!b.alphaHash,ut=!!b.extensions,we=fi;b.toneMapped&&(je===null||je.isXRRenderTarget===!0)&&(we=i.toneMapping);let qe=mt?ne.isCompressedCubeTexture?ne.image[0].mipmaps:ne.mipmaps:null,dt={shaderID:Se,shaderType:b.type,shaderName:b.name,vertexShader:it,fragmentShader:ue,defines:b.defines,customVertexShaderID:Fe,customFragmentShaderID:Pe,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:re,batching:Vt,batchingColor:Vt&&Y._colorsTexture!==null,instancing:ot,instancingColor:ot&&Y.instanceColor!==null,instancingMorph:ot&&Y.morphTexture!==null,outputColorSpace:je===null?i.outputColorSpace:je.isXRRenderTarget===!0?je.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:Ke,matcap:Et,envMap:Ct,envMapMode:Ct&&ne.mapping,envMapPMREM:mt,envMapMaxLod:mt?qe.length-1:null,envMapSize:mt?qe[0].width:null,aoMap:Ht,lightMap:pt,bumpMap:It,normalMap:Mt,displacementMap:rn,emissiveMap:De,normalMapObjectSpace:Mt&&b.normalMapType===_d,normalMapTangentSpace:Mt&&b.normalMapType===na,packedNormalMap:Mt&&b.normalMapType===na&&eb(b.normalMap.format),metalnessMap:$e,roughnessMap:hn,anisotropy:sn,anisotropyMap:Je,clearcoat:W,clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:Z,diffuseRoughness:vn,diffuseRoughnessMap:ve,dispersion:Rt,retroreflection:Ut,iridescence:Le,iridescenceMap:de,iridescenceThicknessMap:pe,sheen:$t,sheenColorMap:Me,sheenRoughnessMap:ae,specularMap:le,specularColorMap:Ce,specularIntensityMap:B,transmission:Ze,transmissionMap:he,thicknessMap:se,gradientMap:Re,opaque:b.transparent===!1&&b.blending===Yr&&b.alphaToCoverage===!1,alphaMap:Ee,alphaTest:Ae,alphaHash:Xe,combine:b.combine,mapUv:Ke&&S(b.map.channel),aoMapUv:Ht&&S(b.aoMap.channel),lightMapUv:pt&&S(b.lightMap.channel),bumpMapUv:It&&S(b.bumpMap.channel),normalMapUv:Mt&&S(b.normalMap.channel),displacementMapUv:rn&&S(b.displacementMap.channel),emissiveMapUv:De&&S(b.emissiveMap.channel),metalnessMapUv:$e&&S(b.metalnessMap.channel),roughnessMapUv:hn&&S(b.roughnessMap.channel),anisotropyMapUv:Je&&S(b.anisotropyMap.channel),clearcoatMapUv:L&&S(b.clearcoatMap.channel),clearcoatNormalMapUv:T&&S(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&S(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ve&&S(b.diffuseRoughnessMap.channel),iridescenceMapUv:de&&S(b.iridescenceMap.channel),iridescenceThicknessMapUv:pe&&S(b.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&S(b.sheenColorMap.channel),sheenRoughnessMapUv:ae&&S(b.sheenRoughnessMap.channel),specularMapUv:le&&S(b.specularMap.channel),specularColorMapUv:Ce&&S(b.specularColorMap.channel),specularIntensityMapUv:B&&S(b.specularIntensityMap.channel),transmissionMapUv:he&&S(b.transmissionMap.channel),thicknessMapUv:se&&S(b.thicknessMap.channel),alphaMapUv:Ee&&S(b.alphaMap.channel),vertexTangents:!!z.attributes.tangent&&(Mt||sn),vertexNormals:!!z.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,pointsUvs:Y.isPoints===!0&&!!z.attributes.uv&&(Ke||Ee),fog:!!ee,useFog:b.fog===!0,fogExp2:!!ee&&ee.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||z.attributes.normal===void 0&&Mt===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:y,reversedDepthBuffer:Ue,skinning:Y.isSkinnedMesh===!0,hasPositionAttribute:z.attributes.position!==void 0,morphTargets:z.morphAttributes.position!==void 0,morphNormals:z.morphAttributes.normal!==void 0,morphColors:z.morphAttributes.color!==void 0,morphTargetsCount:ge,morphTextureStride:We,numSunLights:D.sun.length,numDirLights:D.directional.length,numPointLights:D.point.length,numSpotLights:D.spot.length,numSpotLightMaps:D.spotLightMap.length,numRectAreaLights:D.rectArea.length,numHemiLights:D.hemi.length,numSunLightShadows:D.sunShadowMap.length,numDirLightShadows:D.directionalShadowMap.length,numPointLightShadows:D.pointShadowMap.length,numSpotLightShadows:D.spotShadowMap.length,numSpotLightShadowsWithMaps:D.numSpotLightShadowsWithMaps,numLightProbes:D.numLightProbes,numLightProbeGrids:J.filter(Oe=>Oe.texture!==null).length,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&q.length>0,shadowMapType:i.shadowMap.type,toneMapping:we,decodeVideoTexture:Ke&&b.map.isVideoTexture===!0&&St.getTransfer(b.map.colorSpace)===Pt,decodeVideoTextureEmissive:De&&b.emissiveMap.isVideoTexture===!0&&St.getTransfer(b.emissiveMap.colorSpace)===Pt,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===di,flipSided:b.side===dn,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:ut&&b.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ut&&b.extensions.multiDraw===!0||Vt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return dt.vertexUv1s=f.has(1),dt.vertexUv2s=f.has(2),dt.vertexUv3s=f.has(3),f.clear(),dt}function R(b){let D=[];if(b.shaderID?D.push(b.shaderID):(D.push(b.customVertexShaderID),D.push(b.customFragmentShaderID)),b.defines!==void 0)for(let q in b.defines)D.push(q),D.push(b.defines[q]);return b.isRawShaderMaterial===!1&&(x(D,b),v(D,b),D.push(i.outputColorSpace)),D.push(b.customProgramCacheKey),D.join()}function x(b,D){b.push(D.precision),b.push(D.outputColorSpace),b.push(D.envMapMode),b.push(D.envMapPMREM),b.push(D.envMapMaxLod),b.push(D.envMapSize),b.push(D.mapUv),b.push(D.alphaMapUv),b.push(D.lightMapUv),b.push(D.aoMapUv),b.push(D.bumpMapUv),b.push(D.normalMapUv),b.push(D.displacementMapUv),b.push(D.emissiveMapUv),b.push(D.metalnessMapUv),b.push(D.roughnessMapUv),b.push(D.anisotropyMapUv),b.push(D.clearcoatMapUv),b.push(D.clearcoatNormalMapUv),b.push(D.clearcoatRoughnessMapUv),b.push(D.diffuseRoughnessMapUv),b.push(D.iridescenceMapUv),b.push(D.iridescenceThicknessMapUv),b.push(D.sheenColorMapUv),b.push(D.sheenRoughnessMapUv),b.push(D.specularMapUv),b.push(D.specularColorMapUv),b.push(D.specularIntensityMapUv),b.push(D.transmissionMapUv),b.push(D.thicknessMapUv),b.push(D.combine),b.push(D.fogExp2),b.push(D.sizeAttenuation),b.push(D.morphTargetsCount),b.push(D.numSunLights),b.push(D.numDirLights),b.push(D.numPointLights),b.push(D.numSpotLights),b.push(D.numSpotLightMaps),b.push(D.numHemiLights),b.push(D.numRectAreaLights),b.push(D.numSunLightShadows),b.push(D.numDirLightShadows),b.push(D.numPointLightShadows),b.push(D.numSpotLightShadows),b.push(D.numSpotLightShadowsWithMaps),b.push(D.numLightProbes),b.push(D.numLightProbeGrids),b.push(D.shadowMapType),b.push(D.toneMapping),b.push(D.numClippingPlanes),b.push(D.numClipIntersection),b.push(D.depthPacking)}function v(b,D){l.disableAll(),D.instancing&&l.enable(0),D.instancingColor&&l.enable(1),D.instancingMorph&&l.enable(2),D.matcap&&l.enable(3),D.envMap&&l.enable(4),D.normalMapObjectSpace&&l.enable(5),D.normalMapTangentSpace&&l.enable(6),D.clearcoat&&l.enable(7),D.iridescence&&l.enable(8),D.alphaTest&&l.enable(9),D.vertexColors&&l.enable(10),D.vertexAlphas&&l.enable(11),D.vertexUv1s&&l.enable(12),D.vertexUv2s&&l.enable(13),D.vertexUv3s&&l.enable(14),D.vertexTangents&&l.enable(15),D.anisotropy&&l.enable(16),D.alphaHash&&l.enable(17),D.batching&&l.enable(18),D.dispersion&&l.enable(19),D.retroreflection&&l.enable(24),D.diffuseRoughness&&l.enable(25),D.batchingColor&&l.enable(20),D.gradientMap&&l.enable(21),D.packedNormalMap&&l.enable(22),D.vertexNormals&&l.enable(23),b.push(l.mask),l.disableAll(),D.fog&&l.enable(0),D.useFog&&l.enable(1),D.flatShading&&l.enable(2),D.logarithmicDepthBuffer&&l.enable(3),D.reversedDepthBuffer&&l.enable(4),D.skinning&&l.enable(5),D.morphTargets&&l.enable(6),D.morphNormals&&l.enable(7),D.morphColors&&l.enable(8),D.premultipliedAlpha&&l.enable(9),D.shadowMapEnabled&&l.enable(10),D.doubleSided&&l.enable(11),D.flipSided&&l.enable(12),D.useDepthPacking&&l.enable(13),D.dithering&&l.enable(14),D.transmission&&l.enable(15),D.sheen&&l.enable(16),D.opaque&&l.enable(17),D.pointsUvs&&l.enable(18),D.decodeVideoTexture&&l.enable(19),D.decodeVideoTextureEmissive&&l.enable(20),D.alphaToCoverage&&l.enable(21),D.numLightProbeGrids>0&&l.enable(22),D.hasPositionAttribute&&l.enable(23),b.push(l.mask)}function P(b){let D=g[b.type],q;if(D){let k=mi[D];q=Dd.clone(k.uniforms)}else q=b.uniforms;return q}function U(b,D){let q=m.get(D);return q!==void 0?++q.usedTimes:(q=new KM(i,D,b,s),d.push(q),m.set(D,q)),q}function I(b){if(--b.usedTimes===0){let D=d.indexOf(b);d[D]=d[d.length-1],d.pop(),m.delete(b.cacheKey),b.destroy()}}function O(b){h.remove(b)}function N(){h.dispose()}return{getParameters:E,getProgramCacheKey:R,getUniforms:P,acquireProgram:U,releaseProgram:I,releaseShaderCache:O,programs:d,dispose:N}}function nb(){let i=new WeakMap;function e(l){return i.has(l)}function t(l){let h=i.get(l);return h===void 0&&(h={},i.set(l,h)),h}function n(l){i.delete(l)}function s(l,h,f){i.get(l)[h]=f}function o(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:o}}function ib(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Kd(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Qd(){let i=[],e=0,t=[],n=[],s=[];function o(){e=0,t.length=0,n.length=0,s.length=0}function l(g){let S=0;return g.isInstancedMesh&&(S+=2),g.isSkinnedMesh&&(S+=1),S}function h(g,S,E,R,x,v){let P=i[e];return P===void 0?(P={id:g.id,object:g,geometry:S,material:E,materialVariant:l(g),groupOrder:R,renderOrder:g.renderOrder,z:x,group:v},i[e]=P):(P.id=g.id,P.object=g,P.geometry=S,P.material=E,P.materialVariant=l(g),P.groupOrder=R,P.renderOrder=g.renderOrder,P.z=x,P.group=v),e++,P}function f(g,S,E,R,x,v,P){P.reversedDepth===!0&&(x=-x);let U=h(g,S,E,R,x,v);E.transmission>0?n.push(U):E.transparent===!0?s.push(U):t.push(U)}function d(g,S,E,R,x,v){let P=h(g,S,E,R,x,v);E.transmission>0?n.unshift(P):E.transparent===!0?s.unshift(P):t.unshift(P)}function m(g,S){t.length>1&&t.sort(g||ib),n.length>1&&n.sort(S||Kd),s.length>1&&s.sort(S||Kd)}function y(){for(let g=e,S=i.length;g<S;g++){let E=i[g];if(E.id===null)break;E.id=null,E.object=null,E.geometry=null,E.material=null,E.group=null}}return{opaque:t,transmissive:n,transparent:s,init:o,push:f,unshift:d,finish:y,sort:m}}function rb(){let i=new WeakMap;function e(n,s){let o=i.get(n),l;return o===void 0?(l=new Qd,i.set(n,[l])):s>=o.length?(l=new Qd,o.push(l)):l=o[s],l}function t(){i=new WeakMap}return{get:e,dispose:t}}function sb(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new j,color:new ht};break;case"SpotLight":t={position:new j,direction:new j,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new j,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new j,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new j,halfWidth:new j,halfHeight:new j};break}return i[e.id]=t,t}}}function ab(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var ob=0;function lb(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function cb(i){let e=new sb,t=ab(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let d=0;d<9;d++)n.probe.push(new j);let s=new j,o=new Lt,l=new Lt;function h(d){let m=0,y=0,g=0;for(let J=0;J<9;J++)n.probe[J].set(0,0,0);let S=0,E=0,R=0,x=0,v=0,P=0,U=0,I=0,O=0,N=0,b=0,D=0,q=0,k=0;d.sort(lb);for(let J=0,ee=d.length;J<ee;J++){let z=d[J],ie=z.color,G=z.intensity,ne=z.distance,Se=null;if(z.shadow&&z.shadow.map&&(z.shadow.map.texture.format===Yi?Se=z.shadow.map.texture:Se=z.shadow.map.depthTexture||z.shadow.map.texture),z.isAmbientLight)m+=ie.r*G,y+=ie.g*G,g+=ie.b*G;else if(z.isLightProbe){for(let re=0;re<9;re++)n.probe[re].addScaledVector(z.sh.coefficients[re],G);k++}else if(z.isSunLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize.copy(H.mapSize).multiply(H.getFrameExtents()),n.sunShadow[E]=ge,n.sunShadowMap[E]=Se;let We=H.getViewportCount();for(let it=0;it<We;it++)n.sunShadowMatrix[R+it]=H.getMatrix(it),n.sunShadowCascade[R+it]=H._cascadeData[it];R+=We,E++}n.sun[S]=re,S++}else if(z.isDirectionalLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.directionalShadow[x]=ge,n.directionalShadowMap[x]=Se,n.directionalShadowMatrix[x]=z.shadow.matrix,O++}n.directional[x]=re,x++}else if(z.isSpotLight){let re=e.get(z);re.position.setFromMatrixPosition(z.matrixWorld),re.color.copy(ie).multiplyScalar(G),re.distance=ne,re.coneCos=Math.cos(z.angle),re.penumbraCos=Math.cos(z.angle*(1-z.penumbra)),re.decay=z.decay,n.spot[P]=re;let H=z.shadow;if(z.map&&(n.spotLightMap[D]=z.map,D++,H.updateMatrices(z),z.castShadow&&q++),n.spotLightMatrix[P]=H.matrix,z.castShadow){let ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.spotShadow[P]=ge,n.spotShadowMap[P]=Se,b++}P++}else if(z.isRectAreaLight){let re=e.get(z);re.color.copy(ie).multiplyScalar(G),re.halfWidth.set(z.width*.5,0,0),re.halfHeight.set(0,z.height*.5,0),n.rectArea[U]=re,U++}else if(z.isPointLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),re.distance=z.distance,re.decay=z.decay,z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,ge.shadowCameraNear=H.camera.near,ge.shadowCameraFar=H.camera.far,n.pointShadow[v]=ge,n.pointShadowMap[v]=Se,n.pointShadowMatrix[v]=z.shadow.matrix,N++}n.point[v]=re,v++}else if(z.isHemisphereLight){let re=e.get(z);re.skyColor.copy(z.color).multiplyScalar(G),re.groundColor.copy(z.groundColor).multiplyScalar(G),n.hemi[I]=re,I++}}U>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Be.LTC_FLOAT_1,n.rectAreaLTC2=Be.LTC_FLOAT_2):(n.rectAreaLTC1=Be.LTC_HALF_1,n.rectAreaLTC2=Be.LTC_HALF_2)),n.ambient[0]=m,n.ambient[1]=y,n.ambient[2]=g;let Y=n.hash;(Y.sunLength!==S||Y.directionalLength!==x||Y.pointLength!==v||Y.spotLength!==P||Y.rectAreaLength!==U||Y.hemiLength!==I||Y.numSunShadows!==E||Y.numDirectionalShadows!==O||Y.numPointShadows!==N||Y.numSpotShadows!==b||Y.numSpotMaps!==D||Y.numLightProbes!==k)&&(n.sun.length=S,n.directional.length=x,n.spot.length=P,n.rectArea.length=U,n.point.length=v,n.hemi.length=I,n.sunShadow.length=E,n.sunShadowMap.length=E,n.sunShadowMatrix.length=R,n.sunShadowCascade.length=R,n.directionalShadow.length=O,n.directionalShadowMap.length=O,n.directionalShadowMatrix.length=O,n.pointShadow.length=N,n.pointShadowMap.length=N,n.pointShadowMatrix.length=N,n.spotShadow.length=b,n.spotShadowMap.length=b,n.spotLightMatrix.length=b+D-q,n.spotLightMap.length=D,n.numSpotLightShadowsWithMaps=q,n.numLightProbes=k,Y.sunLength=S,Y.directionalLength=x,Y.pointLength=v,Y.spotLength=P,Y.rectAreaLength=U,Y.hemiLength=I,Y.numSunShadows=E,Y.numDirectionalShadows=O,Y.numPointShadows=N,Y.numSpotShadows=b,Y.numSpotMaps=D,Y.numLightProbes=k,n.version=ob++)}function f(d,m){let y=0,g=0,S=0,E=0,R=0,x=0,v=m.matrixWorldInverse;for(let P=0,U=d.length;P<U;P++){let I=d[P];if(I.isSunLight){let O=n.sun[y];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(v),y++}else if(I.isDirectionalLight){let O=n.directional[g];O.direction.setFromMatrixPosition(I.matrixWorld),s.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(s),O.direction.transformDirection(v),g++}else if(I.isSpotLight){let O=n.spot[E];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(v),O.direction.setFromMatrixPosition(I.matrixWorld),s.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(s),O.direction.transformDirection(v),E++}else if(I.isRectAreaLight){let O=n.rectArea[R];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(v),l.identity(),o.copy(I.matrixWorld),o.premultiply(v),l.extractRotation(o),O.halfWidth.set(I.width*.5,0,0),O.halfHeight.set(0,I.height*.5,0),O.halfWidth.applyMatrix4(l),O.halfHeight.applyMatrix4(l),R++}else if(I.isPointLight){let O=n.point[S];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(v),S++}else if(I.isHemisphereLight){let O=n.hemi[x];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(v),x++}}}return{setup:h,setupView:f,state:n}}function ef(i){let e=new cb(i),t=[],n=[],s=[];function o(y){m.camera=y,t.length=0,n.length=0,s.length=0}function l(y){y.isLightProbeGrid?s.push(y):t.push(y)}function h(y){n.push(y)}function f(){e.setup(t),s.sort((y,g)=>y.priority-g.priority||y.id-g.id)}function d(y){e.setupView(t,y)}let m={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:o,state:m,setupLights:f,setupLightsView:d,pushLight:l,pushShadow:h}}function hb(i){let e=new WeakMap;function t(s,o=0){let l=e.get(s),h;return l===void 0?(h=new ef(i),e.set(s,[h])):o>=l.length?(h=new ef(i),l.push(h)):h=l[o],h}function n(){e=new WeakMap}return{get:t,dispose:n}}var ub=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,db=`uniform sampler2D shadow_pass;
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
}`,fb=[new j(1,0,0),new j(-1,0,0),new j(0,1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1)],pb=[new j(0,-1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1),new j(0,-1,0),new j(0,-1,0)],tf=new Lt,ia=new j,ch=new j;function mb(i,e,t){let n=new zi,s=new et,o=new et,l=new Gt,h=new bo,f=new wo,d={},m=t.maxTextureSize,y={[qi]:dn,[dn]:qi,[di]:di},g=new ui({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new et},radius:{value:4}},vertexShader:ub,fragmentShader:db}),S=g.clone();S.defines.HORIZONTAL_PASS=1;let E=new wn;E.setAttribute("position",new In(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let R=new zt(E,g),x=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=hr;let v=this.type;this.render=function(N,b,D){if(x.enabled===!1||x.autoUpdate===!1&&x.needsUpdate===!1||N.length===0)return;this.type===Yu&&(Qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=hr);let q=i.getRenderTarget(),k=i.getActiveCubeFace(),Y=i.getActiveMipmapLevel(),J=i.state;J.setBlending(ur),J.buffers.depth.getReversed()===!0?J.buffers.color.setClear(0,0,0,0):J.buffers.color.setClear(1,1,1,1),J.buffers.depth.setTest(!0),J.setScissorTest(!1);let ee=v!==this.type;ee&&b.traverse(function(z){z.material&&(Array.isArray(z.material)?z.material.forEach(ie=>ie.needsUpdate=!0):z.material.needsUpdate=!0)});for(let z=0,ie=N.length;z<ie;z++){let G=N[z],ne=G.shadow;if(ne===void 0){Qe("WebGLShadowMap:",G,"has no shadow.");continue}if(ne.autoUpdate===!1&&ne.needsUpdate===!1)continue;s.copy(ne.mapSize);let Se=ne.getFrameExtents();s.multiply(Se),o.copy(ne.mapSize),(s.x>m||s.y>m)&&(s.x>m&&(o.x=Math.floor(m/Se.x),s.x=o.x*Se.x,ne.mapSize.x=o.x),s.y>m&&(o.y=Math.floor(m/Se.y),s.y=o.y*Se.y,ne.mapSize.y=o.y));let re=i.state.buffers.depth.getReversed();if(ne.camera._reversedDepth=re,ne.map===null||ee===!0){if(ne.map!==null&&(ne.map.depthTexture!==null&&(ne.map.depthTexture.dispose(),ne.map.depthTexture=null),ne.map.dispose()),this.type===qr){if(G.isPointLight){Qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}ne.map=new Dn(s.x,s.y,{format:Yi,type:jn,minFilter:Sn,magFilter:Sn,generateMipmaps:!1}),ne.map.texture.name=G.name+".shadowMap",ne.map.depthTexture=new Ti(s.x,s.y,zn),ne.map.depthTexture.name=G.name+".shadowMapDepth",ne.map.depthTexture.format=wi,ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn}else G.isPointLight?(ne.map=new sa(s.x),ne.map.depthTexture=new Fs(s.x,Yn)):(ne.map=new Dn(s.x,s.y),ne.map.depthTexture=new Ti(s.x,s.y,Yn)),ne.map.depthTexture.name=G.name+".shadowMap",ne.map.depthTexture.format=wi,this.type===hr?(ne.map.depthTexture.compareFunction=re?Zc:jc,ne.map.depthTexture.minFilter=Sn,ne.map.depthTexture.magFilter=Sn):(ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn);ne.camera.updateProjectionMatrix()}ne.map.isWebGLCubeRenderTarget!==!0&&(ne.map.width!==s.x||ne.map.height!==s.y)&&ne.map.setSize(s.x,s.y);let H=ne.map.isWebGLCubeRenderTarget?6:ne.getViewportCount();G.isPointLight!==!0&&ne.updateMatrices(G,D);let ge=(ne.camera.layers.mask&4294967294)!==0?ne.camera.layers:D.layers;for(let We=0;We<H;We++){let it=ne.getCamera(We);if(G.isPointLight){let ue=ne.camera,Fe=ne.matrix,Pe=G.distance||ue.far;Pe!==ue.far&&(ue.far=Pe,ue.updateProjectionMatrix()),ia.setFromMatrixPosition(G.matrixWorld),ue.position.copy(ia),ch.copy(ue.position),ch.add(fb[We]),ue.up.copy(pb[We]),ue.lookAt(ch),ue.updateMatrixWorld(),Fe.makeTranslation(-ia.x,-ia.y,-ia.z),tf.multiplyMatrices(ue.projectionMatrix,ue.matrixWorldInverse),ne._frustum.setFromProjectionMatrix(tf,ue.coordinateSystem,ue.reversedDepth)}if(ne.map.isWebGLCubeRenderTarget)i.setRenderTarget(ne.map,We),i.clear();else{We===0&&(i.setRenderTarget(ne.map),i.clear());let ue=ne.getViewport(We);l.set(o.x*ue.x,o.y*ue.y,o.x*ue.z,o.y*ue.w),J.viewport(l)}n=ne.getFrustum(We),I(b,D,it,G,ge,this.type)}ne.isPointLightShadow!==!0&&this.type===qr&&P(ne,D),ne.needsUpdate=!1}v=this.type,x.needsUpdate=!1,i.setRenderTarget(q,k,Y)};function P(N,b){let D=e.update(R);g.defines.VSM_SAMPLES!==N.blurSamples&&(g.defines.VSM_SAMPLES=N.blurSamples,S.defines.VSM_SAMPLES=N.blurSamples,g.needsUpdate=!0,S.needsUpdate=!0),N.mapPass===null?N.mapPass=new Dn(s.x,s.y,{format:Yi,type:jn}):(N.mapPass.width!==N.map.width||N.mapPass.height!==N.map.height)&&N.mapPass.setSize(N.map.width,N.map.height),g.uniforms.shadow_pass.value=N.map.depthTexture,g.uniforms.resolution.value.set(N.map.width,N.map.height),g.uniforms.radius.value=N.radius,i.setRenderTarget(N.mapPass),i.clear(),i.renderBufferDirect(b,null,D,g,R,null),S.uniforms.shadow_pass.value=N.mapPass.texture,S.uniforms.resolution.value.set(N.map.width,N.map.height),S.uniforms.radius.value=N.radius,i.setRenderTarget(N.map),i.clear(),i.renderBufferDirect(b,null,D,S,R,null)}function U(N,b,D,q){let k=null,Y=D.isPointLight===!0?N.customDistanceMaterial:N.customDepthMaterial;if(Y!==void 0)k=Y;else if(k=D.isPointLight===!0?f:h,i.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let J=k.uuid,ee=b.uuid,z=d[J];z===void 0&&(z={},d[J]=z);let ie=z[ee];ie===void 0&&(ie=k.clone(),z[ee]=ie,b.addEventListener("dispose",O)),k=ie}if(k.visible=b.visible,k.wireframe=b.wireframe,q===qr?k.side=b.shadowSide!==null?b.shadowSide:b.side:k.side=b.shadowSide!==null?b.shadowSide:y[b.side],k.alphaMap=b.alphaMap,k.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,k.map=b.map,k.clipShadows=b.clipShadows,k.clippingPlanes=b.clippingPlanes,k.clipIntersection=b.clipIntersection,k.displacementMap=b.displacementMap,k.displacementScale=b.displacementScale,k.displacementBias=b.displacementBias,k.wireframeLinewidth=b.wireframeLinewidth,k.linewidth=b.linewidth,D.isPointLight===!0&&k.isMeshDistanceMaterial===!0){let J=i.properties.get(k);J.light=D}return k}function I(N,b,D,q,k,Y){if(N.visible===!1)return;if(N.layers.test(k)&&(N.isMesh||N.isLine||N.isPoints)&&(N.castShadow||N.receiveShadow&&Y===qr)&&(!N.frustumCulled||N.intersectsFrustum(n))){N.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,N.matrixWorld);let z=e.update(N),ie=N.material;if(Array.isArray(ie)){let G=z.groups;for(let ne=0,Se=G.length;ne<Se;ne++){let re=G[ne],H=ie[re.materialIndex];if(H&&H.visible){let ge=U(N,H,q,Y);N.onBeforeShadow(i,N,b,D,z,ge,re),i.renderBufferDirect(D,null,z,ge,N,re),N.onAfterShadow(i,N,b,D,z,ge,re)}}}else if(ie.visible){let G=U(N,ie,q,Y);N.onBeforeShadow(i,N,b,D,z,G,null),i.renderBufferDirect(D,null,z,G,N,null),N.onAfterShadow(i,N,b,D,z,G,null)}}let ee=N.children;for(let z=0,ie=ee.length;z<ie;z++)I(ee[z],b,D,q,k,Y)}function O(N){N.target.removeEventListener("dispose",O);for(let D in d){let q=d[D],k=N.target.uuid;k in q&&(q[k].dispose(),delete q[k])}}}function gb(i,e){function t(){let B=!1,he=new Gt,se=null,Re=new Gt(0,0,0,0);return{setMask:function(Ee){se!==Ee&&!B&&(i.colorMask(Ee,Ee,Ee,Ee),se=Ee)},setLocked:function(Ee){B=Ee},setClear:function(Ee,Ae,Xe,ut,we){we===!0&&(Ee*=ut,Ae*=ut,Xe*=ut),he.set(Ee,Ae,Xe,ut),Re.equals(he)===!1&&(i.clearColor(Ee,Ae,Xe,ut),Re.copy(he))},reset:function(){B=!1,se=null,Re.set(-1,0,0,0)}}}function n(){let B=!1,he=!1,se=null,Re=null,Ee=null;return{setReversed:function(Ae){if(he!==Ae){let Xe=e.get("EXT_clip_control");Ae?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),he=Ae;let ut=Ee;Ee=null,this.setClear(ut)}},getReversed:function(){return he},setTest:function(Ae){Ae?Ue(i.DEPTH_TEST):ot(i.DEPTH_TEST)},setMask:function(Ae){se!==Ae&&!B&&(i.depthMask(Ae),se=Ae)},setFunc:function(Ae){if(he&&(Ae=Cd[Ae]),Re!==Ae){switch(Ae){case ro:i.depthFunc(i.NEVER);break;case so:i.depthFunc(i.ALWAYS);break;case ao:i.depthFunc(i.LESS);break;case Nr:i.depthFunc(i.LEQUAL);break;case oo:i.depthFunc(i.EQUAL);break;case lo:i.depthFunc(i.GEQUAL);break;case co:i.depthFunc(i.GREATER);break;case ho:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ae}},setLocked:function(Ae){B=Ae},setClear:function(Ae){Ee!==Ae&&(Ee=Ae,he&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){B=!1,se=null,Re=null,Ee=null,he=!1}}}function s(){let B=!1,he=null,se=null,Re=null,Ee=null,Ae=null,Xe=null,ut=null,we=null;return{setTest:function(qe){B||(qe?Ue(i.STENCIL_TEST):ot(i.STENCIL_TEST))},setMask:function(qe){he!==qe&&!B&&(i.stencilMask(qe),he=qe)},setFunc:function(qe,dt,Oe){(se!==qe||Re!==dt||Ee!==Oe)&&(i.stencilFunc(qe,dt,Oe),se=qe,Re=dt,Ee=Oe)},setOp:function(qe,dt,Oe){(Ae!==qe||Xe!==dt||ut!==Oe)&&(i.stencilOp(qe,dt,Oe),Ae=qe,Xe=dt,ut=Oe)},setLocked:function(qe){B=qe},setClear:function(qe){we!==qe&&(i.clearStencil(qe),we=qe)},reset:function(){B=!1,he=null,se=null,Re=null,Ee=null,Ae=null,Xe=null,ut=null,we=null}}}let o=new t,l=new n,h=new s,f={},d=new WeakMap,m={},y={},g={},S=new WeakMap,E=[],R=null,x=!1,v=null,P=null,U=null,I=null,O=null,N=null,b=null,D=new ht(0,0,0),q=0,k=!1,Y=null,J=null,ee=null,z=null,ie=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),ne=!1,Se=0,re=i.getParameter(i.VERSION);re.indexOf("WebGL")!==-1?(Se=parseFloat(/^WebGL (\d)/.exec(re)[1]),ne=Se>=1):re.indexOf("OpenGL ES")!==-1&&(Se=parseFloat(/^OpenGL ES (\d)/.exec(re)[1]),ne=Se>=2);let H=null,ge={},We=i.getParameter(i.SCISSOR_BOX),it=i.getParameter(i.VIEWPORT),ue=new Gt().fromArray(We),Fe=new Gt().fromArray(it);function Pe(B,he,se,Re){let Ee=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(B,Ae),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xe=0;Xe<se;Xe++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(he,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,Ee):i.texImage2D(he+Xe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Ee);return Ae}let je={};je[i.TEXTURE_2D]=Pe(i.TEXTURE_2D,i.TEXTURE_2D,1),je[i.TEXTURE_CUBE_MAP]=Pe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),je[i.TEXTURE_2D_ARRAY]=Pe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),je[i.TEXTURE_3D]=Pe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),o.setClear(0,0,0,1),l.setClear(1),h.setClear(0),Ue(i.DEPTH_TEST),l.setFunc(Nr),It(!1),Mt(Pc),Ue(i.CULL_FACE),Ht(ur);function Ue(B){m[B]!==!0&&(i.enable(B),m[B]=!0)}function ot(B){m[B]!==!1&&(i.disable(B),m[B]=!1)}function Vt(B,he){return g[B]!==he?(i.bindFramebuffer(B,he),g[B]=he,B===i.DRAW_FRAMEBUFFER&&(g[i.FRAMEBUFFER]=he),B===i.FRAMEBUFFER&&(g[i.DRAW_FRAMEBUFFER]=he),!0):!1}function Ke(B,he){let se=E,Re=!1;if(B){se=S.get(he),se===void 0&&(se=[],S.set(he,se));let Ee=B.textures;if(se.length!==Ee.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Xe=Ee.length;Ae<Xe;Ae++)se[Ae]=i.COLOR_ATTACHMENT0+Ae;se.length=Ee.length,Re=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,Re=!0);Re&&i.drawBuffers(se)}function Et(B){return R!==B?(i.useProgram(B),R=B,!0):!1}let Ct={[dr]:i.FUNC_ADD,[Zu]:i.FUNC_SUBTRACT,[Ju]:i.FUNC_REVERSE_SUBTRACT};Ct[Ku]=i.MIN,Ct[Qu]=i.MAX;let mt={[ed]:i.ZERO,[td]:i.ONE,[nd]:i.SRC_COLOR,[Fc]:i.SRC_ALPHA,[ld]:i.SRC_ALPHA_SATURATE,[ad]:i.DST_COLOR,[rd]:i.DST_ALPHA,[id]:i.ONE_MINUS_SRC_COLOR,[Nc]:i.ONE_MINUS_SRC_ALPHA,[od]:i.ONE_MINUS_DST_COLOR,[sd]:i.ONE_MINUS_DST_ALPHA,[cd]:i.CONSTANT_COLOR,[hd]:i.ONE_MINUS_CONSTANT_COLOR,[ud]:i.CONSTANT_ALPHA,[dd]:i.ONE_MINUS_CONSTANT_ALPHA};function Ht(B,he,se,Re,Ee,Ae,Xe,ut,we,qe){if(B===ur){x===!0&&(ot(i.BLEND),x=!1);return}if(x===!1&&(Ue(i.BLEND),x=!0),B!==ju){if(B!==v||qe!==k){if((P!==dr||O!==dr)&&(i.blendEquation(i.FUNC_ADD),P=dr,O=dr),qe)switch(B){case Yr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ic:i.blendFunc(i.ONE,i.ONE);break;case Dc:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Lc:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",B);break}else switch(B){case Yr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ic:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Dc:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Lc:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",B);break}U=null,I=null,N=null,b=null,D.set(0,0,0),q=0,v=B,k=qe}return}Ee=Ee||he,Ae=Ae||se,Xe=Xe||Re,(he!==P||Ee!==O)&&(i.blendEquationSeparate(Ct[he],Ct[Ee]),P=he,O=Ee),(se!==U||Re!==I||Ae!==N||Xe!==b)&&(i.blendFuncSeparate(mt[se],mt[Re],mt[Ae],mt[Xe]),U=se,I=Re,N=Ae,b=Xe),(ut.equals(D)===!1||we!==q)&&(i.blendColor(ut.r,ut.g,ut.b,we),D.copy(ut),q=we),v=B,k=!1}function pt(B,he){B.side===di?ot(i.CULL_FACE):Ue(i.CULL_FACE);let se=B.side===dn;he&&(se=!se),It(se),B.blending===Yr&&B.transparent===!1?Ht(ur):Ht(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),l.setFunc(B.depthFunc),l.setTest(B.depthTest),l.setMask(B.depthWrite),o.setMask(B.colorWrite);let Re=B.stencilWrite;h.setTest(Re),Re&&(h.setMask(B.stencilWriteMask),h.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),h.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),De(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Ue(i.SAMPLE_ALPHA_TO_COVERAGE):ot(i.SAMPLE_ALPHA_TO_COVERAGE)}function It(B){Y!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),Y=B)}function Mt(B){B!==$u?(Ue(i.CULL_FACE),B!==J&&(B===Pc?i.cullFace(i.BACK):B===qu?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):ot(i.CULL_FACE),J=B}function rn(B){B!==ee&&(ne&&i.lineWidth(B),ee=B)}function De(B,he,se){B?(Ue(i.POLYGON_OFFSET_FILL),(z!==he||ie!==se)&&(z=he,ie=se,l.getReversed()&&(he=-he,se=-se),i.polygonOffset(he,se))):ot(i.POLYGON_OFFSET_FILL)}function $e(B){B?Ue(i.SCISSOR_TEST):ot(i.SCISSOR_TEST)}function hn(B){B===void 0&&(B=i.TEXTURE0+G-1),H!==B&&(i.activeTexture(B),H=B)}function sn(B,he,se){se===void 0&&(H===null?se=i.TEXTURE0+G-1:se=H);let Re=ge[se];Re===void 0&&(Re={type:void 0,texture:void 0},ge[se]=Re),(Re.type!==B||Re.texture!==he)&&(H!==se&&(i.activeTexture(se),H=se),i.bindTexture(B,he||je[B]),Re.type=B,Re.texture=he)}function W(){let B=ge[H];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function vn(){try{i.compressedTexImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Rt(){try{i.compressedTexImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function Ut(){try{i.texSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Le(){try{i.texSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function $t(){try{i.compressedTexSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Ze(){try{i.compressedTexSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function Je(){try{i.texStorage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function L(){try{i.texStorage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function T(){try{i.texImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Z(){try{i.texImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function ve(B){return y[B]!==void 0?y[B]:i.getParameter(B)}function de(B,he){y[B]!==he&&(i.pixelStorei(B,he),y[B]=he)}function pe(B){ue.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),ue.copy(B))}function Me(B){Fe.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),Fe.copy(B))}function ae(B,he){let se=d.get(he);se===void 0&&(se=new WeakMap,d.set(he,se));let Re=se.get(B);Re===void 0&&(Re=i.getUniformBlockIndex(he,B.name),i.uniformBlockBinding(he,Re,Re),se.set(B,Re))}function le(B,he,se){let Ee=d.get(he).get(B);f[Ee]!==se&&(i.bindBufferBase(i.UNIFORM_BUFFER,Ee,se),f[Ee]=se)}function Ce(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),l.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),m={},y={},H=null,ge={},g={},f={},S=new WeakMap,E=[],R=null,x=!1,v=null,P=null,U=null,I=null,O=null,N=null,b=null,D=new ht(0,0,0),q=0,k=!1,Y=null,J=null,ee=null,z=null,ie=null,ue.set(0,0,i.canvas.width,i.canvas.height),Fe.set(0,0,i.canvas.width,i.canvas.height),o.reset(),l.reset(),h.reset()}return{buffers:{color:o,depth:l,stencil:h},enable:Ue,disable:ot,bindFramebuffer:Vt,drawBuffers:Ke,useProgram:Et,setBlending:Ht,setMaterial:pt,setFlipSided:It,setCullFace:Mt,setLineWidth:rn,setPolygonOffset:De,setScissorTest:$e,activeTexture:hn,bindTexture:sn,unbindTexture:W,compressedTexImage2D:vn,compressedTexImage3D:Rt,texImage2D:T,texImage3D:Z,pixelStorei:de,getParameter:ve,updateUBOMapping:ae,uniformBlockBinding:le,texStorage2D:Je,texStorage3D:L,texSubImage2D:Ut,texSubImage3D:Le,compressedTexSubImage2D:$t,compressedTexSubImage3D:Ze,scissor:pe,viewport:Me,reset:Ce}}function _b(i,e,t,n,s,o,l){let h=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,f=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),d=new et,m=new WeakMap,y=new Set,g,S=new WeakMap,E=new Set,R=new FinalizationRegistry(L=>E.delete(L)),x=!1;try{x=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(L,T){return x?new OffscreenCanvas(L,T):Ms("canvas")}function P(L,T,Z){let ve=1,de=Je(L);if((de.width>Z||de.height>Z)&&(ve=Z/Math.max(de.width,de.height)),ve<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let pe=Math.floor(ve*de.width),Me=Math.floor(ve*de.height);g===void 0&&(g=v(pe,Me));let ae=T?v(pe,Me):g;return ae.width=pe,ae.height=Me,ae.getContext("2d").drawImage(L,0,0,pe,Me),Qe("WebGLRenderer: Texture has been resized from ("+de.width+"x"+de.height+") to ("+pe+"x"+Me+")."),ae}else return"data"in L&&Qe("WebGLRenderer: Image in DataTexture is too big ("+de.width+"x"+de.height+")."),L;return L}function U(L){return L.generateMipmaps}function I(L){i.generateMipmap(L)}function O(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function N(L,T,Z,ve,de,pe=!1){if(L!==null){if(i[L]!==void 0)return i[L];Qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let Me;ve&&(Me=e.get("EXT_texture_norm16"),Me||Qe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ae=T;if(T===i.RED&&(Z===i.FLOAT&&(ae=i.R32F),Z===i.HALF_FLOAT&&(ae=i.R16F),Z===i.UNSIGNED_BYTE&&(ae=i.R8),Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.R16_EXT),Z===i.SHORT&&Me&&(ae=Me.R16_SNORM_EXT)),T===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.R8UI),Z===i.UNSIGNED_SHORT&&(ae=i.R16UI),Z===i.UNSIGNED_INT&&(ae=i.R32UI),Z===i.BYTE&&(ae=i.R8I),Z===i.SHORT&&(ae=i.R16I),Z===i.INT&&(ae=i.R32I)),T===i.RG&&(Z===i.FLOAT&&(ae=i.RG32F),Z===i.HALF_FLOAT&&(ae=i.RG16F),Z===i.UNSIGNED_BYTE&&(ae=i.RG8),Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.RG16_EXT),Z===i.SHORT&&Me&&(ae=Me.RG16_SNORM_EXT)),T===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.RG8UI),Z===i.UNSIGNED_SHORT&&(ae=i.RG16UI),Z===i.UNSIGNED_INT&&(ae=i.RG32UI),Z===i.BYTE&&(ae=i.RG8I),Z===i.SHORT&&(ae=i.RG16I),Z===i.INT&&(ae=i.RG32I)),T===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(ae=i.RGB16UI),Z===i.UNSIGNED_INT&&(ae=i.RGB32UI),Z===i.BYTE&&(ae=i.RGB8I),Z===i.SHORT&&(ae=i.RGB16I),Z===i.INT&&(ae=i.RGB32I)),T===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(ae=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(ae=i.RGBA16UI),Z===i.UNSIGNED_INT&&(ae=i.RGBA32UI),Z===i.BYTE&&(ae=i.RGBA8I),Z===i.SHORT&&(ae=i.RGBA16I),Z===i.INT&&(ae=i.RGBA32I)),T===i.RGB&&(Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGB16_EXT),Z===i.SHORT&&Me&&(ae=Me.RGB16_SNORM_EXT),Z===i.UNSIGNED_INT_5_9_9_9_REV&&(ae=i.RGB9_E5),Z===i.UNSIGNED_INT_10F_11F_11F_REV&&(ae=i.R11F_G11F_B10F)),T===i.RGBA){let le=pe?Ss:St.getTransfer(de);Z===i.FLOAT&&(ae=i.RGBA32F),Z===i.HALF_FLOAT&&(ae=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(ae=le===Pt?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGBA16_EXT),Z===i.SHORT&&Me&&(ae=Me.RGBA16_SNORM_EXT),Z===i.UNSIGNED_SHORT_4_4_4_4&&(ae=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(ae=i.RGB5_A1)}return(ae===i.R16F||ae===i.R32F||ae===i.RG16F||ae===i.RG32F||ae===i.RGBA16F||ae===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ae}function b(L,T){let Z;return L?T===null||T===Yn||T===pr?Z=i.DEPTH24_STENCIL8:T===zn?Z=i.DEPTH32F_STENCIL8:T===Zr&&(Z=i.DEPTH24_STENCIL8,Qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Yn||T===pr?Z=i.DEPTH_COMPONENT24:T===zn?Z=i.DEPTH_COMPONENT32F:T===Zr&&(Z=i.DEPTH_COMPONENT16),Z}function D(L,T){return U(L)===!0||L.isFramebufferTexture&&L.minFilter!==cn&&L.minFilter!==Sn?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?T.mipmaps.length:1}function q(L){let T=new WeakRef(L);n.get(L).__ref=T,E.add(T),R.register(L,T,T)}function k(L){let T=n.get(L).__ref;T!==void 0&&(E.delete(T),R.unregister(T))}function Y(L){ee(L.target)}function J(L){z(L.target)}function ee(L){L.removeEventListener("dispose",Y),k(L),G(L),L.isVideoTexture&&m.delete(L),L.isHTMLTexture&&y.delete(L)}function z(L){L.removeEventListener("dispose",J),k(L),Se(L)}function ie(){for(let L of E){let T=L.deref();T!==void 0&&(T.isRenderTarget===!0?z(T):ee(T))}E.clear(),y.clear()}function G(L){let T=n.get(L);if(T.__webglInit===void 0)return;let Z=L.source,ve=S.get(Z);if(ve){let de=ve[T.__cacheKey];de.usedTimes--,de.usedTimes===0&&ne(L),Object.keys(ve).length===0&&S.delete(Z)}n.remove(L)}function ne(L){let T=n.get(L);i.deleteTexture(T.__webglTexture);let Z=L.source,ve=S.get(Z);delete ve[T.__cacheKey],l.memory.textures--}function Se(L){let T=n.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let Z=L.depthTexture;if(Z&&Z.renderTarget===L&&ee(Z),L.isWebGLCubeRenderTarget)for(let de=0;de<6;de++){if(Array.isArray(T.__webglFramebuffer[de]))for(let pe=0;pe<T.__webglFramebuffer[de].length;pe++)i.deleteFramebuffer(T.__webglFramebuffer[de][pe]);else i.deleteFramebuffer(T.__webglFramebuffer[de]);T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer[de])}else{if(Array.isArray(T.__webglFramebuffer))for(let de=0;de<T.__webglFramebuffer.length;de++)i.deleteFramebuffer(T.__webglFramebuffer[de]);else i.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&i.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let de=0;de<T.__webglColorRenderbuffer.length;de++)T.__webglColorRenderbuffer[de]&&i.deleteRenderbuffer(T.__webglColorRenderbuffer[de]);T.__webglDepthRenderbuffer&&i.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ve=L.textures;for(let de=0,pe=ve.length;de<pe;de++){let Me=n.get(ve[de]);Me.__webglTexture&&(i.deleteTexture(Me.__webglTexture),l.memory.textures--),n.remove(ve[de])}n.remove(L)}let re=0;function H(){re=0}function ge(){return re}function We(L){re=L}function it(){let L=re;return L>=s.maxTextures&&Qe("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),re+=1,L}function ue(L){let T=[];return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.join()}function Fe(L,T){let Z=n.get(L);if(L.isVideoTexture&&$t(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Z.__version!==L.version){let ve=L.image;if(ve===null)Qe("WebGLRenderer: Texture marked for update but no image data found.");else if(ve.complete===!1)Qe("WebGLRenderer: Texture marked for update but image is incomplete");else{pt(Z,L,T);return}}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+T)}function Pe(L,T){let Z=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){pt(Z,L,T);return}else L.isExternalTexture&&(Z.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+T)}function je(L,T){let Z=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Z.__version!==L.version){pt(Z,L,T);return}t.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+T)}function Ue(L,T){let Z=n.get(L);if(L.version>0&&Z.__version!==L.version){It(Z,L,T);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+T)}let ot={[Ur]:i.REPEAT,[ai]:i.CLAMP_TO_EDGE,[uo]:i.MIRRORED_REPEAT},Vt={[cn]:i.NEAREST,[md]:i.NEAREST_MIPMAP_NEAREST,[js]:i.NEAREST_MIPMAP_LINEAR,[Sn]:i.LINEAR,[ko]:i.LINEAR_MIPMAP_NEAREST,[Ci]:i.LINEAR_MIPMAP_LINEAR},Ke={[yd]:i.NEVER,[Jc]:i.ALWAYS,[xd]:i.LESS,[jc]:i.LEQUAL,[Sd]:i.EQUAL,[Zc]:i.GEQUAL,[Md]:i.GREATER,[bd]:i.NOTEQUAL};function Et(L,T){if(T.type===zn&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===Sn||T.magFilter===ko||T.magFilter===js||T.magFilter===Ci||T.minFilter===Sn||T.minFilter===ko||T.minFilter===js||T.minFilter===Ci)&&Qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,ot[T.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,ot[T.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,ot[T.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,Vt[T.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,Vt[T.minFilter]),T.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Ke[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===cn||T.minFilter!==js&&T.minFilter!==Ci||T.type===zn&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let Z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function Ct(L,T){let Z=!1;L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",Y),q(T));let ve=T.source,de=S.get(ve);de===void 0&&(de={},S.set(ve,de));let pe=ue(T);if(pe!==L.__cacheKey){de[pe]===void 0&&(de[pe]={texture:i.createTexture(),usedTimes:0},l.memory.textures++,Z=!0),de[pe].usedTimes++;let Me=de[L.__cacheKey];Me!==void 0&&(de[L.__cacheKey].usedTimes--,Me.usedTimes===0&&ne(T)),L.__cacheKey=pe,L.__webglTexture=de[pe].texture}return Z}function mt(L,T,Z){return Math.floor(Math.floor(L/Z)/T)}function Ht(L,T,Z,ve){let pe=L.updateRanges;if(pe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,T.width,T.height,Z,ve,T.data);else{pe.sort((B,he)=>B.start-he.start);let Me=0;for(let B=1;B<pe.length;B++){let he=pe[Me],se=pe[B],Re=he.start+he.count,Ee=mt(se.start,T.width,4),Ae=mt(he.start,T.width,4);se.start<=Re+1&&Ee===Ae&&mt(se.start+se.count-1,T.width,4)===Ee?he.count=Math.max(he.count,se.start+se.count-he.start):(++Me,pe[Me]=se)}pe.length=Me+1;let ae=t.getParameter(i.UNPACK_ROW_LENGTH),le=t.getParameter(i.UNPACK_SKIP_PIXELS),Ce=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,T.width);for(let B=0,he=pe.length;B<he;B++){let se=pe[B],Re=Math.floor(se.start/4),Ee=Math.ceil(se.count/4),Ae=Re%T.width,Xe=Math.floor(Re/T.width),ut=Ee,we=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Xe,ut,we,Z,ve,T.data)}L.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ae),t.pixelStorei(i.UNPACK_SKIP_PIXELS,le),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ce)}}function pt(L,T,Z){let ve=i.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ve=i.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ve=i.TEXTURE_3D);let de=Ct(L,T),pe=T.source;t.bindTexture(ve,L.__webglTexture,i.TEXTURE0+Z);let Me=n.get(pe);if(pe.version!==Me.__version||de===!0){if(t.activeTexture(i.TEXTURE0+Z),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let we=St.getPrimaries(St.workingColorSpace),qe=T.colorSpace===Pi?null:St.getPrimaries(T.colorSpace),dt=T.colorSpace===Pi||we===qe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,dt)}t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment);let le=P(T.image,!1,s.maxTextureSize);le=Ze(T,le);let Ce=o.convert(T.format,T.colorSpace),B=o.convert(T.type),he=N(T.internalFormat,Ce,B,T.normalized,T.colorSpace,T.isVideoTexture);Et(ve,T);let se,Re=T.mipmaps,Ee=T.isVideoTexture!==!0,Ae=Me.__version===void 0||de===!0,Xe=pe.dataReady,ut=D(T,le);if(T.isDepthTexture)he=b(T.format===Ri,T.type),Ae&&(Ee?t.texStorage2D(i.TEXTURE_2D,1,he,le.width,le.height):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Ce,B,null));else if(T.isDataTexture)if(Re.length>0){Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Re[0].width,Re[0].height);for(let we=0,qe=Re.length;we<qe;we++)se=Re[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Ce,B,se.data);T.generateMipmaps=!1}else Ee?(Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height),Xe&&Ht(T,le,Ce,B)):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Ce,B,le.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){Ee&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,Re[0].width,Re[0].height,le.depth);for(let we=0,qe=Re.length;we<qe;we++)if(se=Re[we],T.format!==Zn)if(Ce!==null)if(Ee){if(Xe)if(T.layerUpdates.size>0){let dt=oh(se.width,se.height,T.format,T.type);for(let Oe of T.layerUpdates){let Tt=se.data.subarray(Oe*dt/se.data.BYTES_PER_ELEMENT,(Oe+1)*dt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,Oe,se.width,se.height,1,Ce,Tt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Ce,se.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,se.data,0,0);else Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ee?Xe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Ce,B,se.data):t.texImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,Ce,B,se.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Re[0].width,Re[0].height);for(let we=0,qe=Re.length;we<qe;we++)se=Re[we],T.format!==Zn?Ce!==null?Ee?Xe&&t.compressedTexSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,se.data):t.compressedTexImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,se.data):Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Ce,B,se.data)}else if(T.isDataArrayTexture)if(Ee){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,le.width,le.height,le.depth),Xe)if(T.layerUpdates.size>0){let we=oh(le.width,le.height,T.format,T.type);for(let qe of T.layerUpdates){let dt=le.data.subarray(qe*we/le.data.BYTES_PER_ELEMENT,(qe+1)*we/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,qe,le.width,le.height,1,Ce,B,dt)}T.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,Ce,B,le.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,he,le.width,le.height,le.depth,0,Ce,B,le.data);else if(T.isData3DTexture)Ee?(Ae&&t.texStorage3D(i.TEXTURE_3D,ut,he,le.width,le.height,le.depth),Xe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,Ce,B,le.data)):t.texImage3D(i.TEXTURE_3D,0,he,le.width,le.height,le.depth,0,Ce,B,le.data);else if(T.isFramebufferTexture){if(Ae)if(Ee)t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height);else{let we=le.width,qe=le.height;for(let dt=0;dt<ut;dt++)t.texImage2D(i.TEXTURE_2D,dt,he,we,qe,0,Ce,B,null),we>>=1,qe>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in i){let we=i.canvas;if(we.hasAttribute("layoutsubtree")||we.setAttribute("layoutsubtree","true"),le.parentNode!==we){we.appendChild(le),y.add(T),we.onpaint=qe=>{let dt=qe.changedElements;for(let Oe of y)dt.includes(Oe.image)&&(Oe.needsUpdate=!0)},we.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,le);else{let dt=i.RGBA,Oe=i.RGBA,Tt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,dt,Oe,Tt,le)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(Ee&&Ae){let we=Je(Re[0]);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}for(let we=0,qe=Re.length;we<qe;we++)se=Re[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,Ce,B,se):t.texImage2D(i.TEXTURE_2D,we,he,Ce,B,se);T.generateMipmaps=!1}else if(Ee){if(Ae){let we=Je(le);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}Xe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Ce,B,le)}else t.texImage2D(i.TEXTURE_2D,0,he,Ce,B,le);U(T)&&T.mipmapsAutoUpdate===!0&&I(ve),Me.__version=pe.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function It(L,T,Z){if(T.image.length!==6)return;let ve=Ct(L,T),de=T.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+Z);let pe=n.get(de);if(de.version!==pe.__version||ve===!0){t.activeTexture(i.TEXTURE0+Z);let Me=St.getPrimaries(St.workingColorSpace),ae=T.colorSpace===Pi?null:St.getPrimaries(T.colorSpace),le=T.colorSpace===Pi||Me===ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,le);let Ce=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,he=[];for(let Oe=0;Oe<6;Oe++)!Ce&&!B?he[Oe]=P(T.image[Oe],!0,s.maxCubemapSize):he[Oe]=B?T.image[Oe].image:T.image[Oe],he[Oe]=Ze(T,he[Oe]);let se=he[0],Re=o.convert(T.format,T.colorSpace),Ee=o.convert(T.type),Ae=N(T.internalFormat,Re,Ee,T.normalized,T.colorSpace),Xe=T.isVideoTexture!==!0,ut=pe.__version===void 0||ve===!0,we=de.dataReady,qe=D(T,se);Et(i.TEXTURE_CUBE_MAP,T);let dt;if(T.isDepthTexture){if(Ae=b(T.format===Ri,T.type),ut)if(Xe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,se.width,se.height);else for(let Oe=0;Oe<6;Oe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,se.width,se.height,0,Re,Ee,null)}else if(Ce){Xe&&ut&&t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ae,se.width,se.height);for(let Oe=0;Oe<6;Oe++){dt=he[Oe].mipmaps;for(let Tt=0;Tt<dt.length;Tt++){let Ot=dt[Tt];T.format!==Zn?Re!==null?Xe?we&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Ot.width,Ot.height,Re,Ot.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Ot.width,Ot.height,0,Ot.data):Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Ot.width,Ot.height,Re,Ee,Ot.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Ot.width,Ot.height,0,Re,Ee,Ot.data)}}}else{if(dt=T.mipmaps,Xe&&ut){dt.length>0&&qe++;let Oe=Je(he[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ae,Oe.width,Oe.height)}for(let Oe=0;Oe<6;Oe++)if(B){Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,he[Oe].width,he[Oe].height,Re,Ee,he[Oe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,he[Oe].width,he[Oe].height,0,Re,Ee,he[Oe].data);for(let Tt=0;Tt<dt.length;Tt++){let gi=dt[Tt].image[Oe].image;Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,gi.width,gi.height,Re,Ee,gi.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,gi.width,gi.height,0,Re,Ee,gi.data)}}else{Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,Re,Ee,he[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,Re,Ee,he[Oe]);for(let Tt=0;Tt<dt.length;Tt++){let Ot=dt[Tt];Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,Re,Ee,Ot.image[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,Re,Ee,Ot.image[Oe])}}}U(T)&&T.mipmapsAutoUpdate===!0&&I(i.TEXTURE_CUBE_MAP),pe.__version=de.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Mt(L,T,Z,ve,de,pe){let Me=o.convert(Z.format,Z.colorSpace),ae=o.convert(Z.type),le=N(Z.internalFormat,Me,ae,Z.normalized,Z.colorSpace),Ce=n.get(T),B=n.get(Z);if(B.__renderTarget=T,!Ce.__hasExternalTextures){let he=Math.max(1,T.width>>pe),se=Math.max(1,T.height>>pe);de===i.TEXTURE_3D||de===i.TEXTURE_2D_ARRAY?t.texImage3D(de,pe,le,he,se,T.depth,0,Me,ae,null):t.texImage2D(de,pe,le,he,se,0,Me,ae,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,de,B.__webglTexture,0,Ut(T)):(de===i.TEXTURE_2D||de>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&de<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ve,de,B.__webglTexture,pe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(L,T,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,L),T.depthBuffer){let ve=T.depthTexture,de=ve&&ve.isDepthTexture?ve.type:null,pe=b(T.stencilBuffer,de),Me=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Le(T)?h.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,pe,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Me,i.RENDERBUFFER,L)}else{let ve=T.textures;for(let de=0;de<ve.length;de++){let pe=ve[de],Me=o.convert(pe.format,pe.colorSpace),ae=o.convert(pe.type),le=N(pe.internalFormat,Me,ae,pe.normalized,pe.colorSpace);Le(T)?h.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),le,T.width,T.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),le,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,le,T.width,T.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function De(L,T,Z){let ve=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let de=n.get(T.depthTexture);de.__renderTarget=T;let pe=ve?T.depthTexture.image[0]:T.depthTexture.image;(!de.__webglTexture||pe.width!==T.width||pe.height!==T.height)&&(pe.width=T.width,pe.height=T.height,T.depthTexture.needsUpdate=!0),ve?Ue(T.depthTexture,0):Fe(T.depthTexture,0);let Me=de.__webglTexture,ae=Ut(T),le=ve?i.TEXTURE_CUBE_MAP_POSITIVE_X+Z:i.TEXTURE_2D,Ce=T.depthTexture.format===Ri?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(T.depthTexture.format===wi)Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Ce,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Ce,le,Me,0);else if(T.depthTexture.format===Ri)Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Ce,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Ce,le,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function $e(L){let T=n.get(L),Z=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==L.depthTexture){let ve=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ve){let de=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ve.removeEventListener("dispose",de)};ve.addEventListener("dispose",de),T.__depthDisposeCallback=de}T.__boundDepthTexture=ve}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)if(Z)for(let ve=0;ve<6;ve++)De(T.__webglFramebuffer[ve],L,ve);else L.texture.mipmaps.length>0?De(T.__webglFramebuffer[0],L,0):De(T.__webglFramebuffer,L,0);else if(Z){T.__webglDepthbuffer=[];for(let ve=0;ve<6;ve++)if(t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[ve]),T.__webglDepthbuffer[ve]===void 0)T.__webglDepthbuffer[ve]=i.createRenderbuffer(),rn(T.__webglDepthbuffer[ve],L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer[ve];i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=i.createRenderbuffer(),rn(T.__webglDepthbuffer,L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function hn(L,T,Z){let ve=n.get(L);T!==void 0&&Mt(ve.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&$e(L)}function sn(L){let T=L.texture,Z=n.get(L),ve=n.get(T);L.addEventListener("dispose",J),q(L);let de=L.textures,pe=L.isWebGLCubeRenderTarget===!0,Me=de.length>1;if(Me||(ve.__webglTexture===void 0&&(ve.__webglTexture=i.createTexture()),ve.__version=T.version,l.memory.textures++),pe){Z.__webglFramebuffer=[];for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0){Z.__webglFramebuffer[ae]=[];for(let le=0;le<T.mipmaps.length;le++)Z.__webglFramebuffer[ae][le]=i.createFramebuffer()}else Z.__webglFramebuffer[ae]=i.createFramebuffer()}else{if(T.mipmaps.length>0){Z.__webglFramebuffer=[];for(let ae=0;ae<T.mipmaps.length;ae++)Z.__webglFramebuffer[ae]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(Me)for(let ae=0,le=de.length;ae<le;ae++){let Ce=n.get(de[ae]);Ce.__webglTexture===void 0&&(Ce.__webglTexture=i.createTexture(),l.memory.textures++)}if(L.samples>0&&Le(L)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let ae=0;ae<de.length;ae++){let le=de[ae];Z.__webglColorRenderbuffer[ae]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[ae]);let Ce=o.convert(le.format,le.colorSpace),B=o.convert(le.type),he=N(le.internalFormat,Ce,B,le.normalized,le.colorSpace,L.isXRRenderTarget===!0),se=Ut(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,se,he,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,Z.__webglColorRenderbuffer[ae])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),rn(Z.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(pe){t.bindTexture(i.TEXTURE_CUBE_MAP,ve.__webglTexture),Et(i.TEXTURE_CUBE_MAP,T);for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(Z.__webglFramebuffer[ae][le],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,le);else Mt(Z.__webglFramebuffer[ae],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0);U(T)?I(i.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let ae=0,le=de.length;ae<le;ae++){let Ce=de[ae],B=n.get(Ce),he=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(he=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(he,B.__webglTexture),Et(he,Ce),Mt(Z.__webglFramebuffer,L,Ce,i.COLOR_ATTACHMENT0+ae,he,0),U(Ce)&&I(he)}t.unbindTexture()}else{let ae=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ae=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,ve.__webglTexture),Et(ae,T),T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(Z.__webglFramebuffer[le],L,T,i.COLOR_ATTACHMENT0,ae,le);else Mt(Z.__webglFramebuffer,L,T,i.COLOR_ATTACHMENT0,ae,0);U(T)?I(ae):T.mipmaps.length>0&&i.texParameteri(ae,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&$e(L)}function W(L){let T=L.textures;for(let Z=0,ve=T.length;Z<ve;Z++){let de=T[Z];if(U(de)&&de.mipmapsAutoUpdate===!0){let pe=O(L),Me=n.get(de).__webglTexture;t.bindTexture(pe,Me),I(pe),t.unbindTexture()}}}let vn=[];function Rt(L){if(L.samples>0){if(Le(L)===!1){let T=L.textures,Z=L.width,ve=L.height,de=i.COLOR_BUFFER_BIT,pe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=n.get(L),ae=T.length>1;if(ae)for(let Ce=0;Ce<T.length;Ce++)t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let Ce=0;Ce<T.length;Ce++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(de|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(de|=i.STENCIL_BUFFER_BIT)),ae){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Ce]);let B=n.get(T[Ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,Z,ve,0,0,Z,ve,de,i.NEAREST),f===!0&&(vn.length=0,vn.push(i.COLOR_ATTACHMENT0+Ce),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&vn.push(pe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,vn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ae)for(let Ce=0;Ce<T.length;Ce++){t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Ce]);let B=n.get(T[Ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&f){let T=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[T])}}}function Ut(L){return Math.min(s.maxSamples,L.samples)}function Le(L){let T=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function $t(L){let T=l.render.frame;m.get(L)!==T&&(m.set(L,T),L.update())}function Ze(L,T){let Z=L.colorSpace,ve=L.format,de=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Z!==xs&&Z!==Pi&&(St.getTransfer(Z)===Pt?(ve!==Zn||de!==En)&&Qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",Z)),T}function Je(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(d.width=L.naturalWidth||L.width,d.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(d.width=L.displayWidth,d.height=L.displayHeight):(d.width=L.width,d.height=L.height),d}this.allocateTextureUnit=it,this.resetTextureUnits=H,this.getTextureUnits=ge,this.setTextureUnits=We,this.setTexture2D=Fe,this.setTexture2DArray=Pe,this.setTexture3D=je,this.setTextureCube=Ue,this.rebindTextures=hn,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=Rt,this.setupDepthRenderbuffer=$e,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=Le,this.dispose=ie}function vb(i,e){function t(n,s=Pi){let o,l=St.getTransfer(s);if(n===En)return i.UNSIGNED_BYTE;if(n===Go)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Vo)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Xc)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===$c)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Hc)return i.BYTE;if(n===Wc)return i.SHORT;if(n===Zr)return i.UNSIGNED_SHORT;if(n===zo)return i.INT;if(n===Yn)return i.UNSIGNED_INT;if(n===zn)return i.FLOAT;if(n===jn)return i.HALF_FLOAT;if(n===qc)return i.ALPHA;if(n===Yc)return i.RGB;if(n===Zn)return i.RGBA;if(n===wi)return i.DEPTH_COMPONENT;if(n===Ri)return i.DEPTH_STENCIL;if(n===Ho)return i.RED;if(n===Wo)return i.RED_INTEGER;if(n===Yi)return i.RG;if(n===Xo)return i.RG_INTEGER;if(n===$o)return i.RGBA_INTEGER;if(n===Zs||n===Js||n===Ks||n===Qs)if(l===Pt)if(o=e.get("WEBGL_compressed_texture_s3tc_srgb"),o!==null){if(n===Zs)return o.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Js)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ks)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Qs)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(o=e.get("WEBGL_compressed_texture_s3tc"),o!==null){if(n===Zs)return o.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Js)return o.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ks)return o.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Qs)return o.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===qo||n===Yo||n===jo||n===Zo)if(o=e.get("WEBGL_compressed_texture_pvrtc"),o!==null){if(n===qo)return o.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Yo)return o.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===jo)return o.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Zo)return o.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Jo||n===Ko||n===Qo||n===el||n===tl||n===ea||n===nl)if(o=e.get("WEBGL_compressed_texture_etc"),o!==null){if(n===Jo||n===Ko)return l===Pt?o.COMPRESSED_SRGB8_ETC2:o.COMPRESSED_RGB8_ETC2;if(n===Qo)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:o.COMPRESSED_RGBA8_ETC2_EAC;if(n===el)return o.COMPRESSED_R11_EAC;if(n===tl)return o.COMPRESSED_SIGNED_R11_EAC;if(n===ea)return o.COMPRESSED_RG11_EAC;if(n===nl)return o.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===il||n===rl||n===sl||n===al||n===ol||n===ll||n===cl||n===hl||n===ul||n===dl||n===fl||n===pl||n===ml||n===gl)if(o=e.get("WEBGL_compressed_texture_astc"),o!==null){if(n===il)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:o.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===rl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:o.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===sl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:o.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===al)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:o.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ol)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:o.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ll)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:o.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===cl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:o.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===hl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:o.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ul)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:o.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===dl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:o.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===fl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:o.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===pl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:o.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ml)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:o.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===gl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:o.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===_l||n===vl||n===yl)if(o=e.get("EXT_texture_compression_bptc"),o!==null){if(n===_l)return l===Pt?o.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:o.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===vl)return o.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===yl)return o.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===xl||n===Sl||n===ta||n===Ml)if(o=e.get("EXT_texture_compression_rgtc"),o!==null){if(n===xl)return o.COMPRESSED_RED_RGTC1_EXT;if(n===Sl)return o.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ta)return o.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Ml)return o.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===pr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var yb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,xb=`
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

}`,gh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ns(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ui({vertexShader:yb,fragmentShader:xb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new zt(new Gi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},_h=class extends qn{constructor(e,t){super();let n=this,s=null,o=1,l=null,h="local-floor",f=1,d=null,m=null,y=null,g=null,S=null,E=null,R=typeof XRWebGLBinding<"u",x=new gh,v={},P=t.getContextAttributes(),U=null,I=null,O=[],N=[],b=new et,D=null,q=null,k=new gn;k.viewport=new Gt;let Y=new gn;Y.viewport=new Gt;let J=[k,Y],ee=new No,z=null,ie=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Vr,O[ue]=Fe),Fe.getTargetRaySpace()},this.getControllerGrip=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Vr,O[ue]=Fe),Fe.getGripSpace()},this.getHand=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Vr,O[ue]=Fe),Fe.getHandSpace()};function G(ue){let Fe=N.indexOf(ue.inputSource);if(Fe===-1)return;let Pe=O[Fe];Pe!==void 0&&(Pe.update(ue.inputSource,ue.frame,d||l),Pe.dispatchEvent({type:ue.type,data:ue.inputSource}))}function ne(){s.removeEventListener("select",G),s.removeEventListener("selectstart",G),s.removeEventListener("selectend",G),s.removeEventListener("squeeze",G),s.removeEventListener("squeezestart",G),s.removeEventListener("squeezeend",G),s.removeEventListener("end",ne),s.removeEventListener("inputsourceschange",Se);for(let ue=0;ue<O.length;ue++){let Fe=N[ue];Fe!==null&&(N[ue]=null,O[ue].disconnect(Fe))}z=null,ie=null,x.reset();for(let ue in v)delete v[ue];if(e.setRenderTarget(U),S=null,g=null,y=null,s=null,I=null,it.stop(),n.isPresenting=!1,e.setPixelRatio(D),e.setSize(b.width,b.height,!1),q!==null){let ue=q.camera;ue.fov=q.fov,ue.zoom=q.zoom,ue.updateProjectionMatrix(),q=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ue){o=ue,n.isPresenting===!0&&Qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ue){h=ue,n.isPresenting===!0&&Qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return d||l},this.setReferenceSpace=function(ue){d=ue},this.getBaseLayer=function(){return g!==null?g:S},this.getBinding=function(){return y===null&&R&&(y=new XRWebGLBinding(s,t)),y},this.getFrame=function(){return E},this.getSession=function(){return s},this.setSession=async function(ue){if(s=ue,s!==null){if(U=e.getRenderTarget(),s.addEventListener("select",G),s.addEventListener("selectstart",G),s.addEventListener("selectend",G),s.addEventListener("squeeze",G),s.addEventListener("squeezestart",G),s.addEventListener("squeezeend",G),s.addEventListener("end",ne),s.addEventListener("inputsourceschange",Se),P.xrCompatible!==!0&&await t.makeXRCompatible(),D=e.getPixelRatio(),e.getSize(b),R&&"createProjectionLayer"in XRWebGLBinding.prototype){let Pe=null,je=null,Ue=null;P.depth&&(Ue=P.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Pe=P.stencil?Ri:wi,je=P.stencil?pr:Yn);let ot={colorFormat:t.RGBA8,depthFormat:Ue,scaleFactor:o};y=this.getBinding(),g=y.createProjectionLayer(ot),s.updateRenderState({layers:[g]}),e.setPixelRatio(1),e.setSize(g.textureWidth,g.textureHeight,!1),I=new Dn(g.textureWidth,g.textureHeight,{format:Zn,type:En,depthTexture:new Ti(g.textureWidth,g.textureHeight,je,void 0,void 0,void 0,void 0,void 0,void 0,Pe),stencilBuffer:P.stencil,colorSpace:e.outputColorSpace,samples:P.antialias?4:0,resolveDepthBuffer:g.ignoreDepthValues===!1,resolveStencilBuffer:g.ignoreDepthValues===!1,storeMultisampledDepthBuffer:g.ignoreDepthValues===!1,storeMultisampledStencilBuffer:g.ignoreDepthValues===!1})}else{let Pe={antialias:P.antialias,alpha:!0,depth:P.depth,stencil:P.stencil,framebufferScaleFactor:o};S=new XRWebGLLayer(s,t,Pe),s.updateRenderState({baseLayer:S}),e.setPixelRatio(1),e.setSize(S.framebufferWidth,S.framebufferHeight,!1),I=new Dn(S.framebufferWidth,S.framebufferHeight,{format:Zn,type:En,colorSpace:e.outputColorSpace,stencilBuffer:P.stencil,resolveDepthBuffer:S.ignoreDepthValues===!1,resolveStencilBuffer:S.ignoreDepthValues===!1,storeMultisampledDepthBuffer:S.ignoreDepthValues===!1,storeMultisampledStencilBuffer:S.ignoreDepthValues===!1})}I.isXRRenderTarget=!0,this.setFoveation(f),d=null,l=await s.requestReferenceSpace(h),it.setContext(s),it.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return x.getDepthTexture()};function Se(ue){for(let Fe=0;Fe<ue.removed.length;Fe++){let Pe=ue.removed[Fe],je=N.indexOf(Pe);je>=0&&(N[je]=null,O[je].disconnect(Pe))}for(let Fe=0;Fe<ue.added.length;Fe++){let Pe=ue.added[Fe],je=N.indexOf(Pe);if(je===-1){for(let ot=0;ot<O.length;ot++)if(ot>=N.length){N.push(Pe),je=ot;break}else if(N[ot]===null){N[ot]=Pe,je=ot;break}if(je===-1)break}let Ue=O[je];Ue&&Ue.connect(Pe)}}function re(ue,Fe){Fe===null?ue.matrixWorld.copy(ue.matrix):ue.matrixWorld.multiplyMatrices(Fe.matrixWorld,ue.matrix),ue.matrixWorldInverse.copy(ue.matrixWorld).invert()}this.updateCamera=function(ue){if(s===null)return;let Fe=ue.near,Pe=ue.far;x.texture!==null&&(x.depthNear>0&&(Fe=x.depthNear),x.depthFar>0&&(Pe=x.depthFar)),ee.near=Y.near=k.near=Fe,ee.far=Y.far=k.far=Pe,(z!==ee.near||ie!==ee.far)&&(s.updateRenderState({depthNear:ee.near,depthFar:ee.far}),z=ee.near,ie=ee.far),ee.layers.mask=ue.layers.mask|6,k.layers.mask=ee.layers.mask&-5,Y.layers.mask=ee.layers.mask&-3;let je=ue.parent,Ue=ee.cameras;re(ee,je);for(let ot=0;ot<Ue.length;ot++)re(Ue[ot],je);ee.projectionMatrix.copy(k.projectionMatrix),ee.projectionMatrixInverse.copy(k.projectionMatrixInverse),q===null&&ue.isPerspectiveCamera&&(q={camera:ue,fov:ue.fov,zoom:ue.zoom}),H(ue,ee,je)};function H(ue,Fe,Pe){Pe===null?ue.matrix.copy(Fe.matrixWorld):(ue.matrix.copy(Pe.matrixWorld),ue.matrix.invert(),ue.matrix.multiply(Fe.matrixWorld)),ue.matrix.decompose(ue.position,ue.quaternion,ue.scale),ue.updateMatrixWorld(!0),ue.projectionMatrix.copy(Fe.projectionMatrix),ue.projectionMatrixInverse.copy(Fe.projectionMatrixInverse),ue.isPerspectiveCamera&&(ue.fov=kr*2*Math.atan(1/ue.projectionMatrix.elements[5]),ue.zoom=1)}this.getCamera=function(){return ee},this.getFoveation=function(){if(!(g===null&&S===null))return f},this.setFoveation=function(ue){f=ue,g!==null&&(g.fixedFoveation=ue),S!==null&&S.fixedFoveation!==void 0&&(S.fixedFoveation=ue)},this.hasDepthSensing=function(){return x.texture!==null},this.getDepthSensingMesh=function(){return x.getMesh(ee)},this.getCameraTexture=function(ue){return v[ue]};let ge=null;function We(ue,Fe){if(m=Fe.getViewerPose(d||l),E=Fe,m!==null){let Pe=m.views;S!==null&&(e.setRenderTargetFramebuffer(I,S.framebuffer),e.setRenderTarget(I));let je=!1;Pe.length!==ee.cameras.length&&(ee.cameras.length=0,je=!0);for(let Ke=0;Ke<Pe.length;Ke++){let Et=Pe[Ke],Ct=null;if(S!==null)Ct=S.getViewport(Et);else{let Ht=y.getViewSubImage(g,Et);Ct=Ht.viewport,Ke===0&&(e.setRenderTargetTextures(I,Ht.colorTexture,Ht.depthStencilTexture),e.setRenderTarget(I))}let mt=J[Ke];mt===void 0&&(mt=new gn,mt.layers.enable(Ke),mt.viewport=new Gt,J[Ke]=mt),mt.matrix.fromArray(Et.transform.matrix),mt.matrix.decompose(mt.position,mt.quaternion,mt.scale),mt.projectionMatrix.fromArray(Et.projectionMatrix),mt.projectionMatrixInverse.copy(mt.projectionMatrix).invert(),mt.viewport.set(Ct.x,Ct.y,Ct.width,Ct.height),Ke===0&&(ee.matrix.copy(mt.matrix),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale)),je===!0&&ee.cameras.push(mt)}let Ue=s.enabledFeatures;if(Ue&&Ue.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&R){y=n.getBinding();let Ke=y.getDepthInformation(Pe[0]);Ke&&Ke.isValid&&Ke.texture&&x.init(Ke,s.renderState)}if(Ue&&Ue.includes("camera-access")&&R){e.state.unbindTexture(),y=n.getBinding();for(let Ke=0;Ke<Pe.length;Ke++){let Et=Pe[Ke].camera;if(Et){let Ct=v[Et];Ct||(Ct=new Ns,v[Et]=Ct);let mt=y.getCameraImage(Et);Ct.sourceTexture=mt}}}}for(let Pe=0;Pe<O.length;Pe++){let je=N[Pe],Ue=O[Pe];je!==null&&Ue!==void 0&&Ue.update(je,Fe,d||l)}ge&&ge(ue,Fe),Fe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Fe}),E=null}let it=new nf;it.setAnimationLoop(We),this.setAnimationLoop=function(ue){ge=ue},this.dispose=function(){}}},Sb=new Lt,ff=new ct;ff.set(-1,0,0,0,1,0,0,0,1);function Mb(i,e){function t(x,v){x.matrixAutoUpdate===!0&&x.updateMatrix(),v.value.copy(x.matrix)}function n(x,v){v.color.getRGB(x.fogColor.value,rh(i)),v.isFog?(x.fogNear.value=v.near,x.fogFar.value=v.far):v.isFogExp2&&(x.fogDensity.value=v.density)}function s(x,v,P,U,I){v.isNodeMaterial?v.uniformsNeedUpdate=!1:v.isMeshBasicMaterial?o(x,v):v.isMeshLambertMaterial?(o(x,v),v.envMap&&(x.envMapIntensity.value=v.envMapIntensity)):v.isMeshToonMaterial?(o(x,v),y(x,v)):v.isMeshPhongMaterial?(o(x,v),m(x,v),v.envMap&&(x.envMapIntensity.value=v.envMapIntensity)):v.isMeshStandardMaterial?(o(x,v),g(x,v),v.isMeshPhysicalMaterial&&S(x,v,I)):v.isMeshMatcapMaterial?(o(x,v),E(x,v)):v.isMeshDepthMaterial?o(x,v):v.isMeshDistanceMaterial?(o(x,v),R(x,v)):v.isMeshNormalMaterial?o(x,v):v.isLineBasicMaterial?(l(x,v),v.isLineDashedMaterial&&h(x,v)):v.isPointsMaterial?f(x,v,P,U):v.isSpriteMaterial?d(x,v):v.isShadowMaterial?(x.color.value.copy(v.color),x.opacity.value=v.opacity):v.isShaderMaterial&&(v.uniformsNeedUpdate=!1)}function o(x,v){x.opacity.value=v.opacity,v.color&&x.diffuse.value.copy(v.color),v.emissive&&x.emissive.value.copy(v.emissive).multiplyScalar(v.emissiveIntensity),v.map&&(x.map.value=v.map,t(v.map,x.mapTransform)),v.alphaMap&&(x.alphaMap.value=v.alphaMap,t(v.alphaMap,x.alphaMapTransform)),v.bumpMap&&(x.bumpMap.value=v.bumpMap,t(v.bumpMap,x.bumpMapTransform),x.bumpScale.value=v.bumpScale,v.side===dn&&(x.bumpScale.value*=-1)),v.normalMap&&(x.normalMap.value=v.normalMap,t(v.normalMap,x.normalMapTransform),x.normalScale.value.copy(v.normalScale),v.side===dn&&x.normalScale.value.negate()),v.displacementMap&&(x.displacementMap.value=v.displacementMap,t(v.displacementMap,x.displacementMapTransform),x.displacementScale.value=v.displacementScale,x.displacementBias.value=v.displacementBias),v.emissiveMap&&(x.emissiveMap.value=v.emissiveMap,t(v.emissiveMap,x.emissiveMapTransform)),v.specularMap&&(x.specularMap.value=v.specularMap,t(v.specularMap,x.specularMapTransform)),v.alphaTest>0&&(x.alphaTest.value=v.alphaTest);let P=e.get(v),U=P.envMap,I=P.envMapRotation;U&&(x.envMap.value=U,x.envMapRotation.value.setFromMatrix4(Sb.makeRotationFromEuler(I)).transpose(),U.isCubeTexture&&U.isRenderTargetTexture===!1&&x.envMapRotation.value.premultiply(ff),x.reflectivity.value=v.reflectivity,x.ior.value=v.ior,x.refractionRatio.value=v.refractionRatio),v.lightMap&&(x.lightMap.value=v.lightMap,x.lightMapIntensity.value=v.lightMapIntensity,t(v.lightMap,x.lightMapTransform)),v.aoMap&&(x.aoMap.value=v.aoMap,x.aoMapIntensity.value=v.aoMapIntensity,t(v.aoMap,x.aoMapTransform))}function l(x,v){x.diffuse.value.copy(v.color),x.opacity.value=v.opacity,v.map&&(x.map.value=v.map,t(v.map,x.mapTransform))}function h(x,v){x.dashSize.value=v.dashSize,x.totalSize.value=v.dashSize+v.gapSize,x.scale.value=v.scale}function f(x,v,P,U){x.diffuse.value.copy(v.color),x.opacity.value=v.opacity,x.size.value=v.size*P,x.scale.value=U*.5,v.map&&(x.map.value=v.map,t(v.map,x.uvTransform)),v.alphaMap&&(x.alphaMap.value=v.alphaMap,t(v.alphaMap,x.alphaMapTransform)),v.alphaTest>0&&(x.alphaTest.value=v.alphaTest)}function d(x,v){x.diffuse.value.copy(v.color),x.opacity.value=v.opacity,x.rotation.value=v.rotation,v.map&&(x.map.value=v.map,t(v.map,x.mapTransform)),v.alphaMap&&(x.alphaMap.value=v.alphaMap,t(v.alphaMap,x.alphaMapTransform)),v.alphaTest>0&&(x.alphaTest.value=v.alphaTest)}function m(x,v){x.specular.value.copy(v.specular),x.shininess.value=Math.max(v.shininess,1e-4)}function y(x,v){v.gradientMap&&(x.gradientMap.value=v.gradientMap)}function g(x,v){x.metalness.value=v.metalness,v.metalnessMap&&(x.metalnessMap.value=v.metalnessMap,t(v.metalnessMap,x.metalnessMapTransform)),x.roughness.value=v.roughness,v.roughnessMap&&(x.roughnessMap.value=v.roughnessMap,t(v.roughnessMap,x.roughnessMapTransform)),v.envMap&&(x.envMapIntensity.value=v.envMapIntensity)}function S(x,v,P){x.ior.value=v.ior,v.diffuseRoughness>0&&(x.diffuseRoughness.value=v.diffuseRoughness,v.diffuseRoughnessMap&&(x.diffuseRoughnessMap.value=v.diffuseRoughnessMap,t(v.diffuseRoughnessMap,x.diffuseRoughnessMapTransform))),v.sheen>0&&(x.sheenColor.value.copy(v.sheenColor).multiplyScalar(v.sheen),x.sheenRoughness.value=v.sheenRoughness,v.sheenColorMap&&(x.sheenColorMap.value=v.sheenColorMap,t(v.sheenColorMap,x.sheenColorMapTransform)),v.sheenRoughnessMap&&(x.sheenRoughnessMap.value=v.sheenRoughnessMap,t(v.sheenRoughnessMap,x.sheenRoughnessMapTransform))),v.clearcoat>0&&(x.clearcoat.value=v.clearcoat,x.clearcoatRoughness.value=v.clearcoatRoughness,v.clearcoatMap&&(x.clearcoatMap.value=v.clearcoatMap,t(v.clearcoatMap,x.clearcoatMapTransform)),v.clearcoatRoughnessMap&&(x.clearcoatRoughnessMap.value=v.clearcoatRoughnessMap,t(v.clearcoatRoughnessMap,x.clearcoatRoughnessMapTransform)),v.clearcoatNormalMap&&(x.clearcoatNormalMap.value=v.clearcoatNormalMap,t(v.clearcoatNormalMap,x.clearcoatNormalMapTransform),x.clearcoatNormalScale.value.copy(v.clearcoatNormalScale),v.side===dn&&x.clearcoatNormalScale.value.negate())),v.dispersion>0&&(x.dispersion.value=v.dispersion),v.retroreflectivity>0&&(x.retroreflectivity.value=v.retroreflectivity),v.iridescence>0&&(x.iridescence.value=v.iridescence,x.iridescenceIOR.value=v.iridescenceIOR,x.iridescenceThicknessMinimum.value=v.iridescenceThicknessMinimum,x.iridescenceThicknessMaximum.value=v.iridescenceThicknessMaximum,v.iridescenceMap&&(x.iridescenceMap.value=v.iridescenceMap,t(v.iridescenceMap,x.iridescenceMapTransform)),v.iridescenceThicknessMap&&(x.iridescenceThicknessMap.value=v.iridescenceThicknessMap,t(v.iridescenceThicknessMap,x.iridescenceThicknessMapTransform))),v.transmission>0&&(x.transmission.value=v.transmission,x.transmissionSamplerMap.value=P.texture,x.transmissionSamplerSize.value.set(P.width,P.height),v.transmissionMap&&(x.transmissionMap.value=v.transmissionMap,t(v.transmissionMap,x.transmissionMapTransform)),x.thickness.value=v.thickness,v.thicknessMap&&(x.thicknessMap.value=v.thicknessMap,t(v.thicknessMap,x.thicknessMapTransform)),x.attenuationDistance.value=v.attenuationDistance,x.attenuationColor.value.copy(v.attenuationColor)),v.anisotropy>0&&(x.anisotropyVector.value.set(v.anisotropy*Math.cos(v.anisotropyRotation),v.anisotropy*Math.sin(v.anisotropyRotation)),v.anisotropyMap&&(x.anisotropyMap.value=v.anisotropyMap,t(v.anisotropyMap,x.anisotropyMapTransform))),x.specularIntensity.value=v.specularIntensity,x.specularColor.value.copy(v.specularColor),v.specularColorMap&&(x.specularColorMap.value=v.specularColorMap,t(v.specularColorMap,x.specularColorMapTransform)),v.specularIntensityMap&&(x.specularIntensityMap.value=v.specularIntensityMap,t(v.specularIntensityMap,x.specularIntensityMapTransform))}function E(x,v){v.matcap&&(x.matcap.value=v.matcap)}function R(x,v){let P=e.get(v).light;x.referencePosition.value.setFromMatrixPosition(P.matrixWorld),x.nearDistance.value=P.shadow.camera.near,x.farDistance.value=P.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function bb(i,e,t,n){let s={},o={};function l(P,U){let I=U.program;n.uniformBlockBinding(P,I,s[P.id])}function h(P,U){let I=s[P.id];I===void 0&&(E(P),I=f(P),s[P.id]=I,P.addEventListener("dispose",x));let O=U.program;n.updateUBOMapping(P,O);let N=e.render.frame;o[P.id]!==N&&(d(P),o[P.id]=N)}function f(P){let U=i.createBuffer(),I=P.__size,O=P.usage;return i.bindBuffer(i.UNIFORM_BUFFER,U),i.bufferData(i.UNIFORM_BUFFER,I,O),i.bindBuffer(i.UNIFORM_BUFFER,null),U}function d(P){let U=s[P.id],I=P.uniforms,O=P.__cache;i.bindBuffer(i.UNIFORM_BUFFER,U);for(let N=0,b=I.length;N<b;N++){let D=I[N];if(Array.isArray(D))for(let q=0,k=D.length;q<k;q++)m(D[q],N,q,O);else m(D,N,0,O)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(P,U,I,O){if(g(P,U,I,O)===!0){let N=P.__offset,b=P.value;if(Array.isArray(b)){let D=0;for(let q=0;q<b.length;q++){let k=b[q],Y=R(k,!0);y(k,P.__data,D),D+=Y.storage/Float32Array.BYTES_PER_ELEMENT}}else y(b,P.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,N,P.__data)}}function y(P,U,I){typeof P=="number"||typeof P=="boolean"?U[I]=P:P.isMatrix3?(U[I]=P.elements[0],U[I+1]=P.elements[1],U[I+2]=P.elements[2],U[I+3]=0,U[I+4]=P.elements[3],U[I+5]=P.elements[4],U[I+6]=P.elements[5],U[I+7]=0,U[I+8]=P.elements[6],U[I+9]=P.elements[7],U[I+10]=P.elements[8],U[I+11]=0):ArrayBuffer.isView(P)?U.set(P.subarray(0,U.length-I),I):P.toArray(U,I)}function g(P,U,I,O){let N=P.value,b=U+"_"+I;if(Array.isArray(N)){O[b]===void 0&&(O[b]=[]);let D=O[b],q=!1;for(let k=0;k<N.length;k++)S(N[k],D,k)===!0&&(q=!0);return q}return S(N,O,b)}function S(P,U,I){if(U[I]===void 0)return typeof P=="number"||typeof P=="boolean"?U[I]=P:ArrayBuffer.isView(P)?U[I]=P.slice():U[I]=P.clone(),!0;{let O=U[I];if(typeof P=="number"||typeof P=="boolean"){if(O!==P)return U[I]=P,!0}else{if(ArrayBuffer.isView(P))return!0;if(O.equals(P)===!1)return O.copy(P),!0}}return!1}function E(P){let U=P.uniforms,I=0,O=16;for(let b=0,D=U.length;b<D;b++){let q=Array.isArray(U[b])?U[b]:[U[b]];for(let k=0,Y=q.length;k<Y;k++){let J=q[k],ee=Array.isArray(J.value)?J.value:[J.value],z=Array.isArray(U[b])||Array.isArray(J.value),ie=I;for(let ne=0,Se=ee.length;ne<Se;ne++){let re=ee[ne],H=R(re,z),ge=I%O,We=ge%H.boundary,it=ge+We;I+=We,it!==0&&O-it<H.storage&&(I+=O-it),ne===0&&(ie=I),I+=H.storage}let G=J.type==="int"?Int32Array:J.type==="uint"?Uint32Array:Float32Array;J.__data=new G((I-ie)/Float32Array.BYTES_PER_ELEMENT),J.__offset=ie}}let N=I%O;return N>0&&(I+=O-N),P.__size=I,P.__cache={},this}function R(P,U){let I={boundary:0,storage:0};return typeof P=="number"||typeof P=="boolean"?(I.boundary=4,I.storage=4):P.isVector2?(I.boundary=8,I.storage=8):P.isVector3||P.isColor?(I.boundary=16,I.storage=12):P.isVector4?(I.boundary=16,I.storage=16):P.isMatrix3?(I.boundary=16,I.storage=48):P.isMatrix4?(I.boundary=16,I.storage=64):P.isTexture?Qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(P)?(I.boundary=16,I.storage=P.byteLength):Qe("WebGLRenderer: Unsupported uniform value type.",P),U===!0&&(I.boundary=16,I.storage=Math.ceil(I.storage/16)*16),I}function x(P){let U=P.target;U.removeEventListener("dispose",x),i.deleteBuffer(s[U.id]),delete s[U.id],delete o[U.id]}function v(){for(let P in s)i.deleteBuffer(s[P]);s={},o={}}return{bind:l,update:h,dispose:v}}var wb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),pi=null;function Eb(){return pi===null&&(pi=new Cs(wb,16,16,Yi,jn),pi.name="DFG_LUT",pi.minFilter=Sn,pi.magFilter=Sn,pi.wrapS=ai,pi.wrapT=ai,pi.generateMipmaps=!1,pi.needsUpdate=!0),pi}var El=class{constructor(e={}){let{canvas:t=Ed(),context:n=null,depth:s=!0,stencil:o=!1,alpha:l=!1,antialias:h=!1,premultipliedAlpha:f=!0,preserveDrawingBuffer:d=!1,powerPreference:m="default",failIfMajorPerformanceCaveat:y=!1,reversedDepthBuffer:g=!1,outputBufferType:S=En}=e;this.isWebGLRenderer=!0;let E;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");E=n.getContextAttributes().alpha}else E=l;let R=S,x=new Set([$o,Xo,Wo]),v=new Set([En,Yn,Zr,pr,Go,Vo]),P=new Uint32Array(4),U=new Int32Array(4),I={textures:[],min:[],max:[],resolution:[]},O=null,N=null,b=[],D=[],q=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let k=this,Y=!1,J=null,ee=null,z=null,ie=null;this._outputColorSpace=mn;let G=0,ne=0,Se=null,re=-1,H=null,ge=new Gt,We=new Gt,it=null,ue=new ht(0),Fe=0,Pe=t.width,je=t.height,Ue=1,ot=null,Vt=null,Ke=new Gt(0,0,Pe,je),Et=new Gt(0,0,Pe,je),Ct=!1,mt=new zi,Ht=new _o,pt=!1,It=!1,Mt=new Lt,rn=new j,De=new Gt,$e={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},hn=!1;function sn(){return Se===null?Ue:1}let W=n;function vn(C,V){return t.getContext(C,V)}let Rt,Ut,Le,$t,Ze,Je,L,T,Z,ve,de,pe,Me,ae,le,Ce,B,he,se,Re,Ee,Ae,Xe;try{let C={alpha:!0,depth:s,stencil:o,antialias:h,premultipliedAlpha:f,preserveDrawingBuffer:d,powerPreference:m,failIfMajorPerformanceCaveat:y};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",qe,!1),t.addEventListener("webglcontextrestored",dt,!1),t.addEventListener("webglcontextcreationerror",Oe,!1),W===null){let V="webgl2";if(W=vn(V,C),W===null)throw vn(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ut()}catch(C){throw t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),nt("WebGLRenderer: "+C.message),C}function ut(){Rt=new US(W),Rt.init(),Ee=new vb(W,Rt),Ut=new ES(W,Rt,e,Ee),Le=new gb(W,Rt),Ut.reversedDepthBuffer&&g&&Le.buffers.depth.setReversed(!0),ee=W.createFramebuffer(),z=W.createFramebuffer(),ie=W.createFramebuffer(),$t=new kS(W),Ze=new nb,Je=new _b(W,Rt,Le,Ze,Ut,Ee,$t),L=new NS(k),T=new Gv(W),Ae=new bS(W,T),Z=new OS(W,T,$t,Ae),ve=new GS(W,Z,T,Ae,$t),he=new zS(W,Ut,Je),le=new TS(Ze),de=new tb(k,L,Rt,Ut,Ae,le),pe=new Mb(k,Ze),Me=new rb,ae=new hb(Rt),B=new MS(k,L,Le,ve,E,f),Ce=new mb(k,ve,Ut),Xe=new bb(W,$t,Ut,Le),se=new wS(W,Rt,$t),Re=new BS(W,Rt,$t),$t.programs=de.programs,k.capabilities=Ut,k.extensions=Rt,k.properties=Ze,k.renderLists=Me,k.shadowMap=Ce,k.state=Le,k.info=$t}R!==En&&(q=new HS(R,t.width,t.height,h,s,o));let we=new _h(k,W);this.xr=we,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let C=Rt.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Rt.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Ue},this.setPixelRatio=function(C){C!==void 0&&(Ue=C,this.setSize(Pe,je,!1))},this.getSize=function(C){return C.set(Pe,je)},this.setSize=function(C,V,te=!0){if(we.isPresenting){Qe("WebGLRenderer: Can't change size while VR device is presenting.");return}Pe=C,je=V,t.width=Math.floor(C*Ue),t.height=Math.floor(V*Ue),te===!0&&(t.style.width=C+"px",t.style.height=V+"px"),q!==null&&q.setSize(t.width,t.height),this.setViewport(0,0,C,V)},this.getDrawingBufferSize=function(C){return C.set(Pe*Ue,je*Ue).floor()},this.setDrawingBufferSize=function(C,V,te){Pe=C,je=V,Ue=te,t.width=Math.floor(C*te),t.height=Math.floor(V*te),this.setViewport(0,0,C,V)},this.setEffects=function(C){if(R===En){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let V=0;V<C.length;V++)if(C[V].isOutputPass===!0){Qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}q.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(ge)},this.getViewport=function(C){return C.copy(Ke)},this.setViewport=function(C,V,te,K){C.isVector4?Ke.set(C.x,C.y,C.z,C.w):Ke.set(C,V,te,K),Le.viewport(ge.copy(Ke).multiplyScalar(sn()).round())},this.getScissor=function(C){return C.copy(Et)},this.setScissor=function(C,V,te,K){C.isVector4?Et.set(C.x,C.y,C.z,C.w):Et.set(C,V,te,K),Le.scissor(We.copy(Et).multiplyScalar(sn()).round())},this.getScissorTest=function(){return Ct},this.setScissorTest=function(C){Le.setScissorTest(Ct=C)},this.setOpaqueSort=function(C){ot=C},this.setTransparentSort=function(C){Vt=C},this.getClearColor=function(C){return C.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(C=!0,V=!0,te=!0){let K=0;if(C){let $=!1;if(Se!==null){let Ie=Se.texture.format;$=x.has(Ie)}if($){let Ie=Se.texture.type,ze=v.has(Ie),Te=B.getClearColor(),Ne=B.getClearAlpha(),Ge=Te.r,rt=Te.g,gt=Te.b;ze?(P[0]=Ge,P[1]=rt,P[2]=gt,P[3]=Ne,W.clearBufferuiv(W.COLOR,0,P)):(U[0]=Ge,U[1]=rt,U[2]=gt,U[3]=Ne,W.clearBufferiv(W.COLOR,0,U))}else K|=W.COLOR_BUFFER_BIT}V&&(K|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(K|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&W.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),J=C},this.dispose=function(){t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),B.dispose(),Me.dispose(),ae.dispose(),Je.dispose(),Ze.dispose(),L.dispose(),ve.dispose(),Z.dispose(),Ae.dispose(),Xe.dispose(),de.dispose(),we.dispose(),we.removeEventListener("sessionstart",ns),we.removeEventListener("sessionend",_i),un.stop()};function qe(C){C.preventDefault(),Qc("WebGLRenderer: Context Lost."),Y=!0}function dt(){Qc("WebGLRenderer: Context Restored."),Y=!1;let C=$t.autoReset,V=Ce.enabled,te=Ce.autoUpdate,K=Ce.needsUpdate,$=Ce.type;ut(),$t.autoReset=C,Ce.enabled=V,Ce.autoUpdate=te,Ce.needsUpdate=K,Ce.type=$}function Oe(C){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function Tt(C){let V=C.target;V.removeEventListener("dispose",Tt),Ot(V)}function Ot(C){gi(C),Ze.remove(C)}function gi(C){let V=Ze.get(C).programs;V!==void 0&&(V.forEach(function(te){de.releaseProgram(te)}),C.isShaderMaterial&&de.releaseShaderCache(C))}this.renderBufferDirect=function(C,V,te,K,$,Ie){V===null&&(V=$e);let ze=$.isMesh&&$.matrixWorld.determinantAffine()<0,Te=Ll(C,V,te,K,$);Le.setMaterial(K,ze);let Ne=te.index,Ge=1;if(K.wireframe===!0){if(Ne=Z.getWireframeAttribute(te),Ne===void 0)return;Ge=2}let rt=te.drawRange,gt=te.attributes.position,Ve=rt.start*Ge,lt=(rt.start+rt.count)*Ge;Ie!==null&&(Ve=Math.max(Ve,Ie.start*Ge),lt=Math.min(lt,(Ie.start+Ie.count)*Ge)),Ne!==null?(Ve=Math.max(Ve,0),lt=Math.min(lt,Ne.count)):gt!=null&&(Ve=Math.max(Ve,0),lt=Math.min(lt,gt.count));let Wt=lt-Ve;if(Wt<0||Wt===1/0)return;Ae.setup($,K,Te,te,Ne);let ke,Dt=se;if(Ne!==null&&(ke=T.get(Ne),Dt=Re,Dt.setIndex(ke)),$.isMesh)K.wireframe===!0?(Le.setLineWidth(K.wireframeLinewidth*sn()),Dt.setMode(W.LINES)):Dt.setMode(W.TRIANGLES);else if($.isLine){let jt=K.linewidth;jt===void 0&&(jt=1),Le.setLineWidth(jt*sn()),$.isLineSegments?Dt.setMode(W.LINES):$.isLineLoop?Dt.setMode(W.LINE_LOOP):Dt.setMode(W.LINE_STRIP)}else $.isPoints?Dt.setMode(W.POINTS):$.isSprite&&Dt.setMode(W.TRIANGLES);if($.isBatchedMesh)if(Rt.get("WEBGL_multi_draw"))Dt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let jt=$._multiDrawStarts,He=$._multiDrawCounts,an=$._multiDrawCount,wt=Ne?T.get(Ne).bytesPerElement:1,Kn=Ze.get(K).currentProgram.getUniforms();for(let on=0;on<an;on++)Kn.setValue(W,"_gl_DrawID",on),Dt.render(jt[on]/wt,He[on])}else if($.isInstancedMesh)Dt.renderInstances(Ve,Wt,$.count);else if(te.isInstancedBufferGeometry){let jt=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,He=Math.min(te.instanceCount,jt);Dt.renderInstances(Ve,Wt,He)}else Dt.render(Ve,Wt)};function ye(C,V,te,K){J!==null&&C.isNodeMaterial&&J.setObject(K,C),pt===!0&&le.setState(C,te,!1),C.transparent===!0&&C.side===di&&C.forceSinglePass===!1?(C.side=dn,C.needsUpdate=!0,Zi(C,V,K),C.side=qi,C.needsUpdate=!0,Zi(C,V,K),C.side=di):Zi(C,V,K)}this.compile=function(C,V,te=null){te===null&&(te=C),J!==null&&J.renderStart(C,V,te),N=ae.get(te),N.init(V),D.push(N),te.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(N.pushLight($),$.castShadow&&N.pushShadow($))}),C!==te&&C.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(N.pushLight($),$.castShadow&&N.pushShadow($))}),N.setupLights(),J!==null&&J.updateLights(N.state.lightsArray),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),pt===!0&&le.setGlobalState(this.clippingPlanes,V),J!==null&&Ce.render(N.state.shadowsArray,te,V);let K=new Set;return C.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Ie=$.material;if(Ie)if(Array.isArray(Ie))for(let ze=0;ze<Ie.length;ze++){let Te=Ie[ze];ye(Te,te,V,$),K.add(Te)}else ye(Ie,te,V,$),K.add(Ie)}),N=D.pop(),J!==null&&J.renderEnd(),K},this.compileAsync=function(C,V,te=null){let K=this.compile(C,V,te);return new Promise($=>{function Ie(){if(K.forEach(function(ze){let Ne=Ze.get(ze).currentProgram;(Ne===void 0||Ne.isReady())&&K.delete(ze)}),K.size===0){$(C);return}setTimeout(Ie,10)}Rt.get("KHR_parallel_shader_compile")!==null?Ie():setTimeout(Ie,10)})};let _e=null;function Jn(C){_e&&_e(C)}function ns(){un.stop()}function _i(){un.start()}let un=new nf;un.setAnimationLoop(Jn),typeof self<"u"&&un.setContext(self),this.setAnimationLoop=function(C){_e=C,we.setAnimationLoop(C),C===null?un.stop():un.start()},we.addEventListener("sessionstart",ns),we.addEventListener("sessionend",_i),this.render=function(C,V){if(V!==void 0&&V.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(Y===!0)return;J!==null&&J.renderStart(C,V);let te=we.enabled===!0&&we.isPresenting===!0,K=q!==null&&(Se===null||te)&&q.begin(k,Se);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),we.enabled===!0&&we.isPresenting===!0&&(q===null||q.isCompositing()===!1)&&(we.cameraAutoUpdate===!0&&we.updateCamera(V),V=we.getCamera()),C.isScene===!0&&C.onBeforeRender(k,C,V,Se),N=ae.get(C,D.length),N.init(V),N.state.textureUnits=Je.getTextureUnits(),D.push(N),Mt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Ht.setFromArrayCamera(V):mt.setFromProjectionMatrix(Mt,Bn,V.reversedDepth),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),O=Me.get(C,b.length),O.init(),b.push(O),this.info.render.frame++,we.enabled===!0&&we.isPresenting===!0){let ze=k.xr.getDepthSensingMesh();ze!==null&&is(ze,V,-1/0,k.sortObjects)}is(C,V,0,k.sortObjects),O.finish(),J!==null&&J.updateLights(N.state.lightsArray),k.sortObjects===!0&&O.sort(ot,Vt),hn=we.enabled===!1||we.isPresenting===!1||we.hasDepthSensing()===!1,hn&&B.addToRenderList(O,C),this.info.autoReset===!0&&this.info.reset(),pt===!0&&le.beginShadows();let $=N.state.shadowsArray;if(Ce.render($,C,V),pt===!0&&le.endShadows(),(K&&q.hasRenderPass())===!1){let ze=O.opaque,Te=O.transmissive;if(N.setupLights(),V.isArrayCamera){let Ne=V.cameras;if(Te.length>0)for(let Ge=0,rt=Ne.length;Ge<rt;Ge++){let gt=Ne[Ge];ji(ze,Te,C,gt)}hn&&B.render(C);for(let Ge=0,rt=Ne.length;Ge<rt;Ge++){let gt=Ne[Ge];Fn(O,C,gt,gt.viewport)}}else Te.length>0&&ji(ze,Te,C,V),hn&&B.render(C),Fn(O,C,V)}Se!==null&&ne===0&&(Je.updateMultisampleRenderTarget(Se),Je.updateRenderTargetMipmap(Se)),K&&q.end(k),C.isScene===!0&&C.onAfterRender(k,C,V),Ae.resetDefaultState(),re=-1,H=null,D.pop(),D.length>0?(N=D[D.length-1],Je.setTextureUnits(N.state.textureUnits),pt===!0&&le.setGlobalState(k.clippingPlanes,N.state.camera)):N=null,b.pop(),b.length>0?O=b[b.length-1]:O=null,J!==null&&J.renderEnd()};function is(C,V,te,K){if(C.visible===!1)return;if(C.layers.test(V.layers)){if(C.isGroup)te=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(V);else if(C.isLight)N.pushLight(C),C.castShadow&&N.pushShadow(C);else if(C.isSprite){let ze=V.isArrayCamera?Ht:mt;if(!C.frustumCulled||C.intersectsFrustum(ze)){K&&De.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Mt);let Te=ve.update(C),Ne=C.material;Ne.visible&&O.push(C,Te,Ne,te,De.z,null,V)}}else if(C.isMesh||C.isLine||C.isPoints){let ze=V.isArrayCamera?Ht:mt;if(!C.frustumCulled||C.intersectsFrustum(ze)){let Te=ve.update(C),Ne=C.material;if(K&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),De.copy(C.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),De.copy(Te.boundingSphere.center)),De.applyMatrix4(C.matrixWorld).applyMatrix4(Mt)),Array.isArray(Ne)){let Ge=Te.groups;for(let rt=0,gt=Ge.length;rt<gt;rt++){let Ve=Ge[rt],lt=Ne[Ve.materialIndex];lt&&lt.visible&&O.push(C,Te,lt,te,De.z,Ve,V)}}else Ne.visible&&O.push(C,Te,Ne,te,De.z,null,V)}}}let Ie=C.children;for(let ze=0,Te=Ie.length;ze<Te;ze++)is(Ie[ze],V,te,K)}function Fn(C,V,te,K){let{opaque:$,transmissive:Ie,transparent:ze}=C;N.setupLightsView(te),pt===!0&&le.setGlobalState(k.clippingPlanes,te),K&&Le.viewport(ge.copy(K)),$.length>0&&gr($,V,te),Ie.length>0&&gr(Ie,V,te),ze.length>0&&gr(ze,V,te),Le.buffers.depth.setTest(!0),Le.buffers.depth.setMask(!0),Le.buffers.color.setMask(!0),Le.setPolygonOffset(!1)}function ji(C,V,te,K){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(N.state.transmissionRenderTarget[K.id]===void 0){let Ve=Rt.has("EXT_color_buffer_half_float")||Rt.has("EXT_color_buffer_float");N.state.transmissionRenderTarget[K.id]=new Dn(1,1,{generateMipmaps:!0,type:Ve?jn:En,minFilter:Ci,samples:Math.max(4,Ut.samples),stencilBuffer:o,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ie=N.state.transmissionRenderTarget[K.id],ze=K.viewport||ge;Ie.setSize(ze.z*k.transmissionResolutionScale,ze.w*k.transmissionResolutionScale);let Te=k.getRenderTarget(),Ne=k.getActiveCubeFace(),Ge=k.getActiveMipmapLevel();k.setRenderTarget(Ie),k.getClearColor(ue),Fe=k.getClearAlpha(),Fe<1&&k.setClearColor(16777215,.5),k.clear(),hn&&B.render(te);let rt=k.toneMapping;k.toneMapping=fi;let gt=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),N.setupLightsView(K),pt===!0&&le.setGlobalState(k.clippingPlanes,K),gr(C,te,K),Je.updateMultisampleRenderTarget(Ie),Je.updateRenderTargetMipmap(Ie),Rt.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let lt=0,Wt=V.length;lt<Wt;lt++){let ke=V[lt],{object:Dt,geometry:jt,material:He,group:an}=ke;if(He.side===di&&Dt.layers.test(K.layers)){let wt=He.side;He.side=dn,He.needsUpdate=!0,ca(Dt,te,K,jt,He,an),He.side=wt,He.needsUpdate=!0,Ve=!0}}Ve===!0&&(Je.updateMultisampleRenderTarget(Ie),Je.updateRenderTargetMipmap(Ie))}k.setRenderTarget(Te,Ne,Ge),k.setClearColor(ue,Fe),gt!==void 0&&(K.viewport=gt),k.toneMapping=rt}function gr(C,V,te){let K=V.isScene===!0?V.overrideMaterial:null;for(let $=0,Ie=C.length;$<Ie;$++){let ze=C[$],{object:Te,geometry:Ne,group:Ge}=ze,rt=ze.material;rt.allowOverride===!0&&K!==null&&(rt=K),Te.layers.test(te.layers)&&ca(Te,V,te,Ne,rt,Ge)}}function ca(C,V,te,K,$,Ie){J!==null&&$.isNodeMaterial&&J.setObject(C,$),C.onBeforeRender(k,V,te,K,$,Ie),C.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),$.onBeforeRender(k,V,te,K,C,Ie),$.transparent===!0&&$.side===di&&$.forceSinglePass===!1?($.side=dn,$.needsUpdate=!0,k.renderBufferDirect(te,V,K,$,C,Ie),$.side=qi,$.needsUpdate=!0,k.renderBufferDirect(te,V,K,$,C,Ie),$.side=di):k.renderBufferDirect(te,V,K,$,C,Ie),C.onAfterRender(k,V,te,K,$,Ie)}function Nn(C){let V=0;for(let te of C)te.texture!==null&&V++;return V}function Zi(C,V,te){V.isScene!==!0&&(V=$e);let K=Ze.get(C),$=N.state.lights,Ie=N.state.shadowsArray,ze=$.state.version,Te=de.getParameters(C,$.state,Ie,V,te,N.state.lightProbeGridArray),Ne=de.getProgramCacheKey(Te),Ge=K.programs;K.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?V.environment:null,K.fog=V.fog;let rt=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;K.envMap=L.get(C.envMap||K.environment,rt),K.envMapRotation=K.environment!==null&&C.envMap===null?V.environmentRotation:C.envMapRotation,Ge===void 0&&(C.addEventListener("dispose",Tt),Ge=new Map,K.programs=Ge,K.programVariants=new Map);let gt=Ge.get(Ne);if(gt!==void 0){if(K.currentProgram===gt&&K.lightsStateVersion===ze)return vr(C,Te),gt}else Te.uniforms=de.getUniforms(C),J!==null&&C.isNodeMaterial&&J.build(C,te,Te),C.onBeforeCompile(Te,k),gt=de.acquireProgram(Te,Ne),Ge.set(Ne,gt),K.uniforms=Te.uniforms;let Ve=K.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Ve.clippingPlanes=le.uniform),vr(C,Te),K.needsLights=Nl(C),K.lightsStateVersion=ze,K.needsLights&&(Ve.ambientLightColor.value=$.state.ambient,Ve.lightProbe.value=$.state.probe,Ve.sunLights.value=$.state.sun,Ve.sunLightShadows.value=$.state.sunShadow,Ve.directionalLights.value=$.state.directional,Ve.directionalLightShadows.value=$.state.directionalShadow,Ve.spotLights.value=$.state.spot,Ve.spotLightShadows.value=$.state.spotShadow,Ve.rectAreaLights.value=$.state.rectArea,Ve.ltc_1.value=$.state.rectAreaLTC1,Ve.ltc_2.value=$.state.rectAreaLTC2,Ve.pointLights.value=$.state.point,Ve.pointLightShadows.value=$.state.pointShadow,Ve.hemisphereLights.value=$.state.hemi,Ve.sunShadowMatrix.value=$.state.sunShadowMatrix,Ve.sunShadowCascade.value=$.state.sunShadowCascade,Ve.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Ve.spotLightMatrix.value=$.state.spotLightMatrix,Ve.spotLightMap.value=$.state.spotLightMap,Ve.pointShadowMatrix.value=$.state.pointShadowMatrix),K.numLightProbeGrids=Nn(N.state.lightProbeGridArray),K.currentProgram=gt,K.uniformsList=null,gt}function _r(C,V,te,K,$){let Ie=Ze.get(C),ze=Ie.currentProgram.id+","+K+","+$,Te=Ie.programVariants.get(ze);return Te===void 0?(Te=Zi(C,V,te),Ie.programVariants.set(ze,Te)):(Ie.currentProgram=Te,Ie.uniformsList=null,Ie.outputColorSpace=K,Ie.toneMapping=$),Te}function Ji(C){if(C.uniformsList===null){let V=C.currentProgram.getUniforms();C.uniformsList=Kr.seqWithValue(V.seq,C.uniforms)}return C.uniformsList}function vr(C,V){let te=Ze.get(C);te.outputColorSpace=V.outputColorSpace,te.batching=V.batching,te.batchingColor=V.batchingColor,te.instancing=V.instancing,te.instancingColor=V.instancingColor,te.instancingMorph=V.instancingMorph,te.skinning=V.skinning,te.morphTargets=V.morphTargets,te.morphNormals=V.morphNormals,te.morphColors=V.morphColors,te.morphTargetsCount=V.morphTargetsCount,te.numClippingPlanes=V.numClippingPlanes,te.numIntersection=V.numClipIntersection,te.vertexAlphas=V.vertexAlphas,te.vertexTangents=V.vertexTangents,te.toneMapping=V.toneMapping}function Ll(C,V,te,K,$){V.isScene!==!0&&(V=$e),Je.resetTextureUnits();let Ie=V.fog,ze=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?V.environment:null,Te=Se===null?k.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:St.workingColorSpace,Ne=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ge=L.get(K.envMap||ze,Ne),rt=K.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,gt=!!te.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),Ve=!!te.morphAttributes.position,lt=!!te.morphAttributes.normal,Wt=!!te.morphAttributes.color,ke=fi;K.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ke=k.toneMapping);let Dt=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,jt=Dt!==void 0?Dt.length:0,He=Ze.get(K),an=N.state.lights;if(pt===!0&&(It===!0||C!==H)){let Ft=C===H&&K.id===re;le.setState(K,C,Ft)}let wt=!1,Kn=!1;K.version===He.__version?He.needsLights&&He.lightsStateVersion!==an.state.version||$.isBatchedMesh&&He.batching===!1||!$.isBatchedMesh&&He.batching===!0||$.isBatchedMesh&&He.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&He.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&He.instancing===!1||!$.isInstancedMesh&&He.instancing===!0||$.isSkinnedMesh&&He.skinning===!1||!$.isSkinnedMesh&&He.skinning===!0||$.isInstancedMesh&&He.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&He.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&He.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&He.instancingMorph===!1&&$.morphTexture!==null||He.envMap!==Ge||K.fog===!0&&He.fog!==Ie||He.numClippingPlanes!==void 0&&(He.numClippingPlanes!==le.numPlanes||He.numIntersection!==le.numIntersection)||He.vertexAlphas!==rt||He.vertexTangents!==gt||He.morphTargets!==Ve||He.morphNormals!==lt||He.morphColors!==Wt||He.morphTargetsCount!==jt||He.numLightProbeGrids!==Nn(N.state.lightProbeGridArray)?wt=!0:(He.outputColorSpace!==Te||He.toneMapping!==ke)&&(Kn=!0):(wt=!0,He.__version=K.version);let on=He.currentProgram;(wt===!0||Kn===!0)&&(on=Kn===!0?_r(K,V,$,Te,ke):Zi(K,V,$),J&&K.isNodeMaterial&&J.onUpdateProgram(K,on,He));let Ii=!1,Qn=!1,ei=!1,M=on.getUniforms(),ft=He.uniforms;if(Le.useProgram(on.program)&&(Ii=!0,Qn=!0,ei=!0),K.id!==re&&(re=K.id,Qn=!0),Ii||H!==C){Le.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),M.setValue(W,"projectionMatrix",C.projectionMatrix),M.setValue(W,"viewMatrix",C.matrixWorldInverse);let Bt=M.map.cameraPosition;Bt!==void 0&&Bt.setValue(W,rn.setFromMatrixPosition(C.matrixWorld)),Ut.logarithmicDepthBuffer&&M.setValue(W,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&M.setValue(W,"isOrthographic",C.isOrthographicCamera===!0),H!==C&&(H=C,Qn=!0,ei=!0)}if(He.needsLights&&(an.state.sunShadowMap.length>0&&M.setValue(W,"sunShadowMap",an.state.sunShadowMap,Je),an.state.directionalShadowMap.length>0&&M.setValue(W,"directionalShadowMap",an.state.directionalShadowMap,Je),an.state.spotShadowMap.length>0&&M.setValue(W,"spotShadowMap",an.state.spotShadowMap,Je),an.state.pointShadowMap.length>0&&M.setValue(W,"pointShadowMap",an.state.pointShadowMap,Je)),$.isSkinnedMesh){M.setOptional(W,$,"bindMatrix"),M.setOptional(W,$,"bindMatrixInverse");let Ft=$.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),M.setValue(W,"boneTexture",Ft.boneTexture,Je))}$.isBatchedMesh&&(M.setOptional(W,$,"batchingTexture"),M.setValue(W,"batchingTexture",$._matricesTexture,Je),M.setOptional(W,$,"batchingIdTexture"),M.setValue(W,"batchingIdTexture",$._indirectTexture,Je),M.setOptional(W,$,"batchingColorTexture"),$._colorsTexture!==null&&M.setValue(W,"batchingColorTexture",$._colorsTexture,Je));let An=te.morphAttributes;if((An.position!==void 0||An.normal!==void 0||An.color!==void 0)&&he.update($,te,on),(Qn||He.receiveShadow!==$.receiveShadow)&&(He.receiveShadow=$.receiveShadow,M.setValue(W,"receiveShadow",$.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&V.environment!==null&&(ft.envMapIntensity.value=V.environmentIntensity),ft.dfgLUT!==void 0&&(ft.dfgLUT.value=Eb()),Qn){if(M.setValue(W,"toneMappingExposure",k.toneMappingExposure),He.needsLights&&Fl(ft,ei),Ie&&K.fog===!0&&pe.refreshFogUniforms(ft,Ie),pe.refreshMaterialUniforms(ft,K,Ue,je,N.state.transmissionRenderTarget[C.id]),He.needsLights&&He.numLightProbeGrids>0){let Ft=I,Bt=0;for(let Gn of N.state.lightProbeGridArray)Gn.texture!==null&&(Ft.textures[Bt]=Gn.texture,Ft.min[Bt]=Gn.boundingBox.min,Ft.max[Bt]=Gn.boundingBox.max,Ft.resolution[Bt]=Gn.resolution,Bt++);for(let Gn in Ft)Ft[Gn].length=Bt;ft.probesSH.value=Ft.textures,ft.probesMin.value=Ft.min,ft.probesMax.value=Ft.max,ft.probesResolution.value=Ft.resolution}Kr.upload(W,Ji(He),ft,Je)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Kr.upload(W,Ji(He),ft,Je),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&M.setValue(W,"center",$.center),M.setValue(W,"modelViewMatrix",$.modelViewMatrix),M.setValue(W,"normalMatrix",$.normalMatrix),M.setValue(W,"modelMatrix",$.matrixWorld),K.uniformsGroups!==void 0){let Ft=K.uniformsGroups;for(let Bt=0,Gn=Ft.length;Bt<Gn;Bt++){let ha=Ft[Bt];Xe.update(ha,on),Xe.bind(ha,on)}}return on}function Fl(C,V){C.ambientLightColor.needsUpdate=V,C.lightProbe.needsUpdate=V,C.sunLights.needsUpdate=V,C.sunLightShadows.needsUpdate=V,C.directionalLights.needsUpdate=V,C.directionalLightShadows.needsUpdate=V,C.pointLights.needsUpdate=V,C.pointLightShadows.needsUpdate=V,C.spotLights.needsUpdate=V,C.spotLightShadows.needsUpdate=V,C.rectAreaLights.needsUpdate=V,C.hemisphereLights.needsUpdate=V}function Nl(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return ne},this.getRenderTarget=function(){return Se},this.setRenderTargetTextures=function(C,V,te){let K=Ze.get(C);K.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Ze.get(C.texture).__webglTexture=V,Ze.get(C.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:te,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,V){let te=Ze.get(C);te.__webglFramebuffer=V,te.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(C,V=0,te=0){Se=C,G=V,ne=te;let K=null,$=!1,Ie=!1;if(C){let Te=Ze.get(C);if(Te.__useDefaultFramebuffer!==void 0){Le.bindFramebuffer(W.FRAMEBUFFER,Te.__webglFramebuffer),ge.copy(C.viewport),We.copy(C.scissor),it=C.scissorTest,Le.viewport(ge),Le.scissor(We),Le.setScissorTest(it),re=-1;return}else if(Te.__webglFramebuffer===void 0)Je.setupRenderTarget(C);else if(Te.__hasExternalTextures)Je.rebindTextures(C,Ze.get(C.texture).__webglTexture,Ze.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let rt=C.depthTexture;if(Te.__boundDepthTexture!==rt){if(rt!==null&&Ze.has(rt)&&(C.width!==rt.image.width||C.height!==rt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Je.setupDepthRenderbuffer(C)}}let Ne=C.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ie=!0);let Ge=Ze.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Ge[V])?K=Ge[V][te]:K=Ge[V],$=!0):C.samples>0&&Je.useMultisampledRTT(C)===!1?K=Ze.get(C).__webglMultisampledFramebuffer:Array.isArray(Ge)?K=Ge[te]:K=Ge,ge.copy(C.viewport),We.copy(C.scissor),it=C.scissorTest}else ge.copy(Ke).multiplyScalar(Ue).floor(),We.copy(Et).multiplyScalar(Ue).floor(),it=Ct;if(te!==0&&(K=ee),Le.bindFramebuffer(W.FRAMEBUFFER,K)&&Le.drawBuffers(C,K),Le.viewport(ge),Le.scissor(We),Le.setScissorTest(it),$){let Te=Ze.get(C.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+V,Te.__webglTexture,te)}else if(Ie){let Te=V;for(let Ne=0;Ne<C.textures.length;Ne++){let Ge=Ze.get(C.textures[Ne]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,te,Te)}}else if(C!==null&&te!==0){let Te=Ze.get(C.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Te.__webglTexture,te)}re=-1};function rs(C){let V=Ze.get(C);return(V.__readFormat!==C.format||V.__readType!==C.type)&&(V.__readFormat=C.format,V.__readType=C.type,V.__formatReadable=Ut.textureFormatReadable(C.format),V.__typeReadable=Ut.textureTypeReadable(C.type)),V}this.readRenderTargetPixels=function(C,V,te,K,$,Ie,ze,Te=0){if(!(C&&C.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ze.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);try{let Ge=C.textures[Te],rt=Ge.format,gt=Ge.type;C.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=rs(Ge);if(Ve.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=C.width-K&&te>=0&&te<=C.height-$&&W.readPixels(V,te,K,$,Ee.convert(rt),Ee.convert(gt),Ie)}finally{let Ge=Se!==null?Ze.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(C,V,te,K,$,Ie,ze,Te=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ze.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(V>=0&&V<=C.width-K&&te>=0&&te<=C.height-$){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);let Ge=C.textures[Te],rt=Ge.format,gt=Ge.type;C.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=rs(Ge);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let lt=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.bufferData(W.PIXEL_PACK_BUFFER,Ie.byteLength,W.STREAM_READ),W.readPixels(V,te,K,$,Ee.convert(rt),Ee.convert(gt),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let Wt=Se!==null?Ze.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Wt);let ke=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await Ad(W,ke,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,Ie),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(lt),W.deleteSync(ke),Ie}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,V=null,te=0){let K=Math.pow(2,-te),$=Math.floor(C.image.width*K),Ie=Math.floor(C.image.height*K),ze=V!==null?V.x:0,Te=V!==null?V.y:0;Je.setTexture2D(C,0),W.copyTexSubImage2D(W.TEXTURE_2D,te,0,0,ze,Te,$,Ie),Le.unbindTexture()},this.copyTextureToTexture=function(C,V,te=null,K=null,$=0,Ie=0){let ze,Te,Ne,Ge,rt,gt,Ve,lt,Wt,ke=C.isCompressedTexture?C.mipmaps[Ie]:C.image;if(te!==null)ze=te.max.x-te.min.x,Te=te.max.y-te.min.y,Ne=te.isBox3?te.max.z-te.min.z:1,Ge=te.min.x,rt=te.min.y,gt=te.isBox3?te.min.z:0;else{let M=Math.pow(2,-$);ze=Math.floor(ke.width*M),Te=Math.floor(ke.height*M),C.isDataArrayTexture?Ne=ke.depth:C.isData3DTexture?Ne=Math.floor(ke.depth*M):Ne=1,Ge=0,rt=0,gt=0}K!==null?(Ve=K.x,lt=K.y,Wt=K.z):(Ve=0,lt=0,Wt=0);let Dt=Ee.convert(V.format),jt=Ee.convert(V.type),He;V.isData3DTexture?(Je.setTexture3D(V,0),He=W.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Je.setTexture2DArray(V,0),He=W.TEXTURE_2D_ARRAY):(Je.setTexture2D(V,0),He=W.TEXTURE_2D),Le.activeTexture(W.TEXTURE0),Le.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,V.flipY),Le.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Le.pixelStorei(W.UNPACK_ALIGNMENT,V.unpackAlignment);let an=Le.getParameter(W.UNPACK_ROW_LENGTH),wt=Le.getParameter(W.UNPACK_IMAGE_HEIGHT),Kn=Le.getParameter(W.UNPACK_SKIP_PIXELS),on=Le.getParameter(W.UNPACK_SKIP_ROWS),Ii=Le.getParameter(W.UNPACK_SKIP_IMAGES);Le.pixelStorei(W.UNPACK_ROW_LENGTH,ke.width),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,ke.height),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,Ge),Le.pixelStorei(W.UNPACK_SKIP_ROWS,rt),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,gt);let Qn=C.isDataArrayTexture||C.isData3DTexture,ei=V.isDataArrayTexture||V.isData3DTexture;if(C.isDepthTexture){let M=Ze.get(C),ft=Ze.get(V),An=Ze.get(M.__renderTarget),Ft=Ze.get(ft.__renderTarget);Le.bindFramebuffer(W.READ_FRAMEBUFFER,An.__webglFramebuffer),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let Bt=0;Bt<Ne;Bt++)Qn&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Ze.get(C).__webglTexture,$,gt+Bt),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Ze.get(V).__webglTexture,Ie,Wt+Bt)),W.blitFramebuffer(Ge,rt,Ge+ze,rt+Te,Ve,lt,Ve+ze,lt+Te,W.DEPTH_BUFFER_BIT,W.NEAREST);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if($!==0||C.isRenderTargetTexture||Ze.has(C)){let M=Ze.get(C),ft=Ze.get(V);Le.bindFramebuffer(W.READ_FRAMEBUFFER,z),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,ie);for(let An=0;An<Ne;An++)Qn?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,M.__webglTexture,$,gt+An):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,M.__webglTexture,$),ei?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,ft.__webglTexture,Ie,Wt+An):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,ft.__webglTexture,Ie),$!==0?W.blitFramebuffer(Ge,rt,Ge+ze,rt+Te,Ve,lt,Ve+ze,lt+Te,W.COLOR_BUFFER_BIT,W.NEAREST):ei?W.copyTexSubImage3D(He,Ie,Ve,lt,Wt+An,Ge,rt,ze,Te):W.copyTexSubImage2D(He,Ie,Ve,lt,Ge,rt,ze,Te);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else ei?C.isDataTexture||C.isData3DTexture?W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke.data):V.isCompressedArrayTexture?W.compressedTexSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,ke.data):W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke):C.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke.data):C.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ke.width,ke.height,Dt,ke.data):W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke);Le.pixelStorei(W.UNPACK_ROW_LENGTH,an),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,wt),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,Kn),Le.pixelStorei(W.UNPACK_SKIP_ROWS,on),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,Ii),Ie===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&W.generateMipmap(He),Le.unbindTexture()},this.initRenderTarget=function(C){Ze.get(C).__webglFramebuffer===void 0&&Je.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Je.setTextureCube(C,0):C.isData3DTexture?Je.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Je.setTexture2DArray(C,0):Je.setTexture2D(C,0),Le.unbindTexture()},this.resetState=function(){G=0,ne=0,Se=null,Le.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var pf={type:"change"},yh={type:"start"},gf={type:"end"},Cl=new ki,mf=new Pn,Ab=Math.cos(70*ih.DEG2RAD),nn=new j,Tn=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},vh=1e-6,Rl=class extends qs{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new j,this.cursor=new j,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Xi.ROTATE,MIDDLE:Xi.DOLLY,RIGHT:Xi.PAN},this.touches={ONE:$i.ROTATE,TWO:$i.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new j,this._lastQuaternion=new Mn,this._lastTargetPosition=new j,this._quat=new Mn().setFromUnitVectors(e.up,new j(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new $r,this._sphericalDelta=new $r,this._scale=1,this._panOffset=new j,this._rotateStart=new et,this._rotateEnd=new et,this._rotateDelta=new et,this._panStart=new et,this._panEnd=new et,this._panDelta=new et,this._dollyStart=new et,this._dollyEnd=new et,this._dollyDelta=new et,this._dollyDirection=new j,this._mouse=new et,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Rb.bind(this),this._onPointerDown=Cb.bind(this),this._onPointerUp=Pb.bind(this),this._onContextMenu=Ob.bind(this),this._onMouseWheel=Lb.bind(this),this._onKeyDown=Fb.bind(this),this._onTouchStart=Nb.bind(this),this._onTouchMove=Ub.bind(this),this._onMouseDown=Ib.bind(this),this._onMouseMove=Db.bind(this),this._interceptControlDown=Bb.bind(this),this._interceptControlUp=kb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(pf),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;nn.copy(t).sub(this.target),nn.applyQuaternion(this._quat),this._spherical.setFromVector3(nn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Tn:n>Math.PI&&(n-=Tn),s<-Math.PI?s+=Tn:s>Math.PI&&(s-=Tn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let o=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let l=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),o=l!=this._spherical.radius}if(nn.setFromSpherical(this._spherical),nn.applyQuaternion(this._quatInverse),t.copy(this.target).add(nn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let l=null;if(this.object.isPerspectiveCamera){let h=nn.length();l=this._clampDistance(h*this._scale);let f=h-l;this.object.position.addScaledVector(this._dollyDirection,f),this.object.updateMatrixWorld(),o=!!f}else if(this.object.isOrthographicCamera){let h=new j(this._mouse.x,this._mouse.y,0);h.unproject(this.object);let f=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),o=f!==this.object.zoom;let d=new j(this._mouse.x,this._mouse.y,0);d.unproject(this.object),this.object.position.sub(d).add(h),this.object.updateMatrixWorld(),l=nn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;l!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(l).add(this.object.position):(Cl.origin.copy(this.object.position),Cl.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Cl.direction))<Ab?this.object.lookAt(this.target):(mf.setFromNormalAndCoplanarPoint(this.object.up,this.target),Cl.intersectPlane(mf,this.target))))}else if(this.object.isOrthographicCamera){let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),l!==this.object.zoom&&(this.object.updateProjectionMatrix(),o=!0)}return this._scale=1,this._performCursorZoom=!1,o||this._lastPosition.distanceToSquared(this.object.position)>vh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>vh||this._lastTargetPosition.distanceToSquared(this.target)>vh?(this.dispatchEvent(pf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Tn/60*this.autoRotateSpeed*e:Tn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){nn.setFromMatrixColumn(t,0),nn.multiplyScalar(-e),this._panOffset.add(nn)}_panUp(e,t){this.screenSpacePanning===!0?nn.setFromMatrixColumn(t,1):(nn.setFromMatrixColumn(t,0),nn.crossVectors(this.object.up,nn)),nn.multiplyScalar(e),this._panOffset.add(nn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;nn.copy(s).sub(this.target);let o=nn.length();o*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*o/n.clientHeight,this.object.matrix),this._panUp(2*t*o/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,o=t-n.top,l=n.width,h=n.height;this._mouse.x=s/l*2-1,this._mouse.y=-(o/h)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Tn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Tn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Tn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,o=Math.sqrt(n*n+s*s);this._dollyStart.set(0,o)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),o=.5*(e.pageY+n.y);this._rotateEnd.set(s,o)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Tn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Tn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,o=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,o),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let l=(e.pageX+t.x)*.5,h=(e.pageY+t.y)*.5;this._updateZoomParameters(l,h)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new et,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Cb(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Rb(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function Pb(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(gf),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Ib(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Xi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=At.DOLLY;break;case Xi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}break;case Xi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(yh)}function Db(i){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function Lb(i){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(i.preventDefault(),this.dispatchEvent(yh),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(gf))}function Fb(i){this.enabled!==!1&&this._handleKeyDown(i)}function Nb(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case $i.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(i),this.state=At.TOUCH_ROTATE;break;case $i.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(i),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case $i.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=At.TOUCH_DOLLY_PAN;break;case $i.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(yh)}function Ub(i){switch(this._trackPointer(i),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=At.NONE}}function Ob(i){this.enabled!==!1&&i.preventDefault()}function Bb(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function kb(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Pl=class extends cr{constructor(){super(),this.name="RoomEnvironment",this.position.y=-3.5;let e=new hi;e.deleteAttribute("uv");let t=new Ai({side:dn}),n=new Ai,s=new Vs(16777215,900,28,2);s.position.set(.418,16.199,.3),this.add(s);let o=new zt(e,t);o.position.set(-.757,13.219,.717),o.scale.set(31.713,28.305,28.591),this.add(o);let l=new Ps(e,n,6),h=new Qt;h.position.set(-10.906,2.009,1.846),h.rotation.set(0,-.195,0),h.scale.set(2.328,7.905,4.651),h.updateMatrix(),l.setMatrixAt(0,h.matrix),h.position.set(-5.607,-.754,-.758),h.rotation.set(0,.994,0),h.scale.set(1.97,1.534,3.955),h.updateMatrix(),l.setMatrixAt(1,h.matrix),h.position.set(6.167,.857,7.803),h.rotation.set(0,.561,0),h.scale.set(3.927,6.285,3.687),h.updateMatrix(),l.setMatrixAt(2,h.matrix),h.position.set(-2.017,.018,6.124),h.rotation.set(0,.333,0),h.scale.set(2.002,4.566,2.064),h.updateMatrix(),l.setMatrixAt(3,h.matrix),h.position.set(2.291,-.756,-2.621),h.rotation.set(0,-.286,0),h.scale.set(1.546,1.552,1.496),h.updateMatrix(),l.setMatrixAt(4,h.matrix),h.position.set(-2.193,-.369,-5.547),h.rotation.set(0,.516,0),h.scale.set(3.875,3.487,2.986),h.updateMatrix(),l.setMatrixAt(5,h.matrix),this.add(l);let f=new zt(e,ts(50));f.position.set(-16.116,14.37,8.208),f.scale.set(.1,2.428,2.739),this.add(f);let d=new zt(e,ts(50));d.position.set(-16.109,18.021,-8.207),d.scale.set(.1,2.425,2.751),this.add(d);let m=new zt(e,ts(17));m.position.set(14.904,12.198,-1.832),m.scale.set(.15,4.265,6.331),this.add(m);let y=new zt(e,ts(43));y.position.set(-.462,8.89,14.52),y.scale.set(4.38,5.441,.088),this.add(y);let g=new zt(e,ts(20));g.position.set(3.235,11.486,-12.541),g.scale.set(2.5,2,.1),this.add(g);let S=new zt(e,ts(100));S.position.set(0,20,0),S.scale.set(1,.1,1),this.add(S)}dispose(){let e=new Set;this.traverse(t=>{t.isMesh&&(e.add(t.geometry),e.add(t.material))});for(let t of e)t.dispose()}};function ts(i){return new Os({color:0,emissive:16777215,emissiveIntensity:i})}var _f=14477040,zb=["#edf1f6","#cfd7e1"],Gb=15113984,yf=.5,[Vb,Hb,Wb,Xb,$b,qb]=[2,3,4,5,6,7],Yb=3,Il=class{constructor(e,t){Object.assign(this,{canvas:e,scale:t,follow:!0,robots:[],target:new j}),this.renderer=new El({canvas:e,antialias:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=hr,this.renderer.toneMapping=Ys,this.scene=new cr,this.scene.background=new ht(_f),this.scene.fog=new ws(_f,4*t,16*t),this.scene.environment=new Qr(this.renderer).fromScene(new Pl,.04).texture,this.scene.environmentIntensity=.55,this.world=this.scene.add(new kn).children.at(-1),this.camera=new gn(38,1,.01*t,60*t),this.camera.up.set(0,0,1),this.orbit=new Rl(this.camera,e),Object.assign(this.orbit,{enableDamping:!0,enablePan:!1,minDistance:.3*t,maxDistance:6*t,maxPolarAngle:1.52}),this.resetCamera(),this.light=new Ws(16777215,2.2),this.light.castShadow=!0,this.light.shadow.mapSize.set(1024,1024),Object.assign(this.light.shadow.camera,{left:-t,right:t,top:t,bottom:-t,near:.1,far:6*t}),Object.assign(this.light.shadow,{radius:4,bias:-5e-4,normalBias:.01*t}),this.scene.add(this.light,this.light.target);let n=new Ls(Kb());n.colorSpace=mn,n.wrapS=n.wrapT=Ur,n.anisotropy=this.renderer.capabilities.getMaxAnisotropy(),this.floor=new Ai({map:n,roughness:.95,envMapIntensity:.6}),this.arrow=new $s(new j(1,0,0),new j,.3*t,Gb,.12*t,.09*t),this.arrow.visible=!1,this.world.add(this.arrow),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;!e||!t||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.fov=38*Math.min(1.5,Math.max(1,1/this.camera.aspect)),this.camera.updateProjectionMatrix())}resetCamera(){this.camera.position.copy(this.target).add(new j(.62,-1,.42).multiplyScalar(this.scale))}setTerrain(e){this.ground?.traverse(s=>s.geometry?.dispose()),this.ground?.removeFromParent(),this.ground=new kn;let t=80*this.scale,n=new Gi(t,t);if(vf(n,this.scale),this.plane=new zt(n,this.floor),this.plane.receiveShadow=!0,this.ground.add(this.plane),e.grid){let{shape:[s,o],extent:l,lowest:h,span:f}=e.grid,d=new Gi(...l,o-1,s-1),m=d.attributes.position;for(let y=0;y<m.count;y++){let g=s-1-Math.floor(y/o);m.setZ(y,h+f*e.heights[g*o+y%o])}vf(d,this.scale),d.computeVertexNormals(),this.ground.add(Object.assign(new zt(d,this.floor),{receiveShadow:!0,castShadow:!1})),this.plane.position.z=h-.01*this.scale}this.world.add(this.ground)}setSlope(e){this.world.rotation.y=-e}setRobots(e,t){for(let n of this.robots)n.group.removeFromParent();this.robots=e.map((n,s)=>new Sh(n,t[s]));for(let n of this.robots)this.world.add(n.group)}record(){for(let e of this.robots)e.record()}draw(e,t){for(let f of this.robots)f.place(e);let[n,s,o]=this.robots[0].position(e),l=this.world.localToWorld(new j(n,s,o));if(this.follow){let f=l.clone().sub(this.target);f.z*=Math.min(1,4*t),this.target.add(f),this.camera.position.add(f)}this.orbit.target.copy(this.target),this.orbit.update(),this.light.target.position.copy(l),this.light.position.copy(l).add(new j(.5,.9,2.2).multiplyScalar(this.scale));let h=2*yf*this.scale;this.plane.position.setX(h*Math.round(n/h)).setY(h*Math.round(s/h)),this.arrow.visible&&(this.arrow.left-=t)<0&&(this.arrow.visible=!1),this.renderer.render(this.scene,this.camera)}showPush(e,t){let{scale:n}=this,[s,o,l]=this.robots[e].position(1),h=new j(...t).normalize();this.arrow.position.set(s,o,l).addScaledVector(h,-.5*n),this.arrow.setDirection(h),Object.assign(this.arrow,{visible:!0,left:.5})}pick(e,t){let n=new Xs,{width:s,height:o}=this.canvas.getBoundingClientRect();n.setFromCamera(new et(2*e/s-1,1-2*t/o),this.camera);let[l]=n.intersectObjects(this.robots.map(d=>d.group));if(!l)return null;let h=this.robots.findIndex(d=>d.meshes.includes(l.object)),f=n.ray.direction.clone().applyQuaternion(this.world.quaternion.clone().invert()).setZ(0).normalize();return{index:h,direction:f.toArray()}}},Sh=class{constructor(e,t){this.simulation=e,this.group=new kn,this.meshes=[];let{model:n}=e;this.bodies=Array.from({length:n.nbody},()=>this.group.add(new kn).children.at(-1));for(let s=0;s<n.ngeom;s++){let o=n.geom_bodyid[s],l=o&&n.geom_group[s]<Yb?jb(n,s):null;if(!l)continue;let h=new zt(l,Jb(n,s,t));h.position.fromArray(n.geom_pos,3*s),h.quaternion.copy(xh(n.geom_quat,s)),h.castShadow=h.receiveShadow=!0,this.bodies[o].add(h),this.meshes.push(h)}this.record(),this.record()}record(){let{xpos:e,xquat:t}=this.simulation.data;this.before=this.now??{xpos:e.slice(),xquat:t.slice()},this.now={xpos:e.slice(),xquat:t.slice()}}place(e){this.bodies.forEach((t,n)=>{t.position.fromArray(this.before.xpos,3*n).lerp(new j().fromArray(this.now.xpos,3*n),e),t.quaternion.copy(xh(this.before.xquat,n)).slerp(xh(this.now.xquat,n),e)})}position(e){let t=3*this.simulation.base;return[0,1,2].map(n=>(1-e)*this.before.xpos[t+n]+e*this.now.xpos[t+n])}},xh=(i,e)=>new Mn(i[4*e+1],i[4*e+2],i[4*e+3],i[4*e]);function jb(i,e){let[t,n,s]=i.geom_size.slice(3*e,3*e+3);switch(i.geom_type[e]){case Vb:return new Wr(t,32,16);case Hb:return new Us(t,2*n,8,24).rotateX(Math.PI/2);case Wb:return new Wr(1,32,16).scale(t,n,s);case Xb:return new Hr(t,t,2*n,32).rotateX(Math.PI/2);case $b:return new hi(2*t,2*n,2*s);case qb:return Zb(i,i.geom_dataid[e]);default:return null}}function Zb(i,e){let{mesh_vert:t,mesh_vertadr:n,mesh_vertnum:s,mesh_face:o,mesh_faceadr:l,mesh_facenum:h}=i,f=new wn,d=n[e],m=l[e];return f.setAttribute("position",new In(t.slice(3*d,3*(d+s[e])),3)),f.setIndex(Array.from(o.slice(3*m,3*(m+h[e])))),f.computeVertexNormals(),f}function Jb(i,e,t){let n=i.geom_matid[e],[s,o,l]=n>=0?i.mat_rgba.slice(4*n,4*n+3):i.geom_rgba.slice(4*e,4*e+3),h=new ht().setRGB(s,o,l,mn);return t&&h.lerp(new ht(t.colour),t.share),new Ai({color:h,roughness:.45,metalness:.1})}function vf(i,e){let{position:t,uv:n}=i.attributes,s=2*yf*e;for(let o=0;o<t.count;o++)n.setXY(o,t.getX(o)/s,t.getY(o)/s)}function Kb(){let i=document.createElement("canvas"),e=256,t=e/2;i.width=i.height=e;let n=i.getContext("2d");for(let[s,o]of zb.entries())n.fillStyle=o,n.fillRect(0,s*t,t,t),n.fillRect(t,(1-s)*t,t,t);return i}var oa=class{constructor({name:e,xml:t,heights:n}){if(Object.assign(this,{name:e,xml:t,grid:n??null,heights:null}),n){let s=new Uint16Array(Uint8Array.from(atob(n.data),o=>o.charCodeAt(0)).buffer);this.heights=Float32Array.from(s,o=>o/65535)}}highest(e,t,n){if(!this.grid)return 0;let{shape:[s,o],extent:l,lowest:h,span:f}=this.grid,d=g=>(g+l[0]/2)/l[0]*(o-1),m=g=>(g+l[1]/2)/l[1]*(s-1),y=-1/0;for(let g=Math.max(0,Math.floor(m(t-n)));g<=Math.min(s-1,Math.ceil(m(t+n)));g++)for(let S=Math.max(0,Math.floor(d(e-n)));S<=Math.min(o-1,Math.ceil(d(e+n)));S++)y=Math.max(y,this.heights[g*o+S]);return y===-1/0?0:h+f*y}};var Mh=2*Math.PI,Qb="gait_swing",la=class{constructor(e,t,n){Object.assign(this,{simulation:e,graph:t,control:n}),this.amplitude=this.frequency=1,this.reset()}reset(e,t=[0,0]){this.simulation.reset(e),this.command=Float64Array.from(t),this.requested=[...t],this.memory={last_action:new Float32Array(this.simulation.play.length),gait_phase:Float32Array.of(0),observation_history:new Float32Array(this.graph.inputs.observation_history?.length??0).fill(NaN)},this.time=0}step(){let{simulation:e,graph:t,memory:n,frequency:s}=this,o=t.run({projected_gravity:e.projectedGravity(),angular_velocity:e.reading("angular_velocity_b"),joint_position:e.reading("joint_position"),joint_velocity:e.reading("joint_velocity"),command:this.command,...n},{[Qb]:this.amplitude});if(o.action&&n.last_action.set(o.action),o.next_observation_history&&n.observation_history.set(o.next_observation_history),o.next_gait_phase){let l=(o.next_gait_phase[0]-n.gait_phase[0]+Mh)%Mh;n.gait_phase[0]=s===1?o.next_gait_phase[0]:(n.gait_phase[0]+s*l)%Mh}e.step(o.joint_target),this.control.command_rate.forEach((l,h)=>{let f=this.requested[h]-this.command[h],d=l*this.control.timestep;this.command[h]=Math.abs(f)<=d?this.requested[h]:this.command[h]+Math.sign(f)*d}),this.time+=this.control.timestep}};var ew=.56,tw=1.5,nw=.3,Dl=class{constructor(e,t){Object.assign(this,{mujoco:e,content:t,scale:t.robot.scale,walkers:[]}),this.terrains=t.terrains.map(n=>new oa(n)),this.settings=this.standard(),this.compare=!1,this.request=[0,0],this.rebuild()}standard(){return{terrain:this.content.terrain,slope:0,friction:null,payload:0,amplitude:1,frequency:1}}get terrain(){return this.terrains.find(({name:e})=>e===this.settings.terrain)}rebuild(){for(let{simulation:o}of this.walkers)o.delete();let{mujoco:e,content:t,terrain:n}=this,s=this.compare&&t.gait?[t.policy,t.gait]:[t.policy];this.walkers=s.map(o=>new la(new ls(e,n,t.robot),new rr(o),t.control)),this.reset()}reset(){this.apply();let{height:e}=this.content.robot;this.walkers.forEach((t,n)=>{let s=this.walkers.length>1?(.5-n)*ew*this.scale:0,o=[...this.content.robot.start];o[1]=s,o[2]=e+this.terrain.highest(0,s,.2*this.scale),t.reset(o),Object.assign(t,{downFor:0,travelled:0,speed:0,rate:0})}),this.time=0}apply(){let{slope:e,friction:t,payload:n,amplitude:s,frequency:o}=this.settings;for(let l of this.walkers)Object.assign(l,{amplitude:s,frequency:o}),l.simulation.setSlope(e),l.simulation.setPayload(n),t!==null&&l.simulation.setFriction(t)}step(){let{timestep:e}=this.content.control;this.time+=e;for(let t of this.walkers){let{simulation:n}=t,[s,o]=n.position();t.requested=[...this.request],t.step();let[l]=n.reading("linear_velocity_b"),h=n.position(),[,,f]=n.reading("angular_velocity_b"),d=e/nw;t.speed+=d*(l-t.speed),t.rate+=d*(f-t.rate),t.travelled+=Math.hypot(h[0]-s,h[1]-o),t.downFor=n.fallen()?t.downFor+e:0,t.downFor>tw&&this.standUp(t)}}standUp(e){let{simulation:t,travelled:n}=e,s=[...this.content.robot.start],[o,l]=t.position(),h=t.yaw();Number.isFinite(o+l+h)&&([s[0],s[1],s[3],s[6]]=[o,l,Math.cos(h/2),Math.sin(h/2)],s[2]=this.content.robot.height+this.terrain.highest(o,l,.2*this.scale)),e.reset(s),Object.assign(e,{downFor:0,travelled:n,speed:0,rate:0})}contacts(e=0){return Array.from(this.walkers[e].simulation.reading("foot_force"),t=>t>this.content.robot.contact)}};function xf(i,e){let{start:t,command:n,steps:s,end:o}=e.reference,l=new oa(e.terrains.find(({heights:m})=>!m)),h=new ls(i,l,e.robot),f=new la(h,new rr(e.policy),e.control);f.reset(t,n);let d=s;return m=>{for(;m>0&&d>0;m--,d--)f.step();if(d)return null;let[y,g]=[h.position(),o].map(([E,R])=>Math.hypot(E,R)),S={seconds:s*e.control.timestep,speed:n[0],here:y,there:g,qpos:[...h.data.qpos]};return h.delete(),{...S,percent:100*Math.abs(y-g)/g}}}var iw=.8,rw=.25,sw=.1,aw=4,ow={colour:13983232,share:.72},bh=class{constructor(e,t){this.walk=new Dl(e,t),Object.assign(this,{language:Ra(),paused:!1,slow:!1,throttle:0,turn:0,checked:null}),this.view=new Il(document.getElementById("view"),this.walk.scale),this.feet=new Ia(document.getElementById("feet"),t.robot.legs,t.control.timestep),this.controls=new Pa(this),this.check=xf(e,t),this.due=0,this.redraw(),this.controls.translate(),this.controls.steer(iw,0)}redraw(){let{walk:e,view:t,feet:n}=this;t.setTerrain(e.terrain),t.setSlope(e.settings.slope),t.setRobots(e.walkers.map(({simulation:s})=>s),[null,ow]),n.clear()}setPaused(e){this.paused=e,this.controls.showPaused(e)}setSlow(e){this.slow=e,this.controls.showSlow(e)}setLanguage(e){this.language=e,this.controls.translate()}set(e){Object.assign(this.walk.settings,e),this.walk.apply(),this.view.setSlope(this.walk.settings.slope)}setTerrain(e){this.walk.settings.terrain=e,this.walk.rebuild(),this.redraw()}setCompare(e){this.walk.compare=e,this.walk.rebuild(),this.redraw()}reset(){this.walk.reset(),this.redraw(),this.view.resetCamera()}push(e,t){for(let n of t)this.walk.walkers[n].simulation.push(e.map(s=>s*this.strength));this.view.showPush(t[0],e)}pushSomewhere(){let e=2*Math.PI*Math.random();this.push([Math.cos(e),Math.sin(e),0],[...this.walk.walkers.keys()])}step(e=1){for(let t=0;t<e;t++)this.walk.step(),this.view.record(),this.feet.record(this.walk.contacts())}frame(e){let{timestep:t}=this.walk.content.control;if(this.controls.pollGamepad(),!this.paused){this.due+=Math.min(e,sw)*(this.slow?rw:1);let n=Math.floor(this.due/t);this.step(n),this.due-=n*t}!this.checked&&(this.checked=this.check(aw))&&this.controls.showCheck(),this.view.draw(this.due/t,e),this.feet.draw(),this.controls.show()}run(){let e=performance.now(),t=n=>{this.frame(Math.max(0,n-e)/1e3),e=n,requestAnimationFrame(t)};requestAnimationFrame(t)}};async function Sf(i){let e=Uint8Array.from(atob(document.getElementById(i).textContent.trim()),t=>t.charCodeAt(0));return new Uint8Array(await new Response(new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer())}var Mf=document.getElementById("message");try{Object.assign(Mf,{hidden:!1,textContent:ri(Ra(),"loading")});let i=JSON.parse(new TextDecoder().decode(await Sf("document"))),e=new bh(await pu(await Sf("wasm")),i);window.quadruped={page:e,Graph:rr,walk:e.walk},e.run()}catch(i){throw Object.assign(Mf,{hidden:!1,textContent:ri(Ra(),"failed",i.message??i)}),i}
