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
var H0={en:"English",zh:"中文"},sc={en:{title:"MiniQuadruped: a robot that learned to walk",tagline:"It learned to walk by trial and error. Drive it, push it, change its world: everything runs in this file.",other_language:"中文",loading:"Loading the physics …",failed:"The page cannot run here: {}",steer:"Steer",steer_hint:"Arrow keys, the stick below, or a gamepad. Forward speed stays, turning springs back.",speed_limit:"Speed limit",stop:"Stop",disturb:"Push",disturb_hint:"Click on the robot: it is pushed away from you.",push_strength:"Strength",push:"Push somewhere",ground:"Ground",terrain:"Terrain",slope:"Slope",friction:"Friction",robot:"Robot",payload:"Payload",amplitude:"Gait amplitude",frequency:"Gait frequency",gait_hint:"They change the scripted gait to which the policy adds.",compare:"Scripted gait beside it",compare_hint:"The orange robot repeats a fixed motion and feels nothing.",follow:"Camera follows",standard:"Reset all settings",pause:"Pause",resume:"Resume",reset:"Reset",slow:"Slow motion",settings:"Settings",close:"Close",speed:"Speed",commanded:"commanded",turning:"Turning",distance:"Distance",feet:"Feet on the ground",fell:"It fell. It stands up again in a moment.",keys:"↑ ↓ speed · ← → turn · 0 stop · space pause · P push · R reset · C scripted gait · M slow motion",engine:"MuJoCo {} (WebAssembly)",checking:"comparing with Python …",check:"{} s at {} m/s: {} m here, {} m in Python with MuJoCo {}. The difference is {} %.",about:"Policy “{}”, MiniQuadruped {}. Physics: MuJoCo (Google DeepMind, Apache-2.0). Drawing: three.js (MIT).",policy:"policy",gait:"scripted gait",learn:"Learn in this tab",learn_hint:"A new robot that only marches on the spot learns here to walk: PPO in JavaScript, with the physics in parallel workers. The robot on the page walks with the newest policy. Push it, and change the reward while it learns.",learn_start:"Learn from zero",learn_pause:"Pause learning",learn_continue:"Go on",learn_again:"Forget it",learn_workers:"{} parallel workers, 64 robots.",learn_starting:"{} workers are starting …",learn_running:"{} workers are learning.",learn_reached:"After {} s of learning it keeps {} m/s.",learn_numbers:"{} s · {} steps · {} steps/s · noise {}",learn_curve_speed:"mean speed of the 64 robots, m/s",learn_curve_reward:"their reward per second",learn_zero:"marching only",learn_speed:"Speed to learn",learn_lift:"Weight of lifting the feet",learn_smooth:"Weight of changes of the action",learn_turn:"Learn slower speeds and turns, too",terrains:{flat:"flat",rough:"rough",hills:"hills",slope:"slopes",steps:"blocks",stairs:"stairs",gaps:"trenches",wave:"waves"}},zh:{title:"MiniQuadruped：学会走路的机器人",tagline:"它通过反复试错学会了走路。驾驶它，推它，改变它的世界：一切都在这个文件里运行。",other_language:"English",loading:"正在加载物理引擎……",failed:"页面无法在此运行：{}",steer:"驾驶",steer_hint:"方向键、下面的摇杆或手柄。前进速度保持不变，松手后停止转向。",speed_limit:"限速",stop:"停止",disturb:"推",disturb_hint:"点击机器人，把它朝远离你的方向推。",push_strength:"力度",push:"随机推一下",ground:"地面",terrain:"地形",slope:"坡度",friction:"摩擦系数",robot:"机器人",payload:"负载",amplitude:"步态幅度",frequency:"步态频率",gait_hint:"它们改变脚本步态，策略在此基础上修正。",compare:"旁边显示脚本步态",compare_hint:"橙色机器人只重复固定的动作，没有任何感知。",follow:"镜头跟随",standard:"恢复全部设置",pause:"暂停",resume:"继续",reset:"重置",slow:"慢动作",settings:"设置",close:"关闭",speed:"速度",commanded:"指令",turning:"转向",distance:"距离",feet:"着地的脚",fell:"它摔倒了，马上会重新站起来。",keys:"↑ ↓ 速度 · ← → 转向 · 0 停止 · 空格 暂停 · P 推 · R 重置 · C 脚本步态 · M 慢动作",engine:"MuJoCo {}（WebAssembly）",checking:"正在与 Python 比较……",check:"以 {1} m/s 走 {0} 秒：这里 {2} m，Python（MuJoCo {4}）{3} m，相差 {5} %。",about:"策略“{}”，MiniQuadruped {}。物理：MuJoCo（Google DeepMind，Apache-2.0）。绘图：three.js（MIT）。",policy:"策略",gait:"脚本步态",learn:"在本页学习",learn_hint:"一个只会原地踏步的新机器人在这里学走路：PPO 用 JavaScript 写成，物理在多个并行线程中运行。页面上的机器人始终用最新的策略行走。学习时可以推它，也可以改变奖励。",learn_start:"从零开始学习",learn_pause:"暂停学习",learn_continue:"继续学习",learn_again:"全部忘掉",learn_workers:"{} 个并行线程，64 个机器人。",learn_starting:"{} 个线程正在启动……",learn_running:"{} 个线程正在学习。",learn_reached:"学习 {} 秒后，它能保持 {} m/s。",learn_numbers:"{} 秒 · {} 步 · {} 步/秒 · 噪声 {}",learn_curve_speed:"64 个机器人的平均速度，m/s",learn_curve_reward:"它们每秒的奖励",learn_zero:"原地踏步",learn_speed:"要学的速度",learn_lift:"抬脚的权重",learn_smooth:"动作变化的权重",learn_turn:"也学较慢的速度和转弯",terrains:{flat:"平地",rough:"崎岖",hills:"丘陵",slope:"斜坡",steps:"方块",stairs:"台阶",gaps:"沟壑",wave:"波浪"}}};function La(i=navigator.languages){return i.map(e=>e.slice(0,2)).find(e=>e in H0)??"en"}function Bn(i,e,...t){let n=0;return sc[i][e].replace(/\{(\d?)\}/g,(r,o)=>t[o===""?n++:Number(o)])}var at=i=>document.getElementById(i),W0=Math.PI/180,ac=.15,Fa=class{constructor(e){Object.assign(this,{page:e,held:new Set,stick:null,gamepad:!1});let{control:t,robot:n,gait:r,policy:o}=e.walk.content,[l,h]=t.forward,{walk:f}=e;this.sliders={limit:[t.key_steps[0],h,h,d=>`${d.toFixed(2)} m/s`,d=>{e.limit=d,this.steer()}],strength:[.1,1.5,.6,d=>`${(d*Math.sqrt(f.scale)).toFixed(2)} m/s`,d=>{e.strength=d*Math.sqrt(f.scale)}],slope:[-12,12,0,d=>`${d.toFixed(0)}°`,d=>e.set({slope:d*W0})],friction:[.1,1.5,n.friction,d=>d.toFixed(2),d=>e.set({friction:d})],payload:[0,n.mass/2,0,d=>`${d.toFixed(n.mass<2?2:1)} kg`,d=>e.set({payload:d})],amplitude:[0,2,1,d=>`${d.toFixed(2)}×`,d=>e.set({amplitude:d})],frequency:[.5,1.5,1,d=>`${d.toFixed(2)}×`,d=>e.set({frequency:d})]};for(let[d,[m,y,g,x,M]]of Object.entries(this.sliders)){let R=at(d),S=R.closest("label").querySelector("output");Object.assign(R,{min:m,max:y,step:d==="slope"?1:(y-m)/100,value:g}),R.addEventListener("input",()=>{S.textContent=x(R.valueAsNumber),M(R.valueAsNumber)}),S.textContent=x(g)}e.limit=h,this.limits={lowest:l,highest:h,turn:t.turn[1]},e.strength=this.sliders.strength[2]*Math.sqrt(f.scale),at("frequency").closest("label").hidden=!("gait_phase"in o.inputs),at("amplitude").closest("label").hidden=!o.nodes.some(([,,d])=>d==="gait_swing"),at("gait").hidden=at("frequency").closest("label").hidden&&at("amplitude").closest("label").hidden,at("beside").hidden=at("beside_hint").hidden=!r;for(let{name:d}of f.terrains)at("terrain").append(new Option(d,d,!1,d===f.settings.terrain));at("terrain").addEventListener("change",()=>e.setTerrain(at("terrain").value));for(let[d,m]of Object.entries({pause:()=>e.setPaused(!e.paused),slow:()=>e.setSlow(!e.slow),reset:()=>e.reset(),stop:()=>this.stop(),push:()=>e.pushSomewhere(),language:()=>e.setLanguage(e.language==="en"?"zh":"en"),standard:()=>this.standard(),open:()=>this.toggle()}))at(d).addEventListener("click",m);at("compare").addEventListener("change",()=>e.setCompare(at("compare").checked)),at("follow").addEventListener("change",()=>{e.view.follow=at("follow").checked}),this.addKeys(),this.addStick(),this.addClicks()}addKeys(){let e={ArrowUp:.2,ArrowDown:-.2},t={ArrowLeft:1,ArrowRight:-1},n={" ":()=>this.page.setPaused(!this.page.paused),r:()=>this.page.reset(),p:()=>this.page.pushSomewhere(),m:()=>this.page.setSlow(!this.page.slow),0:()=>this.stop(),c:()=>{at("beside").hidden||(at("compare").checked=!at("compare").checked,this.page.setCompare(at("compare").checked))}};addEventListener("keydown",r=>{let{key:o,target:l}=r;if(!(r.ctrlKey||r.metaKey||r.altKey||l.matches("select, input[type=range]"))&&!(o===" "&&l.matches("button, input"))){if(o in e)this.steer(Math.round(5*(this.page.throttle+e[o]))/5);else if(o in t)this.held.add(o),this.steer(void 0,this.heldTurn(t));else if(o.toLowerCase()in n)n[o.toLowerCase()]();else return;r.preventDefault()}}),addEventListener("keyup",({key:r})=>{this.held.delete(r)&&this.steer(void 0,this.heldTurn(t))}),addEventListener("blur",()=>{this.held.size&&(this.held.clear(),this.steer(void 0,0))})}heldTurn(e){return[...this.held].reduce((t,n)=>t+e[n],0)}addStick(){let e=at("stick"),t=n=>{let{left:r,top:o,width:l,height:h}=e.getBoundingClientRect(),f=.36,d=((n.clientX-r)/l-.5)/f,m=(.5-(n.clientY-o)/h)/f;this.steer(Math.abs(m)<ac?0:m,Math.abs(d)<ac?0:-d)};e.addEventListener("pointerdown",n=>{e.setPointerCapture(n.pointerId),t(n)}),e.addEventListener("pointermove",n=>{e.hasPointerCapture(n.pointerId)&&t(n)});for(let n of["pointerup","pointercancel"])e.addEventListener(n,()=>this.steer(void 0,0))}pollGamepad(){let e=navigator.getGamepads?.().find(o=>o?.connected);if(!e)return;let[t,n]=e.axes.map(o=>Math.abs(o)<ac?0:o);(t||n||this.gamepad)&&this.steer(-n,-t),this.gamepad=!!(t||n);let r=e.buttons[0]?.pressed;r&&!this.pressed&&this.page.pushSomewhere(),this.pressed=r}steer(e=this.page.throttle,t=this.page.turn){let{page:n}=this,r=d=>Math.min(1,Math.max(-1,d));Object.assign(n,{throttle:r(e),turn:r(t)});let{lowest:o,highest:l,turn:h}=this.limits,f=n.throttle*n.limit;n.walk.request=[Math.min(l,Math.max(o,f)),n.turn*h],at("knob").style.transform=`translate(${-36*n.turn}%, ${-36*n.throttle}%) translate(${-n.turn*30}px, ${-n.throttle*30}px)`}limitTo(e){let{forward:[t,n],turn:[,r]}=this.page.walk.content.control;this.limits=e?{lowest:e[1]?0:e[0],highest:e[0],turn:e[1]}:{lowest:t,highest:n,turn:r},this.steer(e?1:void 0,0)}stop(){this.steer(0,0)}addClicks(){let e=at("view"),t=r=>{let{left:o,top:l}=e.getBoundingClientRect();return[r.clientX-o,r.clientY-l]},n=null;e.addEventListener("pointerdown",r=>{n=t(r)}),e.addEventListener("pointerup",r=>{let[o,l]=t(r);if(n&&Math.hypot(o-n[0],l-n[1])<6){let h=this.page.view.pick(o,l);h&&this.page.push(h.direction,[h.index])}n=null}),e.addEventListener("pointermove",r=>{r.buttons||e.classList.toggle("aim",this.page.view.pick(...t(r))!==null)})}standard(){for(let[e,[,,t,n,r]]of Object.entries(this.sliders))at(e).value=t,at(e).closest("label").querySelector("output").textContent=n(t),r(t);this.page.set({friction:null}),at("terrain").value=this.page.walk.content.terrain,this.page.setTerrain(at("terrain").value)}toggle(e=!at("panel").classList.contains("open")){at("panel").classList.toggle("open",e),at("open").setAttribute("aria-expanded",e),at("open").textContent=e?"✕":"⚙"}translate(){let{language:e,walk:t,paused:n}=this.page,r=(h,...f)=>Bn(e,h,...f);document.documentElement.lang=e==="zh"?"zh-CN":"en",document.title=r("title");for(let h of document.querySelectorAll("[data-text]"))h.textContent=r(h.dataset.text);for(let h of document.querySelectorAll("[data-label]"))h.ariaLabel=h.title=r(h.dataset.label);for(let h of at("terrain").options)h.textContent=sc[e].terrains[h.value]??h.value;let{name:o,versions:l}=t.content;at("engine").textContent=r("engine",t.mujoco.mj_versionString()),at("about").textContent=r("about",o,l.mini_quadruped),this.showPaused(n),this.showCheck(),this.page.learning.translate()}showPaused(e){at("pause").textContent=e?"▶":"❚❚",at("pause").title=at("pause").ariaLabel=Bn(this.page.language,e?"resume":"pause")}showSlow(e){at("slow").setAttribute("aria-pressed",e)}showCheck(){let{page:e}=this,{language:t,checked:n}=e;at("check").textContent=n?Bn(t,"check",n.seconds,n.speed,n.here.toFixed(2),n.there.toFixed(2),e.walk.content.versions.mujoco,n.percent.toFixed(2)):Bn(t,"checking")}tell(e,...t){at("message").hidden=!e,e&&(at("message").textContent=Bn(this.page.language,e,...t))}show(){let{walk:e,language:t}=this.page,[n]=e.walkers,r=l=>l.toFixed(2).replace(/^-(?=0\.00$)/,""),o=l=>`${Bn(t,"commanded")} ${r(l)}`;at("speed").textContent=`${r(n.speed)} m/s`,at("wanted").textContent=o(n.command[0]),at("rate").textContent=`${r(n.rate)} rad/s`,at("wanted_rate").textContent=o(n.command[1]),at("distance").textContent=`${n.travelled.toFixed(1)} m`,at("time").textContent=`${e.time.toFixed(1)} s`,n.downFor>.1?this.tell("fell"):this.tell(null)}};var X0="#57616d",q0="#e3e8ee",Na=class{constructor(e,t,n){Object.assign(this,{canvas:e,legs:t,length:Math.round(2.5/n),history:[]})}clear(){this.history=[]}record(e){this.history.push(e),this.history.length>this.length&&this.history.shift()}draw(){let{canvas:e,legs:t,history:n,length:r}=this,o=devicePixelRatio||1,l=e.clientWidth,h=e.clientHeight;if(!l)return;e.width!==Math.round(l*o)&&([e.width,e.height]=[l*o,h*o].map(Math.round));let f=e.getContext("2d"),d=26,m=h/t.length,y=(l-d)/r;f.setTransform(o,0,0,o,0,0),f.clearRect(0,0,l,h),f.font="11px system-ui, sans-serif",f.textBaseline="middle",t.forEach(({name:g,colour:x},M)=>{let R=M*m+.18*m,S=.64*m,_=r-n.length;f.fillStyle=X0,f.fillText(g.slice(0,3),0,M*m+m/2),f.fillStyle=q0,f.fillRect(d,R,l-d,S),f.fillStyle=x;for(let P=0;P<n.length;P++){if(!n[P][M])continue;let U=P;for(;U+1<n.length&&n[U+1][M];)U++;f.fillRect(d+(_+P)*y,R,(U-P+1)*y,S),P=U}})}};var cs=class{constructor(e){this.sizes=e,this.layers=e.slice(1).map((t,n)=>({inputs:e[n],outputs:t})),this.length=0;for(let t of this.layers)t.start=this.length,this.length+=(t.inputs+1)*t.outputs;this.values=e.map(t=>new Float64Array(t)),this.slopes=e.map(t=>new Float64Array(t))}initialize(e,t,n){for(let{start:r,inputs:o,outputs:l}of this.layers){let h=(l===this.sizes.at(-1)?n:1)/Math.sqrt(o);for(let f=0;f<o*l;f++)e[r+f]=h*t.normal();e.fill(0,r+o*l,r+(o+1)*l)}}forward(e,t,n=0){let r=this.values[0];for(let o=0;o<r.length;o++)r[o]=t[n+o];for(let o=0;o<this.layers.length;o++){let{start:l,inputs:h,outputs:f}=this.layers[o],d=this.values[o],m=this.values[o+1],y=o+1<this.layers.length,g=l+h*f;for(let x=0,M=l;x<f;x++,M+=h){let R=e[g+x];for(let S=0;S<h;S++)R+=e[M+S]*d[S];m[x]=y&&R<0?Math.exp(R)-1:R}}return this.values.at(-1)}backward(e,t,n){this.slopes.at(-1).set(n);for(let r=this.layers.length-1;r>=0;r--){let{start:o,inputs:l,outputs:h}=this.layers[r],f=this.values[r],d=this.slopes[r],m=this.values[r+1],y=this.slopes[r+1],g=o+l*h,x=r+1<this.layers.length;r>0&&d.fill(0);for(let M=0,R=o;M<h;M++,R+=l){let S=x&&m[M]<0?y[M]*(m[M]+1):y[M];if(t[g+M]+=S,r>0)for(let _=0;_<l;_++)t[R+_]+=S*f[_],d[_]+=S*e[R+_];else for(let _=0;_<l;_++)t[R+_]+=S*f[_]}}}};var Su=.2;var Mu=[-1,-2.2,4e5];var Ua=class i{constructor(e,t,n=[64,64]){Object.assign(this,{observations:e,actions:t,logStd:Mu[0]}),this.actor=new cs([e,...n,t]),this.critic=new cs([e,...n,1]),this.length=this.actor.length+this.critic.length,this.parameters=new Float32Array(this.length),this.actorParameters=this.parameters.subarray(0,this.actor.length),this.criticParameters=this.parameters.subarray(this.actor.length)}static of(e){return new i(e.observation.length,e.out.action.length)}initialize(e){this.actor.initialize(this.actorParameters,e,.01),this.critic.initialize(this.criticParameters,e,1)}setNoise(e){let[t,n,r]=Mu;this.logStd=t+(n-t)*Math.min(1,e/r)}mean(e,t){return this.actor.forward(this.actorParameters,e,t)}value(e,t){return this.critic.forward(this.criticParameters,e,t)[0]}logDensity(e,t,n){let r=Math.exp(-2*this.logStd),o=0;for(let l=0;l<this.actions;l++)o-=.5*r*(t[n+l]-e[l])**2;return o-this.actions*this.logStd}addGradient(e,t,n){let{actor:r,critic:o,actions:l,observations:h,length:f}=this,d=Math.exp(-2*this.logStd),m=e.subarray(0,r.length),y=e.subarray(r.length,f),g=new Float64Array(l),x=new Float64Array(1);for(let M of n){let R=t.advantages[M],S=this.mean(t.observations,M*h),_=this.logDensity(S,t.actions,M*l)-t.logDensities[M],P=Math.exp(_);if(R>0?P<1+Su:P>1-Su){for(let U=0;U<l;U++)g[U]=-P*R*d*(t.actions[M*l+U]-S[U]);r.backward(this.actorParameters,m,g)}x[0]=this.value(t.observations,M*h)-t.returns[M],o.backward(this.criticParameters,y,x),e[f]+=P-1-_}e[f+1]+=n.length}};var $0=2*Math.PI,Oa=class{constructor(e){Object.assign(this,{learning:e,inputs:{}}),this.act=null,this.observation=new Float32Array(e.observations.reduce((t,{width:n})=>t+n,0)),this.out={action:new Float32Array(e.stance.length),joint_target:new Float32Array(e.stance.length),next_gait_phase:new Float32Array(1)}}observe(e){let{observations:t,stance:n}=this.learning,r=e.gait_phase[0],o=0;for(let{name:l,width:h,scale:f,low:d,high:m}of t){let y=l==="gait_clock"?[Math.sin(r),Math.cos(r)]:e[l];for(let g=0;g<h;g++){let x=(l==="joint_position"?y[g]-n[g]:y[g])*(f[g]??f);this.observation[o++]=Math.min(m,Math.max(d,x))}}return this.observation}run(e){let{phases:t,sine:n,cosine:r,offset:o,low:l,high:h,scale:f,phase_step:d}=this.learning,{action:m,joint_target:y,next_gait_phase:g}=this.out,x=this.act(this.observe(e));g[0]=(e.gait_phase[0]+d)%$0;for(let M=0;M<y.length;M++){m[M]=Math.min(1,Math.max(-1,x[M]));let R=g[0]+t[M],S=o[M]+n[M]*Math.sin(R)+r[M]*Math.cos(R)+f*m[M];y[M]=Math.min(h[M],Math.max(l[M],S))}return this.out}};var hs=(i=navigator.hardwareConcurrency??2)=>Math.max(1,Math.min(8,i-1)),Ba=class{constructor(e,t,{terrains:n,robot:r,control:o,learning:l},h,f,d=hs()){Object.assign(this,{settings:h,paused:!1});let m=URL.createObjectURL(new Blob([e],{type:"text/javascript"}));this.workers=Array.from({length:d},()=>new Worker(m));let y=this.workers.map(()=>Array(d).fill(null));for(let x=0;x<d;x++)for(let M=0;M<x;M++){let{port1:R,port2:S}=new MessageChannel;[y[x][M],y[M][x]]=[R,S]}let g=n.filter(({heights:x})=>!x).slice(0,1);this.workers.forEach((x,M)=>{x.onmessage=({data:S})=>f(S),x.onerror=({message:S})=>f({error:S});let R={terrains:g,robot:r,control:o,learning:l};x.postMessage({wasm:t,content:R,settings:h,ports:y[M]},y[M].filter(Boolean))})}set(e){Object.assign(this.settings,e),this.send()}setPaused(e){this.paused=e,this.send()}send(){for(let e of this.workers)e.postMessage({settings:this.settings,paused:this.paused})}stop(){for(let e of this.workers)e.terminate()}};var fn=i=>document.getElementById(i),oc={seconds:4,tolerance:.05},Y0=.6,us={speed:"#0072b2",reward:"#009e73",zero:"#8a94a0",text:"#57616d"},ka=class{constructor(e,t,n){let{learning:r}=e.walk.content;if(Object.assign(this,{page:e,source:t,wasm:n,school:null,policy:null}),fn("learn").hidden=!r,!r)return;this.policy=new Oa(r),this.agent=Ua.of(this.policy),this.policy.act=d=>this.agent.mean(d),this.clear();let{unit:o,command:l,weights:h}=r,[,f]=e.walk.content.control.forward;this.sliders={learn_speed:[.2*f,f,l[0],d=>`${d.toFixed(2)} m/s`],learn_lift:[0,3,1,d=>`${(d*h.gait_clock).toFixed(0)}`],learn_smooth:[0,10,1,d=>`${(d*h.action_rate).toFixed(1)}`]};for(let[d,[m,y,g,x]]of Object.entries(this.sliders)){let M=fn(d),R=M.closest("label").querySelector("output");Object.assign(M,{min:m,max:y,step:(y-m)/20,value:g}),R.textContent=x(g),M.addEventListener("input",()=>{R.textContent=x(M.valueAsNumber),this.change()})}fn("learn_turn").addEventListener("change",()=>this.change()),fn("learn_go").addEventListener("click",()=>this.go()),fn("learn_again").addEventListener("click",()=>this.stop()),this.tolerance=oc.tolerance*o[0]}clear(){Object.assign(this,{results:[],seconds:0,since:null,reached:null,average:0,error:null})}settings(){let{weights:e}=this.policy.learning,{control:t}=this.page.walk.content;return{command:[fn("learn_speed").valueAsNumber,0],turns:fn("learn_turn").checked?Y0*t.turn[1]:null,weights:{...e,gait_clock:e.gait_clock*fn("learn_lift").valueAsNumber,action_rate:e.action_rate*fn("learn_smooth").valueAsNumber}}}change(){let e=this.settings();this.school?.set(e),this.school&&this.page.learned(this.policy,e)}go(){this.school?(this.tick(),this.school.setPaused(!this.school.paused)):(this.clear(),this.agent.parameters.fill(0),this.school=new Ba(this.source,this.wasm,this.page.walk.content,{seed:0,...this.settings()},e=>this.take(e)),this.page.learned(this.policy,this.settings())),this.since=this.school.paused||!this.results.length?null:performance.now(),this.translate()}stop(){this.school?.stop(),this.school=null,this.clear(),this.page.learned(null),this.translate()}take(e){if(e.error)return this.error=e.error,this.school.stop(),this.translate();this.results.length?this.tick():this.since=performance.now(),this.results.push({...e,actor:null,seconds:this.seconds}),this.agent.actorParameters.set(e.actor),this.translate()}tick(){let e=performance.now();this.since!==null&&(this.seconds+=(e-this.since)/1e3),this.since=this.school?.paused?null:e}watch(e,t){if(!this.school||this.reached!==null)return;let n=t/(oc.seconds/4),r=e.command[0];this.average+=n*(e.speed-this.average);let o=Math.abs(this.average-r)<this.tolerance&&Math.abs(e.rate)<2*this.tolerance;this.kept=o&&!e.downFor?(this.kept??0)+t:0,this.kept>oc.seconds&&(this.reached=this.seconds,this.translate())}translate(){let{page:{language:e},school:t,results:n}=this,r=(h,...f)=>Bn(e,h,...f);fn("learn_go").textContent=r(t?t.paused?"learn_continue":"learn_pause":"learn_start"),fn("learn_again").hidden=!t,fn("learn_curve").hidden=fn("learn_numbers").hidden=!n.length;let o=n.at(-1),l=n[0];fn("learn_state").textContent=this.error?r("failed",this.error):t?o?this.reached!==null?r("learn_reached",this.reached.toFixed(0),t.settings.command[0].toFixed(2)):r("learn_running",hs()):r("learn_starting",hs()):r("learn_workers",hs()),o&&(fn("learn_numbers").textContent=r("learn_numbers",this.seconds.toFixed(0),o.steps.toLocaleString(e),(o.steps/Math.max(1,this.seconds)).toFixed(0),o.noise.toFixed(2)),this.draw([{name:r("learn_curve_speed"),values:n.map(({speed:h})=>h),zero:l.speed,goal:t.settings.command[0],colour:us.speed},{name:r("learn_curve_reward"),values:n.map(({reward:h})=>h),zero:l.reward,colour:us.reward}],r("learn_zero")))}draw(e,t){let n=fn("learn_curve"),r=devicePixelRatio||1,o=n.clientWidth,l=n.clientHeight;[n.width,n.height]=[o*r,l*r].map(Math.round);let h=n.getContext("2d"),f=l/e.length,d=34,m=Math.max(60,this.seconds);h.setTransform(r,0,0,r,0,0),h.font="11px system-ui, sans-serif",e.forEach(({name:y,values:g,zero:x,goal:M,colour:R},S)=>{let _=[...g,x,M??x],P=Math.min(0,..._),U=Math.max(..._)*1.1,I=S*f+16,O=(S+1)*f-14,N=X=>d+(o-d-4)*X/m,w=X=>O-(O-I)*(X-P)/(U-P),D=(X,k,Y,Z)=>{h.strokeStyle=h.fillStyle=Z,h.setLineDash(Y),h.beginPath(),h.moveTo(d,w(X)),h.lineTo(o-4,w(X)),h.stroke(),h.fillText(k,0,w(X)+4)};h.lineWidth=1,D(x,x.toFixed(x<1?2:0),[4,3],us.zero),M!==void 0&&D(M,M.toFixed(2),[1,2],R),h.fillStyle=us.zero,h.textAlign="right",h.fillText(t,o-4,w(x)+(S?12:-4)),h.textAlign="left",h.setLineDash([]),h.strokeStyle=h.fillStyle=R,h.lineWidth=2,h.beginPath(),g.forEach((X,k)=>h.lineTo(N(this.results[k].seconds),w(X))),h.stroke(),h.fillText(y,d,S*f+11)}),h.fillStyle=us.text,h.fillText("0 s",d,l-2),h.textAlign="right",h.fillText(`${m.toFixed(0)} s`,o-4,l-2)}};var Li=i=>(e,t)=>{let n=new Float32Array(Math.max(e.length,t.length)),[r,o]=[e.length>1?1:0,t.length>1?1:0];return[n,()=>{for(let l=0;l<n.length;l++)n[l]=i(e[r*l],t[o*l])}]},Sn=i=>e=>{let t=new Float32Array(e.length);return[t,()=>{for(let n=0;n<t.length;n++)t[n]=i(e[n])}]},bu=(i,e,t)=>{let n=i.length,r=e.length/n,o=new Float32Array(r),l=new Float64Array(r);return[o,()=>{t?l.set(t):l.fill(0);for(let h=0,f=0;h<n;h++){let d=i[h];for(let m=0;m<r;m++,f++)l[m]+=d*e[f]}o.set(l)}]},j0=i=>1/(1+Math.exp(-i)),Z0=i=>Math.max(i,0)+Math.log1p(Math.exp(-Math.abs(i))),J0=i=>{let e=1/(1+.3275911*Math.abs(i)),t=e*(.254829592+e*(-.284496736+e*(1.421413741+e*(-1.453152027+e*1.061405429))));return Math.sign(i)*(1-t*Math.exp(-i*i))},wu={Add:Li((i,e)=>i+e),Sub:Li((i,e)=>i-e),Mul:Li((i,e)=>i*e),Div:Li((i,e)=>i/e),Max:Li(Math.max),Min:Li(Math.min),Mod:Li((i,e)=>i%e),Greater:Li((i,e)=>+(i>e)),Abs:Sn(Math.abs),Sign:Sn(Math.sign),Sqrt:Sn(Math.sqrt),Sin:Sn(Math.sin),Cos:Sn(Math.cos),Tanh:Sn(Math.tanh),Erf:Sn(J0),Sigmoid:Sn(j0),Softplus:Sn(Z0),Relu:Sn(i=>Math.max(i,0)),LeakyRelu:Sn(i=>i<0?.01*i:i),Elu:Sn(i=>i<0?Math.expm1(i):i),Selu:Sn(i=>1.0507009873554805*(i<0?1.6732632423543772*Math.expm1(i):i)),Cast:Sn(i=>i),IsNaN:Sn(i=>Number(Number.isNaN(i))),MatMul:bu,Gemm:bu,Concat:(...i)=>{let e=new Float32Array(i.reduce((t,n)=>t+n.length,0));return[e,()=>{let t=0;for(let n of i)e.set(n,t),t+=n.length}]},Where:(i,e,t)=>{let n=new Float32Array(i.length);return[n,()=>{for(let r=0;r<n.length;r++)n[r]=i[r]?e[r]:t[r]}]},Slice:(i,[e],[t])=>{let n=new Float32Array(t-e);return[n,()=>n.set(i.subarray(e,t))]}},Ow=Object.keys(wu);function K0(i){return new Float32Array(Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer)}var Fi=class{constructor({nodes:e,constants:t,inputs:n,outputs:r}){this.inputs=Object.fromEntries(Object.entries(n).map(([o,l])=>[o,new Float32Array(l)])),this.outputs=r,this.values={...this.inputs};for(let[o,l]of Object.entries(t))this.values[o]=K0(l);this.steps=e.map(([o,l,h])=>{let[f,d]=wu[o](...l.map(m=>this.values[m]));return this.values[h]=f,[d,h,f]})}run(e,t={}){for(let[n,r]of Object.entries(this.inputs))r.set(e[n]);for(let[n,r,o]of this.steps)if(n(),t[r]!==void 0)for(let l=0;l<o.length;l++)o[l]*=t[r];return Object.fromEntries(this.outputs.map(n=>[n,this.values[n]]))}};var Q0=(async function(i={}){var e,t=i,n=typeof window=="object",r=typeof WorkerGlobalScope<"u",o=typeof process=="object"&&process.versions?.node&&process.type!="renderer",l=!n&&!o&&!r;if(o){let{createRequire:s}=await import("module");var h=s(import.meta.url)}var f=[],d="./this.program",m=(s,a)=>{throw a},y=import.meta.url,g="";function x(s){return t.locateFile?t.locateFile(s,g):g+s}var M,R;if(o){if(!(typeof process=="object"&&process.versions?.node&&process.type!="renderer"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");var S=process.versions.node,_=S.split(".").slice(0,3);if(_=_[0]*1e4+_[1]*100+_[2].split("-")[0]*1,_<16e4)throw new Error("This emscripten-generated code requires node v16.0.0 (detected v"+S+")");var P=h("fs");y.startsWith("file:")&&(g=h("path").dirname(h("url").fileURLToPath(y))+"/"),R=a=>{a=ne(a)?new URL(a):a;var c=P.readFileSync(a);return G(Buffer.isBuffer(c)),c},M=async(a,c=!0)=>{a=ne(a)?new URL(a):a;var u=P.readFileSync(a,c?void 0:"utf8");return G(c?Buffer.isBuffer(u):typeof u=="string"),u},process.argv.length>1&&(d=process.argv[1].replace(/\\/g,"/")),f=process.argv.slice(2),m=(a,c)=>{throw process.exitCode=a,c}}else if(l){if(typeof process=="object"&&process.versions?.node&&process.type!="renderer"||typeof window=="object"||typeof WorkerGlobalScope<"u")throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)")}else if(n||r){try{g=new URL(".",y).href}catch{}if(!(typeof window=="object"||typeof WorkerGlobalScope<"u"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");r&&(R=s=>{var a=new XMLHttpRequest;return a.open("GET",s,!1),a.responseType="arraybuffer",a.send(null),new Uint8Array(a.response)}),M=async s=>{if(ne(s))return new Promise((c,u)=>{var p=new XMLHttpRequest;p.open("GET",s,!0),p.responseType="arraybuffer",p.onload=()=>{if(p.status==200||p.status==0&&p.response){c(p.response);return}u(p.status)},p.onerror=u,p.send(null)});var a=await fetch(s,{credentials:"same-origin"});if(a.ok)return a.arrayBuffer();throw new Error(a.status+" : "+a.url)}}else throw new Error("environment detection error");var U=console.log.bind(console),I=console.error.bind(console),O="IDBFS is no longer included by default; build with -lidbfs.js",N="PROXYFS is no longer included by default; build with -lproxyfs.js",w="WORKERFS is no longer included by default; build with -lworkerfs.js",D="FETCHFS is no longer included by default; build with -lfetchfs.js",X="ICASEFS is no longer included by default; build with -licasefs.js",k="JSFILEFS is no longer included by default; build with -ljsfilefs.js",Y="OPFS is no longer included by default; build with -lopfs.js",Z="NODEFS is no longer included by default; build with -lnodefs.js";G(!l,"shell environment detected but not enabled at build time.  Add `shell` to `-sENVIRONMENT` to enable.");var ee;typeof WebAssembly!="object"&&I("no native wasm support detected");var z=!1,ie;function G(s,a){s||pe("Assertion failed"+(a?": "+a:""))}var ne=s=>s.startsWith("file://");function Se(){var s=nc();G((s&3)==0),s==0&&(s+=4),qe[s>>2]=34821223,qe[s+4>>2]=2310721022,qe[0]=1668509029}function re(){if(!z){var s=nc();s==0&&(s+=4);var a=qe[s>>2],c=qe[s+4>>2];(a!=34821223||c!=2310721022)&&pe(`Stack overflow! Stack cookie has been overwritten at ${Ot(s)}, expected hex dwords 0x89BACDFE and 0x2135467, but received ${Ot(c)} ${Ot(a)}`),qe[0]!=1668509029&&pe("Runtime error: The application has corrupted its heap memory area (address zero)!")}}class H extends Error{}class ge extends H{}class We extends H{constructor(a){super(a),this.excPtr=a;let c=au(a);this.name=c[0],this.message=c[1]}}var it=!0;function ue(...s){!it&&typeof it<"u"||console.warn(...s)}(()=>{var s=new Int16Array(1),a=new Int8Array(s.buffer);if(s[0]=25459,a[0]!==115||a[1]!==99)throw"Runtime error: expected the system to be little-endian! (Run with -sSUPPORT_BIG_ENDIAN to bypass)"})();function Fe(s){Object.getOwnPropertyDescriptor(t,s)||Object.defineProperty(t,s,{configurable:!0,set(){pe(`Attempt to set \`Module.${s}\` after it has already been processed.  This can happen, for example, when code is injected via '--post-js' rather than '--pre-js'`)}})}function Pe(s){return()=>G(!1,`call to '${s}' via reference taken before Wasm module initialization`)}function je(s){Object.getOwnPropertyDescriptor(t,s)&&pe(`\`Module.${s}\` was supplied but \`${s}\` not included in INCOMING_MODULE_JS_API`)}function Ue(s){return s==="FS_createPath"||s==="FS_createDataFile"||s==="FS_createPreloadedFile"||s==="FS_unlink"||s==="addRunDependency"||s==="FS_createLazyFile"||s==="FS_createDevice"||s==="removeRunDependency"}function ot(s,a){typeof globalThis<"u"&&!Object.getOwnPropertyDescriptor(globalThis,s)&&Object.defineProperty(globalThis,s,{configurable:!0,get(){a()}})}function Vt(s,a){ot(s,()=>{Qn(`\`${s}\` is not longer defined by emscripten. ${a}`)})}Vt("buffer","Please use HEAP8.buffer or wasmMemory.buffer"),Vt("asm","Please use wasmExports instead");function Ke(s){ot(s,()=>{var a=`\`${s}\` is a library symbol and not included by default; add it to your library.js __deps or to DEFAULT_LIBRARY_FUNCS_TO_INCLUDE on the command line`,c=s;c.startsWith("_")||(c="$"+s),a+=` (e.g. -sDEFAULT_LIBRARY_FUNCS_TO_INCLUDE='${c}')`,Ue(s)&&(a+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),Qn(a)}),Et(s)}function Et(s){Object.getOwnPropertyDescriptor(t,s)||Object.defineProperty(t,s,{configurable:!0,get(){var a=`'${s}' was not exported. add it to EXPORTED_RUNTIME_METHODS (see the Emscripten FAQ)`;Ue(s)&&(a+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),pe(a)}})}var Ct,mt,Ht,pt,It,Mt,rn,De,qe,hn,sn,W,yn,Rt=!1;function Ut(){var s=Ht.buffer;pt=new Int8Array(s),Mt=new Int16Array(s),It=new Uint8Array(s),rn=new Uint16Array(s),De=new Int32Array(s),qe=new Uint32Array(s),hn=new Float32Array(s),sn=new Float64Array(s),W=new BigInt64Array(s),yn=new BigUint64Array(s)}G(typeof Int32Array<"u"&&typeof Float64Array<"u"&&Int32Array.prototype.subarray!=null&&Int32Array.prototype.set!=null,"JS engine does not provide full typed array support");function Le(){if(t.preRun)for(typeof t.preRun=="function"&&(t.preRun=[t.preRun]);t.preRun.length;)dt(t.preRun.shift());Fe("preRun"),Xe($e)}function qt(){G(!Rt),Rt=!0,re(),!t.noFSInit&&!b.initialized&&b.init(),lt.init(),rr.__wasm_call_ctors(),b.ignorePermissions=!1}function Ze(){if(re(),t.postRun)for(typeof t.postRun=="function"&&(t.postRun=[t.postRun]);t.postRun.length;)we(t.postRun.shift());Fe("postRun"),Xe(ut)}var Je=0,L=null,T={},J=null;function ve(s){Je++,t.monitorRunDependencies?.(Je),s?(G(!T[s]),T[s]=1,J===null&&typeof setInterval<"u"&&(J=setInterval(()=>{if(z){clearInterval(J),J=null;return}var a=!1;for(var c in T)a||(a=!0,I("still waiting on run dependencies:")),I(`dependency: ${c}`);a&&I("(end of list)")},1e4))):I("warning: run dependency added without ID")}function de(s){if(Je--,t.monitorRunDependencies?.(Je),s?(G(T[s]),delete T[s]):I("warning: run dependency removed without ID"),Je==0&&(J!==null&&(clearInterval(J),J=null),L)){var a=L;L=null,a()}}function pe(s){t.onAbort?.(s),s="Aborted("+s+")",I(s),z=!0;var a=new WebAssembly.RuntimeError(s);throw mt?.(a),a}function Me(s,a){return(...c)=>{G(Rt,`native function \`${s}\` called before runtime initialization`);var u=rr[s];return G(u,`exported native function \`${s}\` not found`),G(c.length<=a,`native function \`${s}\` called with ${c.length} args but expects ${a}`),u(...c)}}var ae;function le(){return t.locateFile?x("mujoco.wasm"):new URL("mujoco.wasm",import.meta.url).href}function Ce(s){if(s==ae&&ee)return new Uint8Array(ee);if(R)return R(s);throw"both async and sync fetching of the wasm failed"}async function B(s){if(!ee)try{var a=await M(s);return new Uint8Array(a)}catch{}return Ce(s)}async function he(s,a){try{var c=await B(s),u=await WebAssembly.instantiate(c,a);return u}catch(p){I(`failed to asynchronously prepare wasm: ${p}`),ne(ae)&&I(`warning: Loading from a file URI (${ae}) is not supported in most browsers. See https://emscripten.org/docs/getting_started/FAQ.html#how-do-i-run-a-local-webserver-for-testing-why-does-my-program-stall-in-downloading-or-preparing`),pe(p)}}async function se(s,a,c){if(!s&&typeof WebAssembly.instantiateStreaming=="function"&&!ne(a)&&!o)try{var u=fetch(a,{credentials:"same-origin"}),p=await WebAssembly.instantiateStreaming(u,c);return p}catch(v){I(`wasm streaming compile failed: ${v}`),I("falling back to ArrayBuffer instantiation")}return he(a,c)}function Re(){return{env:vu,wasi_snapshot_preview1:vu}}async function Ee(){function s(E,A){return rr=E.exports,Ht=rr.memory,G(Ht,"memory not found in wasm exports"),Ut(),wa=rr.__indirect_function_table,G(wa,"table not found in wasm exports"),Xm(rr),de("wasm-instantiate"),rr}ve("wasm-instantiate");var a=t;function c(E){return G(t===a,"the Module object should not be replaced during async compilation - perhaps the order of HTML elements is wrong?"),a=null,s(E.instance)}var u=Re();if(t.instantiateWasm)return new Promise((E,A)=>{try{t.instantiateWasm(u,(F,q)=>{E(s(F,q))})}catch(F){I(`Module.instantiateWasm callback failed with error: ${F}`),A(F)}});ae??=le();var p=await se(ee,ae,u),v=c(p);return v}class Ae{name="ExitStatus";constructor(a){this.message=`Program terminated with exit(${a})`,this.status=a}}var Xe=s=>{for(;s.length>0;)s.shift()(t)},ut=[],we=s=>ut.push(s),$e=[],dt=s=>$e.push(s);function Oe(s,a="i8"){switch(a.endsWith("*")&&(a="*"),a){case"i1":return pt[s];case"i8":return pt[s];case"i16":return Mt[s>>1];case"i32":return De[s>>2];case"i64":return W[s>>3];case"float":return hn[s>>2];case"double":return sn[s>>3];case"*":return qe[s>>2];default:pe(`invalid type for getValue: ${a}`)}}var Tt=!0,Ot=s=>(G(typeof s=="number"),s>>>=0,"0x"+s.toString(16).padStart(8,"0"));function _i(s,a,c="i8"){switch(c.endsWith("*")&&(c="*"),c){case"i1":pt[s]=a;break;case"i8":pt[s]=a;break;case"i16":Mt[s>>1]=a;break;case"i32":De[s>>2]=a;break;case"i64":W[s>>3]=BigInt(a);break;case"float":hn[s>>2]=a;break;case"double":sn[s>>3]=a;break;case"*":qe[s>>2]=a;break;default:pe(`invalid type for setValue: ${c}`)}}var ye=s=>du(s),_e=()=>pu(),Qn=s=>{Qn.shown||={},Qn.shown[s]||(Qn.shown[s]=1,o&&(s="warning: "+s),I(s))},is=typeof TextDecoder<"u"?new TextDecoder:void 0,vi=(s,a=0,c=NaN)=>{for(var u=a+c,p=a;s[p]&&!(p>=u);)++p;if(p-a>16&&s.buffer&&is)return is.decode(s.subarray(a,p));for(var v="";a<p;){var E=s[a++];if(!(E&128)){v+=String.fromCharCode(E);continue}var A=s[a++]&63;if((E&224)==192){v+=String.fromCharCode((E&31)<<6|A);continue}var F=s[a++]&63;if((E&240)==224?E=(E&15)<<12|A<<6|F:((E&248)!=240&&Qn("Invalid UTF-8 leading byte "+Ot(E)+" encountered when deserializing a UTF-8 string in wasm memory to a JS string!"),E=(E&7)<<18|A<<12|F<<6|s[a++]&63),E<65536)v+=String.fromCharCode(E);else{var q=E-65536;v+=String.fromCharCode(55296|q>>10,56320|q&1023)}}return v},un=(s,a)=>(G(typeof s=="number",`UTF8ToString expects a number (got ${typeof s})`),s?vi(It,s,a):""),rs=(s,a,c,u)=>pe(`Assertion failed: ${un(s)}, at: `+[a?un(a):"unknown filename",c,u?un(u):"unknown function"]),Nn=[],Ji=0,_r=s=>{var a=new vr(s);return a.get_caught()||(a.set_caught(!0),Ji--),a.set_rethrown(!1),Nn.push(a),Da(s),_u(s)},fa=()=>{if(!Nn.length)return 0;var s=Nn[Nn.length-1];return Da(s.excPtr),s.excPtr},Un=0,Ki=()=>{xe(0,0),G(Nn.length>0);var s=Nn.pop();ic(s.excPtr),Un=0};class vr{constructor(a){this.excPtr=a,this.ptr=a-24}set_type(a){qe[this.ptr+4>>2]=a}get_type(){return qe[this.ptr+4>>2]}set_destructor(a){qe[this.ptr+8>>2]=a}get_destructor(){return qe[this.ptr+8>>2]}set_caught(a){a=a?1:0,pt[this.ptr+12]=a}get_caught(){return pt[this.ptr+12]!=0}set_rethrown(a){a=a?1:0,pt[this.ptr+13]=a}get_rethrown(){return pt[this.ptr+13]!=0}init(a,c){this.set_adjusted_ptr(0),this.set_type(a),this.set_destructor(c)}set_adjusted_ptr(a){qe[this.ptr+16>>2]=a}get_adjusted_ptr(){return qe[this.ptr+16>>2]}}var Qi=s=>hu(s),yr=s=>{var a=Un?.excPtr;if(!a)return Qi(0),0;var c=new vr(a);c.set_adjusted_ptr(a);var u=c.get_type();if(!u)return Qi(0),a;for(var p of s){if(p===0||p===u)break;var v=c.ptr+16;if(gu(p,u,v))return Qi(p),a}return Qi(u),a},Gl=()=>yr([]),Vl=s=>yr([s]),Hl=(s,a)=>yr([s,a]),ss=()=>{var s=Nn.pop();s||pe("no exception to throw");var a=s.excPtr;throw s.get_rethrown()||(Nn.push(s),s.set_rethrown(!0),s.set_caught(!1),Ji++),Un=new We(a),Un},C=s=>{if(s){var a=new vr(s);Nn.push(a),a.set_rethrown(!0),ss()}},V=(s,a,c)=>{var u=new vr(s);throw u.init(a,c),Un=new We(s),Ji++,Un},te=()=>Ji,K=s=>{throw Un||(Un=new We(s)),Un},$={isAbs:s=>s.charAt(0)==="/",splitPath:s=>{var a=/^(\/?|)([\s\S]*?)((?:\.{1,2}|[^\/]+?|)(\.[^.\/]*|))(?:[\/]*)$/;return a.exec(s).slice(1)},normalizeArray:(s,a)=>{for(var c=0,u=s.length-1;u>=0;u--){var p=s[u];p==="."?s.splice(u,1):p===".."?(s.splice(u,1),c++):c&&(s.splice(u,1),c--)}if(a)for(;c;c--)s.unshift("..");return s},normalize:s=>{var a=$.isAbs(s),c=s.slice(-1)==="/";return s=$.normalizeArray(s.split("/").filter(u=>!!u),!a).join("/"),!s&&!a&&(s="."),s&&c&&(s+="/"),(a?"/":"")+s},dirname:s=>{var a=$.splitPath(s),c=a[0],u=a[1];return!c&&!u?".":(u&&(u=u.slice(0,-1)),c+u)},basename:s=>s&&s.match(/([^\/]+|\/)\/*$/)[1],join:(...s)=>$.normalize(s.join("/")),join2:(s,a)=>$.normalize(s+"/"+a)},Ie=()=>{if(o){var s=h("crypto");return a=>s.randomFillSync(a)}return a=>crypto.getRandomValues(a)},ze=s=>{(ze=Ie())(s)},Te={resolve:(...s)=>{for(var a="",c=!1,u=s.length-1;u>=-1&&!c;u--){var p=u>=0?s[u]:b.cwd();if(typeof p!="string")throw new TypeError("Arguments to path.resolve must be strings");if(!p)return"";a=p+"/"+a,c=$.isAbs(p)}return a=$.normalizeArray(a.split("/").filter(v=>!!v),!c).join("/"),(c?"/":"")+a||"."},relative:(s,a)=>{s=Te.resolve(s).slice(1),a=Te.resolve(a).slice(1);function c(q){for(var Q=0;Q<q.length&&q[Q]==="";Q++);for(var oe=q.length-1;oe>=0&&q[oe]==="";oe--);return Q>oe?[]:q.slice(Q,oe-Q+1)}for(var u=c(s.split("/")),p=c(a.split("/")),v=Math.min(u.length,p.length),E=v,A=0;A<v;A++)if(u[A]!==p[A]){E=A;break}for(var F=[],A=E;A<u.length;A++)F.push("..");return F=F.concat(p.slice(E)),F.join("/")}},Ne=[],Ge=s=>{for(var a=0,c=0;c<s.length;++c){var u=s.charCodeAt(c);u<=127?a++:u<=2047?a+=2:u>=55296&&u<=57343?(a+=4,++c):a+=3}return a},rt=(s,a,c,u)=>{if(G(typeof s=="string",`stringToUTF8Array expects a string (got ${typeof s})`),!(u>0))return 0;for(var p=c,v=c+u-1,E=0;E<s.length;++E){var A=s.codePointAt(E);if(A<=127){if(c>=v)break;a[c++]=A}else if(A<=2047){if(c+1>=v)break;a[c++]=192|A>>6,a[c++]=128|A&63}else if(A<=65535){if(c+2>=v)break;a[c++]=224|A>>12,a[c++]=128|A>>6&63,a[c++]=128|A&63}else{if(c+3>=v)break;A>1114111&&Qn("Invalid Unicode code point "+Ot(A)+" encountered when serializing a JS string to a UTF-8 string in wasm memory! (Valid unicode code points should be in range 0-0x10FFFF)."),a[c++]=240|A>>18,a[c++]=128|A>>12&63,a[c++]=128|A>>6&63,a[c++]=128|A&63,E++}}return a[c]=0,c-p},gt=(s,a,c)=>{var u=c>0?c:Ge(s)+1,p=new Array(u),v=rt(s,p,0,p.length);return a&&(p.length=v),p},Ve=()=>{if(!Ne.length){var s=null;if(o){var a=256,c=Buffer.alloc(a),u=0,p=process.stdin.fd;try{u=P.readSync(p,c,0,a)}catch(v){if(v.toString().includes("EOF"))u=0;else throw v}u>0&&(s=c.slice(0,u).toString("utf-8"))}else typeof window<"u"&&typeof window.prompt=="function"&&(s=window.prompt("Input: "),s!==null&&(s+=`
`));if(!s)return null;Ne=gt(s,!0)}return Ne.shift()},lt={ttys:[],init(){},shutdown(){},register(s,a){lt.ttys[s]={input:[],output:[],ops:a},b.registerDevice(s,lt.stream_ops)},stream_ops:{open(s){var a=lt.ttys[s.node.rdev];if(!a)throw new b.ErrnoError(43);s.tty=a,s.seekable=!1},close(s){s.tty.ops.fsync(s.tty)},fsync(s){s.tty.ops.fsync(s.tty)},read(s,a,c,u,p){if(!s.tty||!s.tty.ops.get_char)throw new b.ErrnoError(60);for(var v=0,E=0;E<u;E++){var A;try{A=s.tty.ops.get_char(s.tty)}catch{throw new b.ErrnoError(29)}if(A===void 0&&v===0)throw new b.ErrnoError(6);if(A==null)break;v++,a[c+E]=A}return v&&(s.node.atime=Date.now()),v},write(s,a,c,u,p){if(!s.tty||!s.tty.ops.put_char)throw new b.ErrnoError(60);try{for(var v=0;v<u;v++)s.tty.ops.put_char(s.tty,a[c+v])}catch{throw new b.ErrnoError(29)}return u&&(s.node.mtime=s.node.ctime=Date.now()),v}},default_tty_ops:{get_char(s){return Ve()},put_char(s,a){a===null||a===10?(U(vi(s.output)),s.output=[]):a!=0&&s.output.push(a)},fsync(s){s.output?.length>0&&(U(vi(s.output)),s.output=[])},ioctl_tcgets(s){return{c_iflag:25856,c_oflag:5,c_cflag:191,c_lflag:35387,c_cc:[3,28,127,21,4,0,1,0,17,19,26,0,18,15,23,22,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}},ioctl_tcsets(s,a,c){return 0},ioctl_tiocgwinsz(s){return[24,80]}},default_tty1_ops:{put_char(s,a){a===null||a===10?(I(vi(s.output)),s.output=[]):a!=0&&s.output.push(a)},fsync(s){s.output?.length>0&&(I(vi(s.output)),s.output=[])}}},Wt=s=>{pe("internal error: mmapAlloc called but `emscripten_builtin_memalign` native symbol not exported")},ke={ops_table:null,mount(s){return ke.createNode(null,"/",16895,0)},createNode(s,a,c,u){if(b.isBlkdev(c)||b.isFIFO(c))throw new b.ErrnoError(63);ke.ops_table||={dir:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,lookup:ke.node_ops.lookup,mknod:ke.node_ops.mknod,rename:ke.node_ops.rename,unlink:ke.node_ops.unlink,rmdir:ke.node_ops.rmdir,readdir:ke.node_ops.readdir,symlink:ke.node_ops.symlink},stream:{llseek:ke.stream_ops.llseek}},file:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:{llseek:ke.stream_ops.llseek,read:ke.stream_ops.read,write:ke.stream_ops.write,mmap:ke.stream_ops.mmap,msync:ke.stream_ops.msync}},link:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,readlink:ke.node_ops.readlink},stream:{}},chrdev:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:b.chrdev_stream_ops}};var p=b.createNode(s,a,c,u);return b.isDir(p.mode)?(p.node_ops=ke.ops_table.dir.node,p.stream_ops=ke.ops_table.dir.stream,p.contents={}):b.isFile(p.mode)?(p.node_ops=ke.ops_table.file.node,p.stream_ops=ke.ops_table.file.stream,p.usedBytes=0,p.contents=null):b.isLink(p.mode)?(p.node_ops=ke.ops_table.link.node,p.stream_ops=ke.ops_table.link.stream):b.isChrdev(p.mode)&&(p.node_ops=ke.ops_table.chrdev.node,p.stream_ops=ke.ops_table.chrdev.stream),p.atime=p.mtime=p.ctime=Date.now(),s&&(s.contents[a]=p,s.atime=s.mtime=s.ctime=p.atime),p},getFileDataAsTypedArray(s){return s.contents?s.contents.subarray?s.contents.subarray(0,s.usedBytes):new Uint8Array(s.contents):new Uint8Array(0)},expandFileStorage(s,a){var c=s.contents?s.contents.length:0;if(!(c>=a)){var u=1024*1024;a=Math.max(a,c*(c<u?2:1.125)>>>0),c!=0&&(a=Math.max(a,256));var p=s.contents;s.contents=new Uint8Array(a),s.usedBytes>0&&s.contents.set(p.subarray(0,s.usedBytes),0)}},resizeFileStorage(s,a){if(s.usedBytes!=a)if(a==0)s.contents=null,s.usedBytes=0;else{var c=s.contents;s.contents=new Uint8Array(a),c&&s.contents.set(c.subarray(0,Math.min(a,s.usedBytes))),s.usedBytes=a}},node_ops:{getattr(s){var a={};return a.dev=b.isChrdev(s.mode)?s.id:1,a.ino=s.id,a.mode=s.mode,a.nlink=1,a.uid=0,a.gid=0,a.rdev=s.rdev,b.isDir(s.mode)?a.size=4096:b.isFile(s.mode)?a.size=s.usedBytes:b.isLink(s.mode)?a.size=s.link.length:a.size=0,a.atime=new Date(s.atime),a.mtime=new Date(s.mtime),a.ctime=new Date(s.ctime),a.blksize=4096,a.blocks=Math.ceil(a.size/a.blksize),a},setattr(s,a){for(let c of["mode","atime","mtime","ctime"])a[c]!=null&&(s[c]=a[c]);a.size!==void 0&&ke.resizeFileStorage(s,a.size)},lookup(s,a){throw new b.ErrnoError(44)},mknod(s,a,c,u){return ke.createNode(s,a,c,u)},rename(s,a,c){var u;try{u=b.lookupNode(a,c)}catch{}if(u){if(b.isDir(s.mode))for(var p in u.contents)throw new b.ErrnoError(55);b.hashRemoveNode(u)}delete s.parent.contents[s.name],a.contents[c]=s,s.name=c,a.ctime=a.mtime=s.parent.ctime=s.parent.mtime=Date.now()},unlink(s,a){delete s.contents[a],s.ctime=s.mtime=Date.now()},rmdir(s,a){var c=b.lookupNode(s,a);for(var u in c.contents)throw new b.ErrnoError(55);delete s.contents[a],s.ctime=s.mtime=Date.now()},readdir(s){return[".","..",...Object.keys(s.contents)]},symlink(s,a,c){var u=ke.createNode(s,a,41471,0);return u.link=c,u},readlink(s){if(!b.isLink(s.mode))throw new b.ErrnoError(28);return s.link}},stream_ops:{read(s,a,c,u,p){var v=s.node.contents;if(p>=s.node.usedBytes)return 0;var E=Math.min(s.node.usedBytes-p,u);if(G(E>=0),E>8&&v.subarray)a.set(v.subarray(p,p+E),c);else for(var A=0;A<E;A++)a[c+A]=v[p+A];return E},write(s,a,c,u,p,v){if(G(!(a instanceof ArrayBuffer)),a.buffer===pt.buffer&&(v=!1),!u)return 0;var E=s.node;if(E.mtime=E.ctime=Date.now(),a.subarray&&(!E.contents||E.contents.subarray)){if(v)return G(p===0,"canOwn must imply no weird position inside the file"),E.contents=a.subarray(c,c+u),E.usedBytes=u,u;if(E.usedBytes===0&&p===0)return E.contents=a.slice(c,c+u),E.usedBytes=u,u;if(p+u<=E.usedBytes)return E.contents.set(a.subarray(c,c+u),p),u}if(ke.expandFileStorage(E,p+u),E.contents.subarray&&a.subarray)E.contents.set(a.subarray(c,c+u),p);else for(var A=0;A<u;A++)E.contents[p+A]=a[c+A];return E.usedBytes=Math.max(E.usedBytes,p+u),u},llseek(s,a,c){var u=a;if(c===1?u+=s.position:c===2&&b.isFile(s.node.mode)&&(u+=s.node.usedBytes),u<0)throw new b.ErrnoError(28);return u},mmap(s,a,c,u,p){if(!b.isFile(s.node.mode))throw new b.ErrnoError(43);var v,E,A=s.node.contents;if(!(p&2)&&A&&A.buffer===pt.buffer)E=!1,v=A.byteOffset;else{if(E=!0,v=Wt(a),!v)throw new b.ErrnoError(48);A&&((c>0||c+a<A.length)&&(A.subarray?A=A.subarray(c,c+a):A=Array.prototype.slice.call(A,c,c+a)),pt.set(A,v))}return{ptr:v,allocated:E}},msync(s,a,c,u,p){return ke.stream_ops.write(s,a,0,u,c,!1),0}}},Dt=async s=>{var a=await M(s);return G(a,`Loading data file "${s}" failed (no arrayBuffer).`),new Uint8Array(a)},jt=(...s)=>b.createDataFile(...s),He=s=>{for(var a=s;;){if(!T[s])return s;s=a+Math.random()}},an=[],wt=(s,a,c,u)=>{typeof Browser<"u"&&Browser.init();var p=!1;return an.forEach(v=>{p||v.canHandle(a)&&(v.handle(s,a,c,u),p=!0)}),p},ei=(s,a,c,u,p,v,E,A,F,q)=>{var Q=a?Te.resolve($.join2(s,a)):s,oe=He(`cp ${Q}`);function fe(ce){function me(Ye){q?.(),A||jt(s,a,Ye,u,p,F),v?.(),de(oe)}wt(ce,Q,me,()=>{E?.(),de(oe)})||me(ce)}ve(oe),typeof c=="string"?Dt(c).then(fe,E):fe(c)},on=s=>{var a={r:0,"r+":2,w:577,"w+":578,a:1089,"a+":1090},c=a[s];if(typeof c>"u")throw new Error(`Unknown file open mode: ${s}`);return c},Di=(s,a)=>{var c=0;return s&&(c|=365),a&&(c|=146),c},ti=s=>un(cu(s)),ni={EPERM:63,ENOENT:44,ESRCH:71,EINTR:27,EIO:29,ENXIO:60,E2BIG:1,ENOEXEC:45,EBADF:8,ECHILD:12,EAGAIN:6,EWOULDBLOCK:6,ENOMEM:48,EACCES:2,EFAULT:21,ENOTBLK:105,EBUSY:10,EEXIST:20,EXDEV:75,ENODEV:43,ENOTDIR:54,EISDIR:31,EINVAL:28,ENFILE:41,EMFILE:33,ENOTTY:59,ETXTBSY:74,EFBIG:22,ENOSPC:51,ESPIPE:70,EROFS:69,EMLINK:34,EPIPE:64,EDOM:18,ERANGE:68,ENOMSG:49,EIDRM:24,ECHRNG:106,EL2NSYNC:156,EL3HLT:107,EL3RST:108,ELNRNG:109,EUNATCH:110,ENOCSI:111,EL2HLT:112,EDEADLK:16,ENOLCK:46,EBADE:113,EBADR:114,EXFULL:115,ENOANO:104,EBADRQC:103,EBADSLT:102,EDEADLOCK:16,EBFONT:101,ENOSTR:100,ENODATA:116,ETIME:117,ENOSR:118,ENONET:119,ENOPKG:120,EREMOTE:121,ENOLINK:47,EADV:122,ESRMNT:123,ECOMM:124,EPROTO:65,EMULTIHOP:36,EDOTDOT:125,EBADMSG:9,ENOTUNIQ:126,EBADFD:127,EREMCHG:128,ELIBACC:129,ELIBBAD:130,ELIBSCN:131,ELIBMAX:132,ELIBEXEC:133,ENOSYS:52,ENOTEMPTY:55,ENAMETOOLONG:37,ELOOP:32,EOPNOTSUPP:138,EPFNOSUPPORT:139,ECONNRESET:15,ENOBUFS:42,EAFNOSUPPORT:5,EPROTOTYPE:67,ENOTSOCK:57,ENOPROTOOPT:50,ESHUTDOWN:140,ECONNREFUSED:14,EADDRINUSE:3,ECONNABORTED:13,ENETUNREACH:40,ENETDOWN:38,ETIMEDOUT:73,EHOSTDOWN:142,EHOSTUNREACH:23,EINPROGRESS:26,EALREADY:7,EDESTADDRREQ:17,EMSGSIZE:35,EPROTONOSUPPORT:66,ESOCKTNOSUPPORT:137,EADDRNOTAVAIL:4,ENETRESET:39,EISCONN:30,ENOTCONN:53,ETOOMANYREFS:141,EUSERS:136,EDQUOT:19,ESTALE:72,ENOTSUP:138,ENOMEDIUM:148,EILSEQ:25,EOVERFLOW:61,ECANCELED:11,ENOTRECOVERABLE:56,EOWNERDEAD:62,ESTRPIPE:135},b={root:null,mounts:[],devices:{},streams:[],nextInode:1,nameTable:null,currentPath:"/",initialized:!1,ignorePermissions:!0,filesystems:null,syncFSRequests:0,readFiles:{},ErrnoError:class extends Error{name="ErrnoError";constructor(s){super(Rt?ti(s):""),this.errno=s;for(var a in ni)if(ni[a]===s){this.code=a;break}}},FSStream:class{shared={};get object(){return this.node}set object(s){this.node=s}get isRead(){return(this.flags&2097155)!==1}get isWrite(){return(this.flags&2097155)!==0}get isAppend(){return this.flags&1024}get flags(){return this.shared.flags}set flags(s){this.shared.flags=s}get position(){return this.shared.position}set position(s){this.shared.position=s}},FSNode:class{node_ops={};stream_ops={};readMode=365;writeMode=146;mounted=null;constructor(s,a,c,u){s||(s=this),this.parent=s,this.mount=s.mount,this.id=b.nextInode++,this.name=a,this.mode=c,this.rdev=u,this.atime=this.mtime=this.ctime=Date.now()}get read(){return(this.mode&this.readMode)===this.readMode}set read(s){s?this.mode|=this.readMode:this.mode&=~this.readMode}get write(){return(this.mode&this.writeMode)===this.writeMode}set write(s){s?this.mode|=this.writeMode:this.mode&=~this.writeMode}get isFolder(){return b.isDir(this.mode)}get isDevice(){return b.isChrdev(this.mode)}},lookupPath(s,a={}){if(!s)throw new b.ErrnoError(44);a.follow_mount??=!0,$.isAbs(s)||(s=b.cwd()+"/"+s);e:for(var c=0;c<40;c++){for(var u=s.split("/").filter(q=>!!q),p=b.root,v="/",E=0;E<u.length;E++){var A=E===u.length-1;if(A&&a.parent)break;if(u[E]!=="."){if(u[E]===".."){if(v=$.dirname(v),b.isRoot(p)){s=v+"/"+u.slice(E+1).join("/");continue e}else p=p.parent;continue}v=$.join2(v,u[E]);try{p=b.lookupNode(p,u[E])}catch(q){if(q?.errno===44&&A&&a.noent_okay)return{path:v};throw q}if(b.isMountpoint(p)&&(!A||a.follow_mount)&&(p=p.mounted.root),b.isLink(p.mode)&&(!A||a.follow)){if(!p.node_ops.readlink)throw new b.ErrnoError(52);var F=p.node_ops.readlink(p);$.isAbs(F)||(F=$.dirname(v)+"/"+F),s=F+"/"+u.slice(E+1).join("/");continue e}}}return{path:v,node:p}}throw new b.ErrnoError(32)},getPath(s){for(var a;;){if(b.isRoot(s)){var c=s.mount.mountpoint;return a?c[c.length-1]!=="/"?`${c}/${a}`:c+a:c}a=a?`${s.name}/${a}`:s.name,s=s.parent}},hashName(s,a){for(var c=0,u=0;u<a.length;u++)c=(c<<5)-c+a.charCodeAt(u)|0;return(s+c>>>0)%b.nameTable.length},hashAddNode(s){var a=b.hashName(s.parent.id,s.name);s.name_next=b.nameTable[a],b.nameTable[a]=s},hashRemoveNode(s){var a=b.hashName(s.parent.id,s.name);if(b.nameTable[a]===s)b.nameTable[a]=s.name_next;else for(var c=b.nameTable[a];c;){if(c.name_next===s){c.name_next=s.name_next;break}c=c.name_next}},lookupNode(s,a){var c=b.mayLookup(s);if(c)throw new b.ErrnoError(c);for(var u=b.hashName(s.id,a),p=b.nameTable[u];p;p=p.name_next){var v=p.name;if(p.parent.id===s.id&&v===a)return p}return b.lookup(s,a)},createNode(s,a,c,u){G(typeof s=="object");var p=new b.FSNode(s,a,c,u);return b.hashAddNode(p),p},destroyNode(s){b.hashRemoveNode(s)},isRoot(s){return s===s.parent},isMountpoint(s){return!!s.mounted},isFile(s){return(s&61440)===32768},isDir(s){return(s&61440)===16384},isLink(s){return(s&61440)===40960},isChrdev(s){return(s&61440)===8192},isBlkdev(s){return(s&61440)===24576},isFIFO(s){return(s&61440)===4096},isSocket(s){return(s&49152)===49152},flagsToPermissionString(s){var a=["r","w","rw"][s&3];return s&512&&(a+="w"),a},nodePermissions(s,a){return b.ignorePermissions?0:a.includes("r")&&!(s.mode&292)||a.includes("w")&&!(s.mode&146)||a.includes("x")&&!(s.mode&73)?2:0},mayLookup(s){if(!b.isDir(s.mode))return 54;var a=b.nodePermissions(s,"x");return a||(s.node_ops.lookup?0:2)},mayCreate(s,a){if(!b.isDir(s.mode))return 54;try{var c=b.lookupNode(s,a);return 20}catch{}return b.nodePermissions(s,"wx")},mayDelete(s,a,c){var u;try{u=b.lookupNode(s,a)}catch(v){return v.errno}var p=b.nodePermissions(s,"wx");if(p)return p;if(c){if(!b.isDir(u.mode))return 54;if(b.isRoot(u)||b.getPath(u)===b.cwd())return 10}else if(b.isDir(u.mode))return 31;return 0},mayOpen(s,a){return s?b.isLink(s.mode)?32:b.isDir(s.mode)&&(b.flagsToPermissionString(a)!=="r"||a&576)?31:b.nodePermissions(s,b.flagsToPermissionString(a)):44},checkOpExists(s,a){if(!s)throw new b.ErrnoError(a);return s},MAX_OPEN_FDS:4096,nextfd(){for(var s=0;s<=b.MAX_OPEN_FDS;s++)if(!b.streams[s])return s;throw new b.ErrnoError(33)},getStreamChecked(s){var a=b.getStream(s);if(!a)throw new b.ErrnoError(8);return a},getStream:s=>b.streams[s],createStream(s,a=-1){return G(a>=-1),s=Object.assign(new b.FSStream,s),a==-1&&(a=b.nextfd()),s.fd=a,b.streams[a]=s,s},closeStream(s){b.streams[s]=null},dupStream(s,a=-1){var c=b.createStream(s,a);return c.stream_ops?.dup?.(c),c},doSetAttr(s,a,c){var u=s?.stream_ops.setattr,p=u?s:a;u??=a.node_ops.setattr,b.checkOpExists(u,63),u(p,c)},chrdev_stream_ops:{open(s){var a=b.getDevice(s.node.rdev);s.stream_ops=a.stream_ops,s.stream_ops.open?.(s)},llseek(){throw new b.ErrnoError(70)}},major:s=>s>>8,minor:s=>s&255,makedev:(s,a)=>s<<8|a,registerDevice(s,a){b.devices[s]={stream_ops:a}},getDevice:s=>b.devices[s],getMounts(s){for(var a=[],c=[s];c.length;){var u=c.pop();a.push(u),c.push(...u.mounts)}return a},syncfs(s,a){typeof s=="function"&&(a=s,s=!1),b.syncFSRequests++,b.syncFSRequests>1&&I(`warning: ${b.syncFSRequests} FS.syncfs operations in flight at once, probably just doing extra work`);var c=b.getMounts(b.root.mount),u=0;function p(E){return G(b.syncFSRequests>0),b.syncFSRequests--,a(E)}function v(E){if(E)return v.errored?void 0:(v.errored=!0,p(E));++u>=c.length&&p(null)}c.forEach(E=>{if(!E.type.syncfs)return v(null);E.type.syncfs(E,s,v)})},mount(s,a,c){if(typeof s=="string")throw s;var u=c==="/",p=!c,v;if(u&&b.root)throw new b.ErrnoError(10);if(!u&&!p){var E=b.lookupPath(c,{follow_mount:!1});if(c=E.path,v=E.node,b.isMountpoint(v))throw new b.ErrnoError(10);if(!b.isDir(v.mode))throw new b.ErrnoError(54)}var A={type:s,opts:a,mountpoint:c,mounts:[]},F=s.mount(A);return F.mount=A,A.root=F,u?b.root=F:v&&(v.mounted=A,v.mount&&v.mount.mounts.push(A)),F},unmount(s){var a=b.lookupPath(s,{follow_mount:!1});if(!b.isMountpoint(a.node))throw new b.ErrnoError(28);var c=a.node,u=c.mounted,p=b.getMounts(u);Object.keys(b.nameTable).forEach(E=>{for(var A=b.nameTable[E];A;){var F=A.name_next;p.includes(A.mount)&&b.destroyNode(A),A=F}}),c.mounted=null;var v=c.mount.mounts.indexOf(u);G(v!==-1),c.mount.mounts.splice(v,1)},lookup(s,a){return s.node_ops.lookup(s,a)},mknod(s,a,c){var u=b.lookupPath(s,{parent:!0}),p=u.node,v=$.basename(s);if(!v)throw new b.ErrnoError(28);if(v==="."||v==="..")throw new b.ErrnoError(20);var E=b.mayCreate(p,v);if(E)throw new b.ErrnoError(E);if(!p.node_ops.mknod)throw new b.ErrnoError(63);return p.node_ops.mknod(p,v,a,c)},statfs(s){return b.statfsNode(b.lookupPath(s,{follow:!0}).node)},statfsStream(s){return b.statfsNode(s.node)},statfsNode(s){var a={bsize:4096,frsize:4096,blocks:1e6,bfree:5e5,bavail:5e5,files:b.nextInode,ffree:b.nextInode-1,fsid:42,flags:2,namelen:255};return s.node_ops.statfs&&Object.assign(a,s.node_ops.statfs(s.mount.opts.root)),a},create(s,a=438){return a&=4095,a|=32768,b.mknod(s,a,0)},mkdir(s,a=511){return a&=1023,a|=16384,b.mknod(s,a,0)},mkdirTree(s,a){var c=s.split("/"),u="";for(var p of c)if(p){(u||$.isAbs(s))&&(u+="/"),u+=p;try{b.mkdir(u,a)}catch(v){if(v.errno!=20)throw v}}},mkdev(s,a,c){return typeof c>"u"&&(c=a,a=438),a|=8192,b.mknod(s,a,c)},symlink(s,a){if(!Te.resolve(s))throw new b.ErrnoError(44);var c=b.lookupPath(a,{parent:!0}),u=c.node;if(!u)throw new b.ErrnoError(44);var p=$.basename(a),v=b.mayCreate(u,p);if(v)throw new b.ErrnoError(v);if(!u.node_ops.symlink)throw new b.ErrnoError(63);return u.node_ops.symlink(u,p,s)},rename(s,a){var c=$.dirname(s),u=$.dirname(a),p=$.basename(s),v=$.basename(a),E,A,F;if(E=b.lookupPath(s,{parent:!0}),A=E.node,E=b.lookupPath(a,{parent:!0}),F=E.node,!A||!F)throw new b.ErrnoError(44);if(A.mount!==F.mount)throw new b.ErrnoError(75);var q=b.lookupNode(A,p),Q=Te.relative(s,u);if(Q.charAt(0)!==".")throw new b.ErrnoError(28);if(Q=Te.relative(a,c),Q.charAt(0)!==".")throw new b.ErrnoError(55);var oe;try{oe=b.lookupNode(F,v)}catch{}if(q!==oe){var fe=b.isDir(q.mode),ce=b.mayDelete(A,p,fe);if(ce)throw new b.ErrnoError(ce);if(ce=oe?b.mayDelete(F,v,fe):b.mayCreate(F,v),ce)throw new b.ErrnoError(ce);if(!A.node_ops.rename)throw new b.ErrnoError(63);if(b.isMountpoint(q)||oe&&b.isMountpoint(oe))throw new b.ErrnoError(10);if(F!==A&&(ce=b.nodePermissions(A,"w"),ce))throw new b.ErrnoError(ce);b.hashRemoveNode(q);try{A.node_ops.rename(q,F,v),q.parent=F}catch(me){throw me}finally{b.hashAddNode(q)}}},rmdir(s){var a=b.lookupPath(s,{parent:!0}),c=a.node,u=$.basename(s),p=b.lookupNode(c,u),v=b.mayDelete(c,u,!0);if(v)throw new b.ErrnoError(v);if(!c.node_ops.rmdir)throw new b.ErrnoError(63);if(b.isMountpoint(p))throw new b.ErrnoError(10);c.node_ops.rmdir(c,u),b.destroyNode(p)},readdir(s){var a=b.lookupPath(s,{follow:!0}),c=a.node,u=b.checkOpExists(c.node_ops.readdir,54);return u(c)},unlink(s){var a=b.lookupPath(s,{parent:!0}),c=a.node;if(!c)throw new b.ErrnoError(44);var u=$.basename(s),p=b.lookupNode(c,u),v=b.mayDelete(c,u,!1);if(v)throw new b.ErrnoError(v);if(!c.node_ops.unlink)throw new b.ErrnoError(63);if(b.isMountpoint(p))throw new b.ErrnoError(10);c.node_ops.unlink(c,u),b.destroyNode(p)},readlink(s){var a=b.lookupPath(s),c=a.node;if(!c)throw new b.ErrnoError(44);if(!c.node_ops.readlink)throw new b.ErrnoError(28);return c.node_ops.readlink(c)},stat(s,a){var c=b.lookupPath(s,{follow:!a}),u=c.node,p=b.checkOpExists(u.node_ops.getattr,63);return p(u)},fstat(s){var a=b.getStreamChecked(s),c=a.node,u=a.stream_ops.getattr,p=u?a:c;return u??=c.node_ops.getattr,b.checkOpExists(u,63),u(p)},lstat(s){return b.stat(s,!0)},doChmod(s,a,c,u){b.doSetAttr(s,a,{mode:c&4095|a.mode&-4096,ctime:Date.now(),dontFollow:u})},chmod(s,a,c){var u;if(typeof s=="string"){var p=b.lookupPath(s,{follow:!c});u=p.node}else u=s;b.doChmod(null,u,a,c)},lchmod(s,a){b.chmod(s,a,!0)},fchmod(s,a){var c=b.getStreamChecked(s);b.doChmod(c,c.node,a,!1)},doChown(s,a,c){b.doSetAttr(s,a,{timestamp:Date.now(),dontFollow:c})},chown(s,a,c,u){var p;if(typeof s=="string"){var v=b.lookupPath(s,{follow:!u});p=v.node}else p=s;b.doChown(null,p,u)},lchown(s,a,c){b.chown(s,a,c,!0)},fchown(s,a,c){var u=b.getStreamChecked(s);b.doChown(u,u.node,!1)},doTruncate(s,a,c){if(b.isDir(a.mode))throw new b.ErrnoError(31);if(!b.isFile(a.mode))throw new b.ErrnoError(28);var u=b.nodePermissions(a,"w");if(u)throw new b.ErrnoError(u);b.doSetAttr(s,a,{size:c,timestamp:Date.now()})},truncate(s,a){if(a<0)throw new b.ErrnoError(28);var c;if(typeof s=="string"){var u=b.lookupPath(s,{follow:!0});c=u.node}else c=s;b.doTruncate(null,c,a)},ftruncate(s,a){var c=b.getStreamChecked(s);if(a<0||(c.flags&2097155)===0)throw new b.ErrnoError(28);b.doTruncate(c,c.node,a)},utime(s,a,c){var u=b.lookupPath(s,{follow:!0}),p=u.node,v=b.checkOpExists(p.node_ops.setattr,63);v(p,{atime:a,mtime:c})},open(s,a,c=438){if(s==="")throw new b.ErrnoError(44);a=typeof a=="string"?on(a):a,a&64?c=c&4095|32768:c=0;var u,p;if(typeof s=="object")u=s;else{p=s.endsWith("/");var v=b.lookupPath(s,{follow:!(a&131072),noent_okay:!0});u=v.node,s=v.path}var E=!1;if(a&64)if(u){if(a&128)throw new b.ErrnoError(20)}else{if(p)throw new b.ErrnoError(31);u=b.mknod(s,c|511,0),E=!0}if(!u)throw new b.ErrnoError(44);if(b.isChrdev(u.mode)&&(a&=-513),a&65536&&!b.isDir(u.mode))throw new b.ErrnoError(54);if(!E){var A=b.mayOpen(u,a);if(A)throw new b.ErrnoError(A)}a&512&&!E&&b.truncate(u,0),a&=-131713;var F=b.createStream({node:u,path:b.getPath(u),flags:a,seekable:!0,position:0,stream_ops:u.stream_ops,ungotten:[],error:!1});return F.stream_ops.open&&F.stream_ops.open(F),E&&b.chmod(u,c&511),t.logReadFiles&&!(a&1)&&(s in b.readFiles||(b.readFiles[s]=1)),F},close(s){if(b.isClosed(s))throw new b.ErrnoError(8);s.getdents&&(s.getdents=null);try{s.stream_ops.close&&s.stream_ops.close(s)}catch(a){throw a}finally{b.closeStream(s.fd)}s.fd=null},isClosed(s){return s.fd===null},llseek(s,a,c){if(b.isClosed(s))throw new b.ErrnoError(8);if(!s.seekable||!s.stream_ops.llseek)throw new b.ErrnoError(70);if(c!=0&&c!=1&&c!=2)throw new b.ErrnoError(28);return s.position=s.stream_ops.llseek(s,a,c),s.ungotten=[],s.position},read(s,a,c,u,p){if(G(c>=0),u<0||p<0)throw new b.ErrnoError(28);if(b.isClosed(s))throw new b.ErrnoError(8);if((s.flags&2097155)===1)throw new b.ErrnoError(8);if(b.isDir(s.node.mode))throw new b.ErrnoError(31);if(!s.stream_ops.read)throw new b.ErrnoError(28);var v=typeof p<"u";if(!v)p=s.position;else if(!s.seekable)throw new b.ErrnoError(70);var E=s.stream_ops.read(s,a,c,u,p);return v||(s.position+=E),E},write(s,a,c,u,p,v){if(G(c>=0),u<0||p<0)throw new b.ErrnoError(28);if(b.isClosed(s))throw new b.ErrnoError(8);if((s.flags&2097155)===0)throw new b.ErrnoError(8);if(b.isDir(s.node.mode))throw new b.ErrnoError(31);if(!s.stream_ops.write)throw new b.ErrnoError(28);s.seekable&&s.flags&1024&&b.llseek(s,0,2);var E=typeof p<"u";if(!E)p=s.position;else if(!s.seekable)throw new b.ErrnoError(70);var A=s.stream_ops.write(s,a,c,u,p,v);return E||(s.position+=A),A},mmap(s,a,c,u,p){if((u&2)!==0&&(p&2)===0&&(s.flags&2097155)!==2)throw new b.ErrnoError(2);if((s.flags&2097155)===1)throw new b.ErrnoError(2);if(!s.stream_ops.mmap)throw new b.ErrnoError(43);if(!a)throw new b.ErrnoError(28);return s.stream_ops.mmap(s,a,c,u,p)},msync(s,a,c,u,p){return G(c>=0),s.stream_ops.msync?s.stream_ops.msync(s,a,c,u,p):0},ioctl(s,a,c){if(!s.stream_ops.ioctl)throw new b.ErrnoError(59);return s.stream_ops.ioctl(s,a,c)},readFile(s,a={}){if(a.flags=a.flags||0,a.encoding=a.encoding||"binary",a.encoding!=="utf8"&&a.encoding!=="binary")throw new Error(`Invalid encoding type "${a.encoding}"`);var c=b.open(s,a.flags),u=b.stat(s),p=u.size,v=new Uint8Array(p);return b.read(c,v,0,p,0),a.encoding==="utf8"&&(v=vi(v)),b.close(c),v},writeFile(s,a,c={}){c.flags=c.flags||577;var u=b.open(s,c.flags,c.mode);if(typeof a=="string"&&(a=new Uint8Array(gt(a,!0))),ArrayBuffer.isView(a))b.write(u,a,0,a.byteLength,void 0,c.canOwn);else throw new Error("Unsupported data type");b.close(u)},cwd:()=>b.currentPath,chdir(s){var a=b.lookupPath(s,{follow:!0});if(a.node===null)throw new b.ErrnoError(44);if(!b.isDir(a.node.mode))throw new b.ErrnoError(54);var c=b.nodePermissions(a.node,"x");if(c)throw new b.ErrnoError(c);b.currentPath=a.path},createDefaultDirectories(){b.mkdir("/tmp"),b.mkdir("/home"),b.mkdir("/home/web_user")},createDefaultDevices(){b.mkdir("/dev"),b.registerDevice(b.makedev(1,3),{read:()=>0,write:(u,p,v,E,A)=>E,llseek:()=>0}),b.mkdev("/dev/null",b.makedev(1,3)),lt.register(b.makedev(5,0),lt.default_tty_ops),lt.register(b.makedev(6,0),lt.default_tty1_ops),b.mkdev("/dev/tty",b.makedev(5,0)),b.mkdev("/dev/tty1",b.makedev(6,0));var s=new Uint8Array(1024),a=0,c=()=>(a===0&&(ze(s),a=s.byteLength),s[--a]);b.createDevice("/dev","random",c),b.createDevice("/dev","urandom",c),b.mkdir("/dev/shm"),b.mkdir("/dev/shm/tmp")},createSpecialDirectories(){b.mkdir("/proc");var s=b.mkdir("/proc/self");b.mkdir("/proc/self/fd"),b.mount({mount(){var a=b.createNode(s,"fd",16895,73);return a.stream_ops={llseek:ke.stream_ops.llseek},a.node_ops={lookup(c,u){var p=+u,v=b.getStreamChecked(p),E={parent:null,mount:{mountpoint:"fake"},node_ops:{readlink:()=>v.path},id:p+1};return E.parent=E,E},readdir(){return Array.from(b.streams.entries()).filter(([c,u])=>u).map(([c,u])=>c.toString())}},a}},{},"/proc/self/fd")},createStandardStreams(s,a,c){s?b.createDevice("/dev","stdin",s):b.symlink("/dev/tty","/dev/stdin"),a?b.createDevice("/dev","stdout",null,a):b.symlink("/dev/tty","/dev/stdout"),c?b.createDevice("/dev","stderr",null,c):b.symlink("/dev/tty1","/dev/stderr");var u=b.open("/dev/stdin",0),p=b.open("/dev/stdout",1),v=b.open("/dev/stderr",1);G(u.fd===0,`invalid handle for stdin (${u.fd})`),G(p.fd===1,`invalid handle for stdout (${p.fd})`),G(v.fd===2,`invalid handle for stderr (${v.fd})`)},staticInit(){b.nameTable=new Array(4096),b.mount(ke,{},"/"),b.createDefaultDirectories(),b.createDefaultDevices(),b.createSpecialDirectories(),b.filesystems={MEMFS:ke}},init(s,a,c){G(!b.initialized,"FS.init was previously called. If you want to initialize later with custom parameters, remove any earlier calls (note that one is automatically added to the generated code)"),b.initialized=!0,s??=t.stdin,a??=t.stdout,c??=t.stderr,b.createStandardStreams(s,a,c)},quit(){b.initialized=!1,tc(0);for(var s of b.streams)s&&b.close(s)},findObject(s,a){var c=b.analyzePath(s,a);return c.exists?c.object:null},analyzePath(s,a){try{var c=b.lookupPath(s,{follow:!a});s=c.path}catch{}var u={isRoot:!1,exists:!1,error:0,name:null,path:null,object:null,parentExists:!1,parentPath:null,parentObject:null};try{var c=b.lookupPath(s,{parent:!0});u.parentExists=!0,u.parentPath=c.path,u.parentObject=c.node,u.name=$.basename(s),c=b.lookupPath(s,{follow:!a}),u.exists=!0,u.path=c.path,u.object=c.node,u.name=c.node.name,u.isRoot=c.path==="/"}catch(p){u.error=p.errno}return u},createPath(s,a,c,u){s=typeof s=="string"?s:b.getPath(s);for(var p=a.split("/").reverse();p.length;){var v=p.pop();if(v){var E=$.join2(s,v);try{b.mkdir(E)}catch(A){if(A.errno!=20)throw A}s=E}}return E},createFile(s,a,c,u,p){var v=$.join2(typeof s=="string"?s:b.getPath(s),a),E=Di(u,p);return b.create(v,E)},createDataFile(s,a,c,u,p,v){var E=a;s&&(s=typeof s=="string"?s:b.getPath(s),E=a?$.join2(s,a):s);var A=Di(u,p),F=b.create(E,A);if(c){if(typeof c=="string"){for(var q=new Array(c.length),Q=0,oe=c.length;Q<oe;++Q)q[Q]=c.charCodeAt(Q);c=q}b.chmod(F,A|146);var fe=b.open(F,577);b.write(fe,c,0,c.length,0,v),b.close(fe),b.chmod(F,A)}},createDevice(s,a,c,u){var p=$.join2(typeof s=="string"?s:b.getPath(s),a),v=Di(!!c,!!u);b.createDevice.major??=64;var E=b.makedev(b.createDevice.major++,0);return b.registerDevice(E,{open(A){A.seekable=!1},close(A){u?.buffer?.length&&u(10)},read(A,F,q,Q,oe){for(var fe=0,ce=0;ce<Q;ce++){var me;try{me=c()}catch{throw new b.ErrnoError(29)}if(me===void 0&&fe===0)throw new b.ErrnoError(6);if(me==null)break;fe++,F[q+ce]=me}return fe&&(A.node.atime=Date.now()),fe},write(A,F,q,Q,oe){for(var fe=0;fe<Q;fe++)try{u(F[q+fe])}catch{throw new b.ErrnoError(29)}return Q&&(A.node.mtime=A.node.ctime=Date.now()),fe}}),b.mkdev(p,v,E)},forceLoadFile(s){if(s.isDevice||s.isFolder||s.link||s.contents)return!0;if(typeof XMLHttpRequest<"u")throw new Error("Lazy loading should have been performed (contents set) in createLazyFile, but it was not. Lazy loading only works in web workers. Use --embed-file or --preload-file in emcc on the main thread.");try{s.contents=R(s.url),s.usedBytes=s.contents.length}catch{throw new b.ErrnoError(29)}},createLazyFile(s,a,c,u,p){class v{lengthKnown=!1;chunks=[];get(ce){if(!(ce>this.length-1||ce<0)){var me=ce%this.chunkSize,Ye=ce/this.chunkSize|0;return this.getter(Ye)[me]}}setDataGetter(ce){this.getter=ce}cacheLength(){var ce=new XMLHttpRequest;if(ce.open("HEAD",c,!1),ce.send(null),!(ce.status>=200&&ce.status<300||ce.status===304))throw new Error("Couldn't load "+c+". Status: "+ce.status);var me=Number(ce.getResponseHeader("Content-length")),Ye,vt=(Ye=ce.getResponseHeader("Accept-Ranges"))&&Ye==="bytes",st=(Ye=ce.getResponseHeader("Content-Encoding"))&&Ye==="gzip",bt=1024*1024;vt||(bt=me);var tt=(Kt,xn)=>{if(Kt>xn)throw new Error("invalid range ("+Kt+", "+xn+") or no bytes requested!");if(xn>me-1)throw new Error("only "+me+" bytes available! programmer error!");var Nt=new XMLHttpRequest;if(Nt.open("GET",c,!1),me!==bt&&Nt.setRequestHeader("Range","bytes="+Kt+"-"+xn),Nt.responseType="arraybuffer",Nt.overrideMimeType&&Nt.overrideMimeType("text/plain; charset=x-user-defined"),Nt.send(null),!(Nt.status>=200&&Nt.status<300||Nt.status===304))throw new Error("Couldn't load "+c+". Status: "+Nt.status);return Nt.response!==void 0?new Uint8Array(Nt.response||[]):gt(Nt.responseText||"",!0)},$t=this;$t.setDataGetter(Kt=>{var xn=Kt*bt,Nt=(Kt+1)*bt-1;if(Nt=Math.min(Nt,me-1),typeof $t.chunks[Kt]>"u"&&($t.chunks[Kt]=tt(xn,Nt)),typeof $t.chunks[Kt]>"u")throw new Error("doXHR failed!");return $t.chunks[Kt]}),(st||!me)&&(bt=me=1,me=this.getter(0).length,bt=me,U("LazyFiles on gzip forces download of the whole file when length is accessed")),this._length=me,this._chunkSize=bt,this.lengthKnown=!0}get length(){return this.lengthKnown||this.cacheLength(),this._length}get chunkSize(){return this.lengthKnown||this.cacheLength(),this._chunkSize}}if(typeof XMLHttpRequest<"u"){if(!r)throw"Cannot do synchronous binary XHRs outside webworkers in modern browsers. Use --embed-file or --preload-file in emcc";var E=new v,A={isDevice:!1,contents:E}}else var A={isDevice:!1,url:c};var F=b.createFile(s,a,A,u,p);A.contents?F.contents=A.contents:A.url&&(F.contents=null,F.url=A.url),Object.defineProperties(F,{usedBytes:{get:function(){return this.contents.length}}});var q={},Q=Object.keys(F.stream_ops);Q.forEach(fe=>{var ce=F.stream_ops[fe];q[fe]=(...me)=>(b.forceLoadFile(F),ce(...me))});function oe(fe,ce,me,Ye,vt){var st=fe.node.contents;if(vt>=st.length)return 0;var bt=Math.min(st.length-vt,Ye);if(G(bt>=0),st.slice)for(var tt=0;tt<bt;tt++)ce[me+tt]=st[vt+tt];else for(var tt=0;tt<bt;tt++)ce[me+tt]=st.get(vt+tt);return bt}return q.read=(fe,ce,me,Ye,vt)=>(b.forceLoadFile(F),oe(fe,ce,me,Ye,vt)),q.mmap=(fe,ce,me,Ye,vt)=>{b.forceLoadFile(F);var st=Wt(ce);if(!st)throw new b.ErrnoError(48);return oe(fe,pt,st,ce,me),{ptr:st,allocated:!0}},F.stream_ops=q,F},absolutePath(){pe("FS.absolutePath has been removed; use PATH_FS.resolve instead")},createFolder(){pe("FS.createFolder has been removed; use FS.mkdir instead")},createLink(){pe("FS.createLink has been removed; use FS.symlink instead")},joinPath(){pe("FS.joinPath has been removed; use PATH.join instead")},mmapAlloc(){pe("FS.mmapAlloc has been replaced by the top level function mmapAlloc")},standardizePath(){pe("FS.standardizePath has been removed; use PATH.normalize instead")}},ft={DEFAULT_POLLMASK:5,calculateAt(s,a,c){if($.isAbs(a))return a;var u;if(s===-100)u=b.cwd();else{var p=ft.getStreamFromFD(s);u=p.path}if(a.length==0){if(!c)throw new b.ErrnoError(44);return u}return u+"/"+a},writeStat(s,a){De[s>>2]=a.dev,De[s+4>>2]=a.mode,qe[s+8>>2]=a.nlink,De[s+12>>2]=a.uid,De[s+16>>2]=a.gid,De[s+20>>2]=a.rdev,W[s+24>>3]=BigInt(a.size),De[s+32>>2]=4096,De[s+36>>2]=a.blocks;var c=a.atime.getTime(),u=a.mtime.getTime(),p=a.ctime.getTime();return W[s+40>>3]=BigInt(Math.floor(c/1e3)),qe[s+48>>2]=c%1e3*1e3*1e3,W[s+56>>3]=BigInt(Math.floor(u/1e3)),qe[s+64>>2]=u%1e3*1e3*1e3,W[s+72>>3]=BigInt(Math.floor(p/1e3)),qe[s+80>>2]=p%1e3*1e3*1e3,W[s+88>>3]=BigInt(a.ino),0},writeStatFs(s,a){De[s+4>>2]=a.bsize,De[s+40>>2]=a.bsize,De[s+8>>2]=a.blocks,De[s+12>>2]=a.bfree,De[s+16>>2]=a.bavail,De[s+20>>2]=a.files,De[s+24>>2]=a.ffree,De[s+28>>2]=a.fsid,De[s+44>>2]=a.flags,De[s+36>>2]=a.namelen},doMsync(s,a,c,u,p){if(!b.isFile(a.node.mode))throw new b.ErrnoError(43);if(u&2)return 0;var v=It.slice(s,s+c);b.msync(a,v,p,c,u)},getStreamFromFD(s){var a=b.getStreamChecked(s);return a},varargs:void 0,getStr(s){var a=un(s);return a}};function Cn(s,a,c){try{var u=ft.getStreamFromFD(s);if(G(!c),u.fd===a)return-28;if(a<0||a>=b.MAX_OPEN_FDS)return-8;var p=b.getStream(a);return p&&b.close(p),b.dupStream(u,a).fd}catch(v){if(typeof b>"u"||v.name!=="ErrnoError")throw v;return-v.errno}}var Ft=()=>{G(ft.varargs!=null);var s=De[+ft.varargs>>2];return ft.varargs+=4,s},Bt=Ft;function Hn(s,a,c){ft.varargs=c;try{var u=ft.getStreamFromFD(s);switch(a){case 0:{var p=Ft();if(p<0)return-28;for(;b.streams[p];)p++;var v;return v=b.dupStream(u,p),v.fd}case 1:case 2:return 0;case 3:return u.flags;case 4:{var p=Ft();return u.flags|=p,0}case 12:{var p=Bt(),E=0;return Mt[p+E>>1]=2,0}case 13:case 14:return 0}return-28}catch(A){if(typeof b>"u"||A.name!=="ErrnoError")throw A;return-A.errno}}function pa(s,a){try{return ft.writeStat(a,b.fstat(s))}catch(c){if(typeof b>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}function Ff(s,a,c){ft.varargs=c;try{var u=ft.getStreamFromFD(s);switch(a){case 21509:return u.tty?0:-59;case 21505:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tcgets){var p=u.tty.ops.ioctl_tcgets(u),v=Bt();De[v>>2]=p.c_iflag||0,De[v+4>>2]=p.c_oflag||0,De[v+8>>2]=p.c_cflag||0,De[v+12>>2]=p.c_lflag||0;for(var E=0;E<32;E++)pt[v+E+17]=p.c_cc[E]||0;return 0}return 0}case 21510:case 21511:case 21512:return u.tty?0:-59;case 21506:case 21507:case 21508:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tcsets){for(var v=Bt(),A=De[v>>2],F=De[v+4>>2],q=De[v+8>>2],Q=De[v+12>>2],oe=[],E=0;E<32;E++)oe.push(pt[v+E+17]);return u.tty.ops.ioctl_tcsets(u.tty,a,{c_iflag:A,c_oflag:F,c_cflag:q,c_lflag:Q,c_cc:oe})}return 0}case 21519:{if(!u.tty)return-59;var v=Bt();return De[v>>2]=0,0}case 21520:return u.tty?-28:-59;case 21531:{var v=Bt();return b.ioctl(u,a,v)}case 21523:{if(!u.tty)return-59;if(u.tty.ops.ioctl_tiocgwinsz){var fe=u.tty.ops.ioctl_tiocgwinsz(u.tty),v=Bt();Mt[v>>1]=fe[0],Mt[v+2>>1]=fe[1]}return 0}case 21524:return u.tty?0:-59;case 21515:return u.tty?0:-59;default:return-28}}catch(ce){if(typeof b>"u"||ce.name!=="ErrnoError")throw ce;return-ce.errno}}function Nf(s,a){try{return s=ft.getStr(s),ft.writeStat(a,b.lstat(s))}catch(c){if(typeof b>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}function Uf(s,a,c,u){try{a=ft.getStr(a);var p=u&256,v=u&4096;return u=u&-6401,G(!u,`unknown flags in __syscall_newfstatat: ${u}`),a=ft.calculateAt(s,a,v),ft.writeStat(c,p?b.lstat(a):b.stat(a))}catch(E){if(typeof b>"u"||E.name!=="ErrnoError")throw E;return-E.errno}}function Of(s,a,c,u){ft.varargs=u;try{a=ft.getStr(a),a=ft.calculateAt(s,a);var p=u?Ft():0;return b.open(a,c,p).fd}catch(v){if(typeof b>"u"||v.name!=="ErrnoError")throw v;return-v.errno}}function Bf(s,a){try{return s=ft.getStr(s),ft.writeStat(a,b.stat(s))}catch(c){if(typeof b>"u"||c.name!=="ErrnoError")throw c;return-c.errno}}var kf=()=>pe("native code called abort()"),Zt=s=>{for(var a="";;){var c=It[s++];if(!c)return a;a+=String.fromCharCode(c)}},xr={},er={},ma={},as=class extends Error{constructor(a){super(a),this.name="BindingError"}},xt=s=>{throw new as(s)};function zf(s,a,c={}){var u=a.name;if(s||xt(`type "${u}" must have a positive integer typeid pointer`),er.hasOwnProperty(s)){if(c.ignoreDuplicateRegistrations)return;xt(`Cannot register type '${u}' twice`)}if(er[s]=a,delete ma[s],xr.hasOwnProperty(s)){var p=xr[s];delete xr[s],p.forEach(v=>v())}}function On(s,a,c={}){if(a.argPackAdvance===void 0)throw new TypeError("registerType registeredInstance requires argPackAdvance");return zf(s,a,c)}var Fh=(s,a,c)=>{switch(a){case 1:return c?u=>pt[u]:u=>It[u];case 2:return c?u=>Mt[u>>1]:u=>rn[u>>1];case 4:return c?u=>De[u>>2]:u=>qe[u>>2];case 8:return c?u=>W[u>>3]:u=>yn[u>>3];default:throw new TypeError(`invalid integer width (${a}): ${s}`)}},tr=s=>{if(s===null)return"null";var a=typeof s;return a==="object"||a==="array"||a==="function"?s.toString():""+s},Nh=(s,a,c,u)=>{if(a<c||a>u)throw new TypeError(`Passing a number "${tr(a)}" from JS side to C/C++ side to an argument of type "${s}", which is outside the valid range [${c}, ${u}]!`)},Gf=(s,a,c,u,p)=>{a=Zt(a);let v=u===0n,E=A=>A;if(v){let A=c*8;E=F=>BigInt.asUintN(A,F),p=E(p)}On(s,{name:a,fromWireType:E,toWireType:(A,F)=>{if(typeof F=="number")F=BigInt(F);else if(typeof F!="bigint")throw new TypeError(`Cannot convert "${tr(F)}" to ${this.name}`);return Nh(a,F,u,p),F},argPackAdvance:ii,readValueFromPointer:Fh(a,c,!v),destructorFunction:null})},ii=8,Vf=(s,a,c,u)=>{a=Zt(a),On(s,{name:a,fromWireType:function(p){return!!p},toWireType:function(p,v){return v?c:u},argPackAdvance:ii,readValueFromPointer:function(p){return this.fromWireType(It[p])},destructorFunction:null})},Hf=s=>({count:s.count,deleteScheduled:s.deleteScheduled,preservePointerOnDelete:s.preservePointerOnDelete,ptr:s.ptr,ptrType:s.ptrType,smartPtr:s.smartPtr,smartPtrType:s.smartPtrType}),Wl=s=>{function a(c){return c.$$.ptrType.registeredClass.name}xt(a(s)+" instance already deleted")},Xl=!1,Uh=s=>{},Wf=s=>{s.smartPtr?s.smartPtrType.rawDestructor(s.smartPtr):s.ptrType.registeredClass.rawDestructor(s.ptr)},Oh=s=>{s.count.value-=1;var a=s.count.value===0;a&&Wf(s)},Bh=(s,a,c)=>{if(a===c)return s;if(c.baseClass===void 0)return null;var u=Bh(s,a,c.baseClass);return u===null?null:c.downcast(u)},kh={},Xf={},qf=(s,a)=>{for(a===void 0&&xt("ptr should not be undefined");s.baseClass;)a=s.upcast(a),s=s.baseClass;return a},$f=(s,a)=>(a=qf(s,a),Xf[a]),Yf=class extends Error{constructor(a){super(a),this.name="InternalError"}},ga=s=>{throw new Yf(s)},_a=(s,a)=>{(!a.ptrType||!a.ptr)&&ga("makeClassHandle requires ptr and ptrType");var c=!!a.smartPtrType,u=!!a.smartPtr;return c!==u&&ga("Both smartPtrType and smartPtr must be specified"),a.count={value:1},os(Object.create(s,{$$:{value:a,writable:!0}}))};function zh(s){var a=this.getPointee(s);if(!a)return this.destructor(s),null;var c=$f(this.registeredClass,a);if(c!==void 0){if(c.$$.count.value===0)return c.$$.ptr=a,c.$$.smartPtr=s,c.clone();var u=c.clone();return this.destructor(s),u}function p(){return this.isSmartPointer?_a(this.registeredClass.instancePrototype,{ptrType:this.pointeeType,ptr:a,smartPtrType:this,smartPtr:s}):_a(this.registeredClass.instancePrototype,{ptrType:this,ptr:s})}var v=this.registeredClass.getActualType(a),E=kh[v];if(!E)return p.call(this);var A;this.isConst?A=E.constPointerType:A=E.pointerType;var F=Bh(a,this.registeredClass,A.registeredClass);return F===null?p.call(this):this.isSmartPointer?_a(A.registeredClass.instancePrototype,{ptrType:A,ptr:F,smartPtrType:this,smartPtr:s}):_a(A.registeredClass.instancePrototype,{ptrType:A,ptr:F})}var os=s=>typeof FinalizationRegistry>"u"?(os=a=>a,s):(Xl=new FinalizationRegistry(a=>{console.warn(a.leakWarning),Oh(a.$$)}),os=a=>{var c=a.$$,u=!!c.smartPtr;if(u){var p={$$:c},v=c.ptrType.registeredClass,E=new Error(`Embind found a leaked C++ instance ${v.name} <${Ot(c.ptr)}>.
We'll free it automatically in this case, but this functionality is not reliable across various environments.
Make sure to invoke .delete() manually once you're done with the instance instead.
Originally allocated`);"captureStackTrace"in Error&&Error.captureStackTrace(E,zh),p.leakWarning=E.stack.replace(/^Error: /,""),Xl.register(a,p,a)}return a},Uh=a=>Xl.unregister(a),os(s)),va=[],jf=()=>{for(;va.length;){var s=va.pop();s.$$.deleteScheduled=!1,s.delete()}},Gh,Zf=()=>{let s=ya.prototype;Object.assign(s,{isAliasOf(c){if(!(this instanceof ya)||!(c instanceof ya))return!1;var u=this.$$.ptrType.registeredClass,p=this.$$.ptr;c.$$=c.$$;for(var v=c.$$.ptrType.registeredClass,E=c.$$.ptr;u.baseClass;)p=u.upcast(p),u=u.baseClass;for(;v.baseClass;)E=v.upcast(E),v=v.baseClass;return u===v&&p===E},clone(){if(this.$$.ptr||Wl(this),this.$$.preservePointerOnDelete)return this.$$.count.value+=1,this;var c=os(Object.create(Object.getPrototypeOf(this),{$$:{value:Hf(this.$$)}}));return c.$$.count.value+=1,c.$$.deleteScheduled=!1,c},delete(){this.$$.ptr||Wl(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),Uh(this),Oh(this.$$),this.$$.preservePointerOnDelete||(this.$$.smartPtr=void 0,this.$$.ptr=void 0)},isDeleted(){return!this.$$.ptr},deleteLater(){return this.$$.ptr||Wl(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),va.push(this),va.length===1&&Gh&&Gh(jf),this.$$.deleteScheduled=!0,this}});let a=Symbol.dispose;a&&(s[a]=s.delete)};function ya(){}var xa=(s,a)=>Object.defineProperty(a,"name",{value:s}),ql=(s,a,c)=>{if(s[a].overloadTable===void 0){var u=s[a];s[a]=function(...p){return s[a].overloadTable.hasOwnProperty(p.length)||xt(`Function '${c}' called with an invalid number of arguments (${p.length}) - expects one of (${s[a].overloadTable})!`),s[a].overloadTable[p.length].apply(this,p)},s[a].overloadTable=[],s[a].overloadTable[u.argCount]=u}},$l=(s,a,c)=>{t.hasOwnProperty(s)?((c===void 0||t[s].overloadTable!==void 0&&t[s].overloadTable[c]!==void 0)&&xt(`Cannot register public name '${s}' twice`),ql(t,s,s),t[s].overloadTable.hasOwnProperty(c)&&xt(`Cannot register multiple overloads of a function with the same number of arguments (${c})!`),t[s].overloadTable[c]=a):(t[s]=a,t[s].argCount=c)},Jf=48,Kf=57,Qf=s=>{G(typeof s=="string"),s=s.replace(/[^a-zA-Z0-9_]/g,"$");var a=s.charCodeAt(0);return a>=Jf&&a<=Kf?`_${s}`:s};function ep(s,a,c,u,p,v,E,A){this.name=s,this.constructor=a,this.instancePrototype=c,this.rawDestructor=u,this.baseClass=p,this.getActualType=v,this.upcast=E,this.downcast=A,this.pureVirtualFunctions=[]}var Sa=(s,a,c)=>{for(;a!==c;)a.upcast||xt(`Expected null or instance of ${c.name}, got an instance of ${a.name}`),s=a.upcast(s),a=a.baseClass;return s};function tp(s,a){if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;a.$$||xt(`Cannot pass "${tr(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`);var c=a.$$.ptrType.registeredClass,u=Sa(a.$$.ptr,c,this.registeredClass);return u}function np(s,a){var c;if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),this.isSmartPointer?(c=this.rawConstructor(),s!==null&&s.push(this.rawDestructor,c),c):0;(!a||!a.$$)&&xt(`Cannot pass "${tr(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),!this.isConst&&a.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${a.$$.smartPtrType?a.$$.smartPtrType.name:a.$$.ptrType.name} to parameter type ${this.name}`);var u=a.$$.ptrType.registeredClass;if(c=Sa(a.$$.ptr,u,this.registeredClass),this.isSmartPointer)switch(a.$$.smartPtr===void 0&&xt("Passing raw pointer to smart pointer is illegal"),this.sharingPolicy){case 0:a.$$.smartPtrType===this?c=a.$$.smartPtr:xt(`Cannot convert argument of type ${a.$$.smartPtrType?a.$$.smartPtrType.name:a.$$.ptrType.name} to parameter type ${this.name}`);break;case 1:c=a.$$.smartPtr;break;case 2:if(a.$$.smartPtrType===this)c=a.$$.smartPtr;else{var p=a.clone();c=this.rawShare(c,Jt.toHandle(()=>p.delete())),s!==null&&s.push(this.rawDestructor,c)}break;default:xt("Unsupporting sharing policy")}return c}function ip(s,a){if(a===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;a.$$||xt(`Cannot pass "${tr(a)}" as a ${this.name}`),a.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),a.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${a.$$.ptrType.name} to parameter type ${this.name}`);var c=a.$$.ptrType.registeredClass,u=Sa(a.$$.ptr,c,this.registeredClass);return u}function Ma(s){return this.fromWireType(qe[s>>2])}var rp=()=>{Object.assign(ba.prototype,{getPointee(s){return this.rawGetPointee&&(s=this.rawGetPointee(s)),s},destructor(s){this.rawDestructor?.(s)},argPackAdvance:ii,readValueFromPointer:Ma,fromWireType:zh})};function ba(s,a,c,u,p,v,E,A,F,q,Q){this.name=s,this.registeredClass=a,this.isReference=c,this.isConst=u,this.isSmartPointer=p,this.pointeeType=v,this.sharingPolicy=E,this.rawGetPointee=A,this.rawConstructor=F,this.rawShare=q,this.rawDestructor=Q,!p&&a.baseClass===void 0?u?(this.toWireType=tp,this.destructorFunction=null):(this.toWireType=ip,this.destructorFunction=null):this.toWireType=np}var Vh=(s,a,c)=>{t.hasOwnProperty(s)||ga("Replacing nonexistent public symbol"),t[s].overloadTable!==void 0&&c!==void 0?t[s].overloadTable[c]=a:(t[s]=a,t[s].argCount=c)},Hh=[],wa,be=s=>{var a=Hh[s];return a||(Hh[s]=a=wa.get(s)),G(wa.get(s)==a,"JavaScript-side Wasm function table mirror is out of date!"),a},ri=(s,a,c=!1)=>{G(!c,"Async bindings are only supported with JSPI."),s=Zt(s);function u(){var v=be(a);return v}var p=u();return typeof p!="function"&&xt(`unknown function pointer with signature ${s}: ${a}`),p};class sp extends Error{}var Wh=s=>{var a=lu(s),c=Zt(a);return Xn(a),c},nr=(s,a)=>{var c=[],u={};function p(v){if(!u[v]&&!er[v]){if(ma[v]){ma[v].forEach(p);return}c.push(v),u[v]=!0}}throw a.forEach(p),new sp(`${s}: `+c.map(Wh).join([", "]))},Wn=(s,a,c)=>{s.forEach(A=>ma[A]=a);function u(A){var F=c(A);F.length!==s.length&&ga("Mismatched type converter count");for(var q=0;q<s.length;++q)On(s[q],F[q])}var p=new Array(a.length),v=[],E=0;a.forEach((A,F)=>{er.hasOwnProperty(A)?p[F]=er[A]:(v.push(A),xr.hasOwnProperty(A)||(xr[A]=[]),xr[A].push(()=>{p[F]=er[A],++E,E===v.length&&u(p)}))}),v.length===0&&u(p)},ap=(s,a,c,u,p,v,E,A,F,q,Q,oe,fe)=>{Q=Zt(Q),v=ri(p,v),A&&=ri(E,A),q&&=ri(F,q),fe=ri(oe,fe);var ce=Qf(Q);$l(ce,function(){nr(`Cannot construct ${Q} due to unbound types`,[u])}),Wn([s,a,c],u?[u]:[],me=>{me=me[0];var Ye,vt;u?(Ye=me.registeredClass,vt=Ye.instancePrototype):vt=ya.prototype;var st=xa(Q,function(...Nt){if(Object.getPrototypeOf(this)!==bt)throw new as(`Use 'new' to construct ${Q}`);if(tt.constructor_body===void 0)throw new as(`${Q} has no accessible constructor`);var sr=tt.constructor_body[Nt.length];if(sr===void 0)throw new as(`Tried to invoke ctor of ${Q} with invalid number of parameters (${Nt.length}) - expected (${Object.keys(tt.constructor_body).toString()}) parameters instead!`);return sr.apply(this,Nt)}),bt=Object.create(vt,{constructor:{value:st}});st.prototype=bt;var tt=new ep(Q,st,bt,fe,Ye,v,A,q);tt.baseClass&&(tt.baseClass.__derivedClasses??=[],tt.baseClass.__derivedClasses.push(tt));var $t=new ba(Q,tt,!0,!1,!1),Kt=new ba(Q+"*",tt,!1,!1,!1),xn=new ba(Q+" const*",tt,!1,!0,!1);return kh[s]={pointerType:Kt,constPointerType:xn},Vh(ce,st),[$t,Kt,xn]})},Ea=s=>{for(;s.length;){var a=s.pop(),c=s.pop();c(a)}};function Xh(s){for(var a=1;a<s.length;++a)if(s[a]!==null&&s[a].destructorFunction===void 0)return!0;return!1}function qh(s,a,c,u,p){if(s<a||s>c){var v=a==c?a:`${a} to ${c}`;p(`function ${u} called with ${s} arguments, expected ${v}`)}}function Sw(s,a,c,u){var p=Xh(s),v=s.length-2,E=[],A=["fn"];a&&A.push("thisWired");for(var F=0;F<v;++F)E.push(`arg${F}`),A.push(`arg${F}Wired`);E=E.join(","),A=A.join(",");var q=`return function (${E}) {
`;q+=`checkArgCount(arguments.length, minArgs, maxArgs, humanName, throwBindingError);
`,p&&(q+=`var destructors = [];
`);var Q=p?"destructors":"null",oe=["humanName","throwBindingError","invoker","fn","runDestructors","retType","classParam"];a&&(q+=`var thisWired = classParam['toWireType'](${Q}, this);
`);for(var F=0;F<v;++F)q+=`var arg${F}Wired = argType${F}['toWireType'](${Q}, arg${F});
`,oe.push(`argType${F}`);q+=(c||u?"var rv = ":"")+`invoker(${A});
`;var fe=c?"rv":"";if(p)q+=`runDestructors(destructors);
`;else for(var F=a?1:2;F<s.length;++F){var ce=F===1?"thisWired":"arg"+(F-2)+"Wired";s[F].destructorFunction!==null&&(q+=`${ce}_dtor(${ce});
`,oe.push(`${ce}_dtor`))}return c&&(q+=`var ret = retType['fromWireType'](rv);
return ret;
`),q+=`}
`,oe.push("checkArgCount","minArgs","maxArgs"),q=`if (arguments.length !== ${oe.length}){ throw new Error(humanName + "Expected ${oe.length} closure arguments " + arguments.length + " given."); }
${q}`,[oe,q]}function op(s){for(var a=s.length-2,c=s.length-1;c>=2&&s[c].optional;--c)a--;return a}function Ta(s,a,c,u,p,v){var E=a.length;E<2&&xt("argTypes array size mismatch! Must at least get return value and 'this' types!"),G(!v,"Async bindings are only supported with JSPI.");for(var A=a[1]!==null&&c!==null,F=Xh(a),q=a[0].name!=="void",Q=E-2,oe=op(a),fe=[s,xt,u,p,Ea,a[0],a[1]],ce=0;ce<E-2;++ce)fe.push(a[ce+2]);if(!F)for(var ce=A?1:2;ce<a.length;++ce)a[ce].destructorFunction!==null&&fe.push(a[ce].destructorFunction);fe.push(qh,oe,Q);var me=A?1:2,Ye=function(...vt){qh(vt.length,oe,Q,s,xt);for(var st=F?[]:null,bt=A?[a[1].toWireType(st,this)]:[],tt=0;tt<Q;++tt)bt.push(a[tt+2].toWireType(st,vt[tt]));var $t=u(p,...bt);if(F)Ea(st);else for(var tt=me;tt<a.length;++tt)a[tt].destructorFunction?.(bt[tt-me]);if(q)return a[0].fromWireType($t)};return xa(s,Ye)}var Aa=(s,a)=>{for(var c=[],u=0;u<s;u++)c.push(qe[a+u*4>>2]);return c},Yl=s=>{s=s.trim();let a=s.indexOf("(");return a===-1?s:(G(s.endsWith(")"),"Parentheses for argument names should match."),s.slice(0,a))},lp=(s,a,c,u,p,v,E,A,F)=>{var q=Aa(c,u);a=Zt(a),a=Yl(a),v=ri(p,v,A),Wn([],[s],Q=>{Q=Q[0];var oe=`${Q.name}.${a}`;function fe(){nr(`Cannot call ${oe} due to unbound types`,q)}a.startsWith("@@")&&(a=Symbol[a.substring(2)]);var ce=Q.registeredClass.constructor;return ce[a]===void 0?(fe.argCount=c-1,ce[a]=fe):(ql(ce,a,oe),ce[a].overloadTable[c-1]=fe),Wn([],q,me=>{var Ye=[me[0],null].concat(me.slice(1)),vt=Ta(oe,Ye,null,v,E,A);if(ce[a].overloadTable===void 0?(vt.argCount=c-1,ce[a]=vt):ce[a].overloadTable[c-1]=vt,Q.registeredClass.__derivedClasses)for(let st of Q.registeredClass.__derivedClasses)st.constructor.hasOwnProperty(a)||(st.constructor[a]=vt);return[]}),[]})},cp=(s,a,c,u,p,v)=>{G(a>0);var E=Aa(a,c);p=ri(u,p);var A=[v],F=[];Wn([],[s],q=>{q=q[0];var Q=`constructor ${q.name}`;if(q.registeredClass.constructor_body===void 0&&(q.registeredClass.constructor_body=[]),q.registeredClass.constructor_body[a-1]!==void 0)throw new as(`Cannot register multiple constructors with identical number of parameters (${a-1}) for class '${q.name}'! Overload resolution is currently only performed using the parameter count, not actual type info!`);return q.registeredClass.constructor_body[a-1]=()=>{nr(`Cannot construct ${q.name} due to unbound types`,E)},Wn([],E,oe=>(oe.splice(1,0,null),q.registeredClass.constructor_body[a-1]=Ta(Q,oe,null,p,v),[])),[]})},hp=(s,a,c,u,p,v,E,A,F,q)=>{var Q=Aa(c,u);a=Zt(a),a=Yl(a),v=ri(p,v,F),Wn([],[s],oe=>{oe=oe[0];var fe=`${oe.name}.${a}`;a.startsWith("@@")&&(a=Symbol[a.substring(2)]),A&&oe.registeredClass.pureVirtualFunctions.push(a);function ce(){nr(`Cannot call ${fe} due to unbound types`,Q)}var me=oe.registeredClass.instancePrototype,Ye=me[a];return Ye===void 0||Ye.overloadTable===void 0&&Ye.className!==oe.name&&Ye.argCount===c-2?(ce.argCount=c-2,ce.className=oe.name,me[a]=ce):(ql(me,a,fe),me[a].overloadTable[c-2]=ce),Wn([],Q,vt=>{var st=Ta(fe,vt,oe,v,E,F);return me[a].overloadTable===void 0?(st.argCount=c-2,me[a]=st):me[a].overloadTable[c-2]=st,[]}),[]})},$h=(s,a,c)=>(s instanceof Object||xt(`${c} with invalid "this": ${s}`),s instanceof a.registeredClass.constructor||xt(`${c} incompatible with "this" of type ${s.constructor.name}`),s.$$.ptr||xt(`cannot call emscripten binding method ${c} on deleted object`),Sa(s.$$.ptr,s.$$.ptrType.registeredClass,a.registeredClass)),up=(s,a,c,u,p,v,E,A,F,q)=>{a=Zt(a),p=ri(u,p),Wn([],[s],Q=>{Q=Q[0];var oe=`${Q.name}.${a}`,fe={get(){nr(`Cannot access ${oe} due to unbound types`,[c,E])},enumerable:!0,configurable:!0};return F?fe.set=()=>nr(`Cannot access ${oe} due to unbound types`,[c,E]):fe.set=ce=>xt(oe+" is a read-only property"),Object.defineProperty(Q.registeredClass.instancePrototype,a,fe),Wn([],F?[c,E]:[c],ce=>{var me=ce[0],Ye={get(){var st=$h(this,Q,oe+" getter");return me.fromWireType(p(v,st))},enumerable:!0};if(F){F=ri(A,F);var vt=ce[1];Ye.set=function(st){var bt=$h(this,Q,oe+" setter"),tt=[];F(q,bt,vt.toWireType(tt,st)),Ea(tt)}}return Object.defineProperty(Q.registeredClass.instancePrototype,a,Ye),[]}),[]})},dp=(s,a,c)=>{s=Zt(s),Wn([],[a],u=>(u=u[0],t[s]=u.fromWireType(c),[]))},Yh=[],si=[0,1,,1,null,1,!0,1,!1,1],jl=s=>{s>9&&--si[s+1]===0&&(G(si[s]!==void 0,"Decref for unallocated handle."),si[s]=void 0,Yh.push(s))},Jt={toValue:s=>(s||xt(`Cannot use deleted val. handle = ${s}`),G(s===2||si[s]!==void 0&&s%2===0,`invalid handle: ${s}`),si[s]),toHandle:s=>{switch(s){case void 0:return 2;case null:return 4;case!0:return 6;case!1:return 8;default:{let a=Yh.pop()||si.length;return si[a]=s,si[a+1]=1,a}}}},jh={name:"emscripten::val",fromWireType:s=>{var a=Jt.toValue(s);return jl(s),a},toWireType:(s,a)=>Jt.toHandle(a),argPackAdvance:ii,readValueFromPointer:Ma,destructorFunction:null},Zh=s=>On(s,jh),fp=(s,a,c)=>{switch(a){case 1:return c?function(u){return this.fromWireType(pt[u])}:function(u){return this.fromWireType(It[u])};case 2:return c?function(u){return this.fromWireType(Mt[u>>1])}:function(u){return this.fromWireType(rn[u>>1])};case 4:return c?function(u){return this.fromWireType(De[u>>2])}:function(u){return this.fromWireType(qe[u>>2])};default:throw new TypeError(`invalid integer width (${a}): ${s}`)}},pp=(s,a,c,u)=>{a=Zt(a);function p(){}p.values={},On(s,{name:a,constructor:p,fromWireType:function(v){return this.constructor.values[v]},toWireType:(v,E)=>E.value,argPackAdvance:ii,readValueFromPointer:fp(a,c,u),destructorFunction:null}),$l(a,p)},Ca=(s,a)=>{var c=er[s];return c===void 0&&xt(`${a} has unknown type ${Wh(s)}`),c},mp=(s,a,c)=>{var u=Ca(s,"enum");a=Zt(a);var p=u.constructor,v=Object.create(u.constructor.prototype,{value:{value:c},constructor:{value:xa(`${u.name}_${a}`,function(){})}});p.values[c]=v,p[a]=v},gp=(s,a)=>{switch(a){case 4:return function(c){return this.fromWireType(hn[c>>2])};case 8:return function(c){return this.fromWireType(sn[c>>3])};default:throw new TypeError(`invalid float width (${a}): ${s}`)}},_p=(s,a,c)=>{a=Zt(a),On(s,{name:a,fromWireType:u=>u,toWireType:(u,p)=>{if(typeof p!="number"&&typeof p!="boolean")throw new TypeError(`Cannot convert ${tr(p)} to ${this.name}`);return p},argPackAdvance:ii,readValueFromPointer:gp(a,c),destructorFunction:null})},vp=(s,a,c,u,p,v,E,A)=>{var F=Aa(a,c);s=Zt(s),s=Yl(s),p=ri(u,p,E),$l(s,function(){nr(`Cannot call ${s} due to unbound types`,F)},a-1),Wn([],F,q=>{var Q=[q[0],null].concat(q.slice(1));return Vh(s,Ta(s,Q,null,p,v,E),a-1),[]})},yp=(s,a,c,u,p)=>{a=Zt(a);let v=u===0,E=F=>F;if(v){var A=32-8*c;E=F=>F<<A>>>A,p=E(p)}On(s,{name:a,fromWireType:E,toWireType:(F,q)=>{if(typeof q!="number"&&typeof q!="boolean")throw new TypeError(`Cannot convert "${tr(q)}" to ${a}`);return Nh(a,q,u,p),q},argPackAdvance:ii,readValueFromPointer:Fh(a,c,u!==0),destructorFunction:null})},xp=(s,a,c)=>{var u=[Int8Array,Uint8Array,Int16Array,Uint16Array,Int32Array,Uint32Array,Float32Array,Float64Array,BigInt64Array,BigUint64Array],p=u[a];function v(E){var A=qe[E>>2],F=qe[E+4>>2];return new p(pt.buffer,F,A)}c=Zt(c),On(s,{name:c,fromWireType:v,argPackAdvance:ii,readValueFromPointer:v},{ignoreDuplicateRegistrations:!0})},Sp=Object.assign({optional:!0},jh),Mp=(s,a)=>{On(s,Sp)},ir=(s,a,c)=>(G(typeof c=="number","stringToUTF8(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),rt(s,It,a,c)),bp=(s,a)=>{a=Zt(a);var c=!0;On(s,{name:a,fromWireType(u){var p=qe[u>>2],v=u+4,E;if(c)for(var A=v,F=0;F<=p;++F){var q=v+F;if(F==p||It[q]==0){var Q=q-A,oe=un(A,Q);E===void 0?E=oe:(E+="\0",E+=oe),A=q+1}}else{for(var fe=new Array(p),F=0;F<p;++F)fe[F]=String.fromCharCode(It[v+F]);E=fe.join("")}return Xn(u),E},toWireType(u,p){p instanceof ArrayBuffer&&(p=new Uint8Array(p));var v,E=typeof p=="string";E||ArrayBuffer.isView(p)&&p.BYTES_PER_ELEMENT==1||xt("Cannot pass non-string to std::string"),c&&E?v=Ge(p):v=p.length;var A=ec(4+v+1),F=A+4;if(qe[A>>2]=v,E)if(c)ir(p,F,v+1);else for(var q=0;q<v;++q){var Q=p.charCodeAt(q);Q>255&&(Xn(A),xt("String has UTF-16 code units that do not fit in 8 bits")),It[F+q]=Q}else It.set(p,F);return u!==null&&u.push(Xn,A),A},argPackAdvance:ii,readValueFromPointer:Ma,destructorFunction(u){Xn(u)}})},Jh=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0,wp=(s,a)=>{G(s%2==0,"Pointer passed to UTF16ToString must be aligned to two bytes!");for(var c=s>>1,u=c+a/2,p=c;!(p>=u)&&rn[p];)++p;if(p-c>16&&Jh)return Jh.decode(rn.subarray(c,p));for(var v="",E=c;!(E>=u);++E){var A=rn[E];if(A==0)break;v+=String.fromCharCode(A)}return v},Ep=(s,a,c)=>{if(G(a%2==0,"Pointer passed to stringToUTF16 must be aligned to two bytes!"),G(typeof c=="number","stringToUTF16(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),c??=2147483647,c<2)return 0;c-=2;for(var u=a,p=c<s.length*2?c/2:s.length,v=0;v<p;++v){var E=s.charCodeAt(v);Mt[a>>1]=E,a+=2}return Mt[a>>1]=0,a-u},Tp=s=>s.length*2,Ap=(s,a)=>{G(s%4==0,"Pointer passed to UTF32ToString must be aligned to four bytes!");for(var c="",u=0;!(u>=a/4);u++){var p=De[s+u*4>>2];if(!p)break;c+=String.fromCodePoint(p)}return c},Cp=(s,a,c)=>{if(G(a%4==0,"Pointer passed to stringToUTF32 must be aligned to four bytes!"),G(typeof c=="number","stringToUTF32(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),c??=2147483647,c<4)return 0;for(var u=a,p=u+c-4,v=0;v<s.length;++v){var E=s.codePointAt(v);if(E>65535&&v++,De[a>>2]=E,a+=4,a+4>p)break}return De[a>>2]=0,a-u},Rp=s=>{for(var a=0,c=0;c<s.length;++c){var u=s.codePointAt(c);u>65535&&c++,a+=4}return a},Pp=(s,a,c)=>{c=Zt(c);var u,p,v,E;a===2?(u=wp,p=Ep,E=Tp,v=A=>rn[A>>1]):a===4&&(u=Ap,p=Cp,E=Rp,v=A=>qe[A>>2]),On(s,{name:c,fromWireType:A=>{for(var F=qe[A>>2],q,Q=A+4,oe=0;oe<=F;++oe){var fe=A+4+oe*a;if(oe==F||v(fe)==0){var ce=fe-Q,me=u(Q,ce);q===void 0?q=me:(q+="\0",q+=me),Q=fe+a}}return Xn(A),q},toWireType:(A,F)=>{typeof F!="string"&&xt(`Cannot pass non-string to C++ string type ${c}`);var q=E(F),Q=ec(4+q+a);return qe[Q>>2]=q/a,p(F,Q+4,q+a),A!==null&&A.push(Xn,Q),Q},argPackAdvance:ii,readValueFromPointer:Ma,destructorFunction(A){Xn(A)}})},Ip=(s,a)=>{Zh(s)},Dp=(s,a)=>{a=Zt(a),On(s,{isVoid:!0,name:a,argPackAdvance:0,fromWireType:()=>{},toWireType:(c,u)=>{}})},Lp=()=>{throw new ge},Zl=(s,a,c)=>{var u=[],p=s.toWireType(u,c);return u.length&&(qe[a>>2]=Jt.toHandle(u)),p},Fp=(s,a,c)=>(s=Jt.toValue(s),a=Ca(a,"emval::as"),Zl(a,c,s)),Ra=[],Np=(s,a,c,u)=>(s=Ra[s],a=Jt.toValue(a),s(null,a,c,u)),Up={},Jl=s=>{var a=Up[s];return a===void 0?Zt(s):a},Op=(s,a,c,u,p)=>(s=Ra[s],a=Jt.toValue(a),c=Jl(c),s(a,a[c],u,p)),Kh=()=>globalThis,Bp=s=>s===0?Jt.toHandle(Kh()):(s=Jl(s),Jt.toHandle(Kh()[s])),kp=s=>{var a=Ra.length;return Ra.push(s),a},zp=(s,a)=>{for(var c=new Array(s),u=0;u<s;++u)c[u]=Ca(qe[a+u*4>>2],`parameter ${u}`);return c},Gp=(s,a,c)=>{var u=zp(s,a),p=u.shift();s--;var v=`return function (obj, func, destructorsRef, args) {
`,E=0,A=[];c===0&&A.push("obj");for(var F=["retType"],q=[p],Q=0;Q<s;++Q)A.push(`arg${Q}`),F.push(`argType${Q}`),q.push(u[Q]),v+=`  var arg${Q} = argType${Q}.readValueFromPointer(args${E?"+"+E:""});
`,E+=u[Q].argPackAdvance;var oe=c===1?"new func":"func.call";v+=`  var rv = ${oe}(${A.join(", ")});
`,p.isVoid||(F.push("emval_returnValue"),q.push(Zl),v+=`  return emval_returnValue(retType, destructorsRef, rv);
`),v+=`};
`;var fe=(me,Ye,vt,st)=>{for(var bt=c===0?[me]:[],tt=0;tt<s;++tt)bt.push(u[tt].readValueFromPointer(st)),st+=u[tt].argPackAdvance;var $t=c===1?new Ye(...bt):Ye.call(...bt);if(!p.isVoid)return Zl(p,vt,$t)},ce=`methodCaller<(${u.map(me=>me.name).join(", ")}) => ${p.name}>`;return kp(xa(ce,fe))},Vp=(s,a)=>(s=Jt.toValue(s),a=Jt.toValue(a),Jt.toHandle(s[a])),Hp=s=>{s>9&&(si[s+1]+=1)},Wp=s=>(s=Jt.toValue(s),typeof s=="number"),Xp=s=>(s=Jt.toValue(s),typeof s=="string"),qp=()=>Jt.toHandle([]),$p=s=>Jt.toHandle(Jl(s)),Yp=s=>{var a=Jt.toValue(s);Ea(a),jl(s)},jp=(s,a)=>{s=Ca(s,"_emval_take_value");var c=s.readValueFromPointer(a);return Jt.toHandle(c)},Zp=s=>{throw s=Jt.toValue(s),s},Jp=s=>s%4===0&&(s%100!==0||s%400===0),Kp=[0,31,60,91,121,152,182,213,244,274,305,335],Qp=[0,31,59,90,120,151,181,212,243,273,304,334],Qh=s=>{var a=Jp(s.getFullYear()),c=a?Kp:Qp,u=c[s.getMonth()]+s.getDate()-1;return u},em=9007199254740992,tm=-9007199254740992,Kl=s=>s<tm||s>em?NaN:Number(s);function nm(s,a){s=Kl(s);var c=new Date(s*1e3);De[a>>2]=c.getSeconds(),De[a+4>>2]=c.getMinutes(),De[a+8>>2]=c.getHours(),De[a+12>>2]=c.getDate(),De[a+16>>2]=c.getMonth(),De[a+20>>2]=c.getFullYear()-1900,De[a+24>>2]=c.getDay();var u=Qh(c)|0;De[a+28>>2]=u,De[a+36>>2]=-(c.getTimezoneOffset()*60);var p=new Date(c.getFullYear(),0,1),v=new Date(c.getFullYear(),6,1).getTimezoneOffset(),E=p.getTimezoneOffset(),A=(v!=E&&c.getTimezoneOffset()==Math.min(E,v))|0;De[a+32>>2]=A}var im=function(s){var a=(()=>{var c=new Date(De[s+20>>2]+1900,De[s+16>>2],De[s+12>>2],De[s+8>>2],De[s+4>>2],De[s>>2],0),u=De[s+32>>2],p=c.getTimezoneOffset(),v=new Date(c.getFullYear(),0,1),E=new Date(c.getFullYear(),6,1).getTimezoneOffset(),A=v.getTimezoneOffset(),F=Math.min(A,E);if(u<0)De[s+32>>2]=+(E!=A&&F==p);else if(u>0!=(F==p)){var q=Math.max(A,E),Q=u>0?F:q;c.setTime(c.getTime()+(Q-p)*6e4)}De[s+24>>2]=c.getDay();var oe=Qh(c)|0;De[s+28>>2]=oe,De[s>>2]=c.getSeconds(),De[s+4>>2]=c.getMinutes(),De[s+8>>2]=c.getHours(),De[s+12>>2]=c.getDate(),De[s+16>>2]=c.getMonth(),De[s+20>>2]=c.getYear();var fe=c.getTime();return isNaN(fe)?-1:fe/1e3})();return BigInt(a)},rm=(s,a,c,u)=>{var p=new Date().getFullYear(),v=new Date(p,0,1),E=new Date(p,6,1),A=v.getTimezoneOffset(),F=E.getTimezoneOffset(),q=Math.max(A,F);qe[s>>2]=q*60,De[a>>2]=+(A!=F);var Q=ce=>{var me=ce>=0?"-":"+",Ye=Math.abs(ce),vt=String(Math.floor(Ye/60)).padStart(2,"0"),st=String(Ye%60).padStart(2,"0");return`UTC${me}${vt}${st}`},oe=Q(A),fe=Q(F);G(oe),G(fe),G(Ge(oe)<=16,`timezone name truncated to fit in TZNAME_MAX (${oe})`),G(Ge(fe)<=16,`timezone name truncated to fit in TZNAME_MAX (${fe})`),F<A?(ir(oe,c,17),ir(fe,u,17)):(ir(oe,u,17),ir(fe,c,17))},eu=()=>performance.now(),tu=()=>Date.now(),sm=1,am=s=>s>=0&&s<=3;function om(s,a,c){if(a=Kl(a),!am(s))return 28;var u;if(s===0)u=tu();else if(sm)u=eu();else return 52;var p=Math.round(u*1e3*1e3);return W[c>>3]=BigInt(p),0}var Pa=[],lm=(s,a)=>{G(Array.isArray(Pa)),G(a%16==0),Pa.length=0;for(var c;c=It[s++];){var u=String.fromCharCode(c),p=["d","f","i","p"];p.push("j"),G(p.includes(u),`Invalid character ${c}("${u}") in readEmAsmArgs! Use only [${p}], and do not specify "v" for void return argument.`);var v=c!=105;v&=c!=112,a+=v&&a%8?4:0,Pa.push(c==112?qe[a>>2]:c==106?W[a>>3]:c==105?De[a>>2]:sn[a>>3]),a+=v?8:4}return Pa},cm=(s,a,c)=>{var u=lm(a,c);return G(ou.hasOwnProperty(s),`No EM_ASM constant found at address ${s}.  The loaded WebAssembly file is likely out of sync with the generated JavaScript.`),ou[s](...u)},hm=(s,a,c)=>cm(s,a,c),nu=()=>2147483648,um=()=>nu(),dm=(s,a)=>(G(a,"alignment argument is required"),Math.ceil(s/a)*a),fm=s=>{var a=Ht.buffer,c=(s-a.byteLength+65535)/65536|0;try{return Ht.grow(c),Ut(),1}catch(u){I(`growMemory: Attempted to grow heap from ${a.byteLength} bytes to ${s} bytes, but got error: ${u}`)}},pm=s=>{var a=It.length;s>>>=0,G(s>a);var c=nu();if(s>c)return I(`Cannot enlarge memory, requested ${s} bytes, but the limit is ${c} bytes!`),!1;for(var u=1;u<=4;u*=2){var p=a*(1+.2/u);p=Math.min(p,s+100663296);var v=Math.min(c,dm(Math.max(s,p),65536)),E=fm(v);if(E)return!0}return I(`Failed to grow the heap from ${a} bytes to ${v} bytes, not enough memory!`),!1},Ql={},mm=()=>d||"./this.program",ls=()=>{if(!ls.strings){var s=(typeof navigator=="object"&&navigator.language||"C").replace("-","_")+".UTF-8",a={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:s,_:mm()};for(var c in Ql)Ql[c]===void 0?delete a[c]:a[c]=Ql[c];var u=[];for(var c in a)u.push(`${c}=${a[c]}`);ls.strings=u}return ls.strings},gm=(s,a)=>{var c=0,u=0;for(var p of ls()){var v=a+c;qe[s+u>>2]=v,c+=ir(p,v,1/0)+1,u+=4}return 0},_m=(s,a)=>{var c=ls();qe[s>>2]=c.length;var u=0;for(var p of c)u+=Ge(p)+1;return qe[a>>2]=u,0},iu=0,ru=()=>Tt||iu>0,vm=s=>{ie=s,ru()||(t.onExit?.(s),z=!0),m(s,new Ae(s))},ym=(s,a)=>{if(ie=s,L_(),ru()&&!a){var c=`program exited (with status: ${s}), but keepRuntimeAlive() is set (counter=${iu}) due to an async operation, so halting execution but not exiting the runtime or preventing further async execution (you can use emscripten_force_exit, if you want to force a true shutdown)`;mt?.(c),I(c)}vm(s)},xm=ym;function Sm(s){try{var a=ft.getStreamFromFD(s);return b.close(a),0}catch(c){if(typeof b>"u"||c.name!=="ErrnoError")throw c;return c.errno}}var Mm=(s,a,c,u)=>{for(var p=0,v=0;v<c;v++){var E=qe[a>>2],A=qe[a+4>>2];a+=8;var F=b.read(s,pt,E,A,u);if(F<0)return-1;if(p+=F,F<A)break;typeof u<"u"&&(u+=F)}return p};function bm(s,a,c,u){try{var p=ft.getStreamFromFD(s),v=Mm(p,a,c);return qe[u>>2]=v,0}catch(E){if(typeof b>"u"||E.name!=="ErrnoError")throw E;return E.errno}}function wm(s,a,c,u){a=Kl(a);try{if(isNaN(a))return 61;var p=ft.getStreamFromFD(s);return b.llseek(p,a,c),W[u>>3]=BigInt(p.position),p.getdents&&a===0&&c===0&&(p.getdents=null),0}catch(v){if(typeof b>"u"||v.name!=="ErrnoError")throw v;return v.errno}}var Em=(s,a,c,u)=>{for(var p=0,v=0;v<c;v++){var E=qe[a>>2],A=qe[a+4>>2];a+=8;var F=b.write(s,pt,E,A,u);if(F<0)return-1;if(p+=F,F<A)break;typeof u<"u"&&(u+=F)}return p};function Tm(s,a,c,u){try{var p=ft.getStreamFromFD(s),v=Em(p,a,c);return qe[u>>2]=v,0}catch(E){if(typeof b>"u"||E.name!=="ErrnoError")throw E;return E.errno}}var Am=s=>s,Cm=s=>{var a=t["_"+s];return G(a,"Cannot call unknown function "+s+", make sure it is exported"),a},Rm=(s,a)=>{G(s.length>=0,"writeArrayToMemory array must have a length (should be an array or typed array)"),pt.set(s,a)},Ia=s=>fu(s),Pm=s=>{var a=Ge(s)+1,c=Ia(a);return ir(s,c,a),c},su=(s,a,c,u,p)=>{var v={string:me=>{var Ye=0;return me!=null&&me!==0&&(Ye=Pm(me)),Ye},array:me=>{var Ye=Ia(me.length);return Rm(me,Ye),Ye}};function E(me){return a==="string"?un(me):a==="boolean"?!!me:me}var A=Cm(s),F=[],q=0;if(G(a!=="array",'Return type should not be "array".'),u)for(var Q=0;Q<u.length;Q++){var oe=v[c[Q]];oe?(q===0&&(q=_e()),F[Q]=oe(u[Q])):F[Q]=u[Q]}var fe=A(...F);function ce(me){return q!==0&&ye(q),E(me)}return fe=ce(fe),fe},Im=(s,a,c,u)=>(...p)=>su(s,a,c,p,u),Dm=(...s)=>b.createPath(...s),Lm=(...s)=>b.unlink(...s),Fm=(...s)=>b.createLazyFile(...s),Nm=(...s)=>b.createDevice(...s),Um=s=>Da(s),Om=s=>ic(s),Bm=s=>{var a=_e(),c=Ia(4),u=Ia(4);mu(s,c,u);var p=qe[c>>2],v=qe[u>>2],E=un(p);Xn(p);var A;return v&&(A=un(v),Xn(v)),ye(a),[E,A]},au=s=>Bm(s);b.createPreloadedFile=ei,b.staticInit(),Zf(),rp(),G(si.length===10),t.noExitRuntime&&(Tt=t.noExitRuntime),t.preloadPlugins&&(an=t.preloadPlugins),t.print&&(U=t.print),t.printErr&&(I=t.printErr),t.wasmBinary&&(ee=t.wasmBinary),Gm(),t.arguments&&(f=t.arguments),t.thisProgram&&(d=t.thisProgram),G(typeof t.memoryInitializerPrefixURL>"u","Module.memoryInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.pthreadMainPrefixURL>"u","Module.pthreadMainPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.cdInitializerPrefixURL>"u","Module.cdInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.filePackagePrefixURL>"u","Module.filePackagePrefixURL option was removed, use Module.locateFile instead"),G(typeof t.read>"u","Module.read option was removed"),G(typeof t.readAsync>"u","Module.readAsync option was removed (modify readAsync in JS)"),G(typeof t.readBinary>"u","Module.readBinary option was removed (modify readBinary in JS)"),G(typeof t.setWindowTitle>"u","Module.setWindowTitle option was removed (modify emscripten_set_window_title in JS)"),G(typeof t.TOTAL_MEMORY>"u","Module.TOTAL_MEMORY has been renamed Module.INITIAL_MEMORY"),G(typeof t.ENVIRONMENT>"u","Module.ENVIRONMENT has been deprecated. To force the environment, use the ENVIRONMENT compile-time option (for example, -sENVIRONMENT=web or -sENVIRONMENT=node)"),G(typeof t.STACK_SIZE>"u","STACK_SIZE can no longer be set at runtime.  Use -sSTACK_SIZE at link time"),G(typeof t.wasmMemory>"u","Use of `wasmMemory` detected.  Use -sIMPORTED_MEMORY to define wasmMemory externally"),G(typeof t.INITIAL_MEMORY>"u","Detected runtime INITIAL_MEMORY setting.  Use -sIMPORTED_MEMORY to define wasmMemory dynamically"),t.addRunDependency=ve,t.removeRunDependency=de,t.ccall=su,t.cwrap=Im,t.FS_createPreloadedFile=ei,t.FS_unlink=Lm,t.FS_createPath=Dm,t.FS_createDevice=Nm,t.FS=b,t.FS_createDataFile=jt,t.FS_createLazyFile=Fm,t.MEMFS=ke;var km=["writeI53ToI64","writeI53ToI64Clamped","writeI53ToI64Signaling","writeI53ToU64Clamped","writeI53ToU64Signaling","readI53FromI64","readI53FromU64","convertI32PairToI53","convertI32PairToI53Checked","convertU32PairToI53","getTempRet0","zeroMemory","withStackSave","inetPton4","inetNtop4","inetPton6","inetNtop6","readSockaddr","writeSockaddr","emscriptenLog","runMainThreadEmAsm","jstoi_q","autoResumeAudioContext","getDynCaller","dynCall","handleException","runtimeKeepalivePush","runtimeKeepalivePop","callUserCallback","maybeExit","asmjsMangle","HandleAllocator","getNativeTypeSize","addOnInit","addOnPostCtor","addOnPreMain","addOnExit","STACK_SIZE","STACK_ALIGN","POINTER_SIZE","ASSERTIONS","uleb128Encode","sigToWasmTypes","generateFuncType","convertJsFunctionToWasm","getEmptyTableSlot","updateTableMap","getFunctionAddress","addFunction","removeFunction","reallyNegative","unSign","strLen","reSign","formatString","intArrayToString","stringToAscii","stringToNewUTF8","registerKeyEventCallback","maybeCStringToJsString","findEventTarget","getBoundingClientRect","fillMouseEventData","registerMouseEventCallback","registerWheelEventCallback","registerUiEventCallback","registerFocusEventCallback","fillDeviceOrientationEventData","registerDeviceOrientationEventCallback","fillDeviceMotionEventData","registerDeviceMotionEventCallback","screenOrientation","fillOrientationChangeEventData","registerOrientationChangeEventCallback","fillFullscreenChangeEventData","registerFullscreenChangeEventCallback","JSEvents_requestFullscreen","JSEvents_resizeCanvasForFullscreen","registerRestoreOldStyle","hideEverythingExceptGivenElement","restoreHiddenElements","setLetterbox","softFullscreenResizeWebGLRenderTarget","doRequestFullscreen","fillPointerlockChangeEventData","registerPointerlockChangeEventCallback","registerPointerlockErrorEventCallback","requestPointerLock","fillVisibilityChangeEventData","registerVisibilityChangeEventCallback","registerTouchEventCallback","fillGamepadEventData","registerGamepadEventCallback","registerBeforeUnloadEventCallback","fillBatteryEventData","battery","registerBatteryEventCallback","setCanvasElementSize","getCanvasElementSize","jsStackTrace","getCallstack","convertPCtoSourceLocation","wasiRightsToMuslOFlags","wasiOFlagsToMuslOFlags","safeSetTimeout","setImmediateWrapped","safeRequestAnimationFrame","clearImmediateWrapped","registerPostMainLoop","registerPreMainLoop","getPromise","makePromise","idsToPromises","makePromiseCallback","Browser_asyncPrepareDataCounter","arraySum","addDays","getSocketFromFD","getSocketAddress","FS_mkdirTree","_setNetworkCallback","heapObjectForWebGLType","toTypedArrayIndex","webgl_enable_ANGLE_instanced_arrays","webgl_enable_OES_vertex_array_object","webgl_enable_WEBGL_draw_buffers","webgl_enable_WEBGL_multi_draw","webgl_enable_EXT_polygon_offset_clamp","webgl_enable_EXT_clip_control","webgl_enable_WEBGL_polygon_mode","emscriptenWebGLGet","computeUnpackAlignedImageSize","colorChannelsInGlTextureFormat","emscriptenWebGLGetTexPixelData","emscriptenWebGLGetUniform","webglGetUniformLocation","webglPrepareUniformLocationsBeforeFirstUse","webglGetLeftBracePos","emscriptenWebGLGetVertexAttrib","__glGetActiveAttribOrUniform","writeGLArray","registerWebGlEventCallback","runAndAbortIfError","ALLOC_NORMAL","ALLOC_STACK","allocate","writeStringToMemory","writeAsciiToMemory","demangle","stackTrace","getFunctionArgsName","createJsInvokerSignature","PureVirtualError","registerInheritedInstance","unregisterInheritedInstance","getInheritedInstanceCount","getLiveInheritedInstances","setDelayFunction","count_emval_handles"];km.forEach(Ke);var zm=["run","out","err","callMain","abort","wasmMemory","wasmExports","HEAPF32","HEAPF64","HEAP8","HEAPU8","HEAP16","HEAPU16","HEAP32","HEAPU32","HEAP64","HEAPU64","writeStackCookie","checkStackCookie","INT53_MAX","INT53_MIN","bigintToI53Checked","stackSave","stackRestore","stackAlloc","setTempRet0","ptrToString","exitJS","getHeapMax","growMemory","ENV","ERRNO_CODES","strError","DNS","Protocols","Sockets","timers","warnOnce","readEmAsmArgsArray","readEmAsmArgs","runEmAsmFunction","getExecutableName","keepRuntimeAlive","asyncLoad","alignMemory","mmapAlloc","wasmTable","getUniqueRunDependency","noExitRuntime","addOnPreRun","addOnPostRun","freeTableIndexes","functionsInTableMap","setValue","getValue","PATH","PATH_FS","UTF8Decoder","UTF8ArrayToString","UTF8ToString","stringToUTF8Array","stringToUTF8","lengthBytesUTF8","intArrayFromString","AsciiToString","UTF16Decoder","UTF16ToString","stringToUTF16","lengthBytesUTF16","UTF32ToString","stringToUTF32","lengthBytesUTF32","stringToUTF8OnStack","writeArrayToMemory","JSEvents","specialHTMLTargets","findCanvasEventTarget","currentFullscreenStrategy","restoreOldWindowedStyle","UNWIND_CACHE","ExitStatus","getEnvStrings","checkWasiClock","doReadv","doWritev","initRandomFill","randomFill","emSetImmediate","emClearImmediate_deps","emClearImmediate","promiseMap","uncaughtExceptionCount","exceptionLast","exceptionCaught","ExceptionInfo","findMatchingCatch","getExceptionMessageCommon","Browser","requestFullscreen","requestFullScreen","setCanvasSize","getUserMedia","createContext","getPreloadedImageData__data","wget","MONTH_DAYS_REGULAR","MONTH_DAYS_LEAP","MONTH_DAYS_REGULAR_CUMULATIVE","MONTH_DAYS_LEAP_CUMULATIVE","isLeapYear","ydayFromDate","SYSCALLS","preloadPlugins","FS_modeStringToFlags","FS_getMode","FS_stdin_getChar_buffer","FS_stdin_getChar","FS_readFile","FS_root","FS_mounts","FS_devices","FS_streams","FS_nextInode","FS_nameTable","FS_currentPath","FS_initialized","FS_ignorePermissions","FS_filesystems","FS_syncFSRequests","FS_readFiles","FS_lookupPath","FS_getPath","FS_hashName","FS_hashAddNode","FS_hashRemoveNode","FS_lookupNode","FS_createNode","FS_destroyNode","FS_isRoot","FS_isMountpoint","FS_isFile","FS_isDir","FS_isLink","FS_isChrdev","FS_isBlkdev","FS_isFIFO","FS_isSocket","FS_flagsToPermissionString","FS_nodePermissions","FS_mayLookup","FS_mayCreate","FS_mayDelete","FS_mayOpen","FS_checkOpExists","FS_nextfd","FS_getStreamChecked","FS_getStream","FS_createStream","FS_closeStream","FS_dupStream","FS_doSetAttr","FS_chrdev_stream_ops","FS_major","FS_minor","FS_makedev","FS_registerDevice","FS_getDevice","FS_getMounts","FS_syncfs","FS_mount","FS_unmount","FS_lookup","FS_mknod","FS_statfs","FS_statfsStream","FS_statfsNode","FS_create","FS_mkdir","FS_mkdev","FS_symlink","FS_rename","FS_rmdir","FS_readdir","FS_readlink","FS_stat","FS_fstat","FS_lstat","FS_doChmod","FS_chmod","FS_lchmod","FS_fchmod","FS_doChown","FS_chown","FS_lchown","FS_fchown","FS_doTruncate","FS_truncate","FS_ftruncate","FS_utime","FS_open","FS_close","FS_isClosed","FS_llseek","FS_read","FS_write","FS_mmap","FS_msync","FS_ioctl","FS_writeFile","FS_cwd","FS_chdir","FS_createDefaultDirectories","FS_createDefaultDevices","FS_createSpecialDirectories","FS_createStandardStreams","FS_staticInit","FS_init","FS_quit","FS_findObject","FS_analyzePath","FS_createFile","FS_forceLoadFile","FS_absolutePath","FS_createFolder","FS_createLink","FS_joinPath","FS_mmapAlloc","FS_standardizePath","TTY","PIPEFS","SOCKFS","tempFixedLengthArray","miniTempWebGLFloatBuffers","miniTempWebGLIntBuffers","GL","AL","GLUT","EGL","GLEW","IDBStore","SDL","SDL_gfx","allocateUTF8","allocateUTF8OnStack","print","printErr","jstoi_s","InternalError","BindingError","throwInternalError","throwBindingError","registeredTypes","awaitingDependencies","typeDependencies","tupleRegistrations","structRegistrations","sharedRegisterType","whenDependentTypesAreResolved","getTypeName","getFunctionName","heap32VectorToArray","requireRegisteredType","usesDestructorStack","checkArgCount","getRequiredArgCount","createJsInvoker","UnboundTypeError","GenericWireTypeSize","EmValType","EmValOptionalType","throwUnboundTypeError","ensureOverloadTable","exposePublicSymbol","replacePublicSymbol","createNamedFunction","embindRepr","registeredInstances","getBasestPointer","getInheritedInstance","registeredPointers","registerType","integerReadValueFromPointer","enumReadValueFromPointer","floatReadValueFromPointer","assertIntegerRange","readPointer","runDestructors","craftInvokerFunction","embind__requireFunction","genericPointerToWireType","constNoSmartPtrRawPointerToWireType","nonConstNoSmartPtrRawPointerToWireType","init_RegisteredPointer","RegisteredPointer","RegisteredPointer_fromWireType","runDestructor","releaseClassHandle","finalizationRegistry","detachFinalizer_deps","detachFinalizer","attachFinalizer","makeClassHandle","init_ClassHandle","ClassHandle","throwInstanceAlreadyDeleted","deletionQueue","flushPendingDeletes","delayFunction","RegisteredClass","shallowCopyInternalPointer","downcastPointer","upcastPointer","validateThis","char_0","char_9","makeLegalFunctionName","emval_freelist","emval_handles","emval_symbols","getStringOrSymbol","Emval","emval_get_global","emval_returnValue","emval_lookupTypes","emval_methodCallers","emval_addMethodCaller"];zm.forEach(Et),t.incrementExceptionRefcount=Um,t.decrementExceptionRefcount=Om,t.getExceptionMessage=au;function Gm(){je("fetchSettings")}var ou={679512:()=>{typeof t<"u"&&"mjDISABLESTRING mjENABLESTRING mjFRAMESTRING mjLABELSTRING mjRNDSTRING mjTIMERSTRING mjVISSTRING".split(" ").forEach(function(s){Object.defineProperty(t,s,{get:function(){return t["get_"+s]()},set:function(a){},enumerable:!0,configurable:!0})})}},lu=Pe("___getTypeName"),ec=Pe("_malloc"),Vm=Pe("___cxa_free_exception"),tc=Pe("_fflush"),Xn=Pe("_free"),nc=Pe("_emscripten_stack_get_end"),Hm=Pe("_emscripten_stack_get_base"),cu=Pe("_strerror"),xe=Pe("_setThrew"),hu=Pe("__emscripten_tempret_set"),uu=Pe("_emscripten_stack_init"),Wm=Pe("_emscripten_stack_get_free"),du=Pe("__emscripten_stack_restore"),fu=Pe("__emscripten_stack_alloc"),pu=Pe("_emscripten_stack_get_current"),ic=Pe("___cxa_decrement_exception_refcount"),Da=Pe("___cxa_increment_exception_refcount"),mu=Pe("___get_exception_message"),gu=Pe("___cxa_can_catch"),_u=Pe("___cxa_get_exception_ptr");function Xm(s){lu=Me("__getTypeName",1),ec=Me("malloc",1),Vm=Me("__cxa_free_exception",1),tc=Me("fflush",1),Xn=Me("free",1),nc=s.emscripten_stack_get_end,Hm=s.emscripten_stack_get_base,cu=Me("strerror",1),xe=Me("setThrew",2),hu=Me("_emscripten_tempret_set",1),uu=s.emscripten_stack_init,Wm=s.emscripten_stack_get_free,du=s._emscripten_stack_restore,fu=s._emscripten_stack_alloc,pu=s.emscripten_stack_get_current,ic=Me("__cxa_decrement_exception_refcount",1),Da=Me("__cxa_increment_exception_refcount",1),mu=Me("__get_exception_message",3),gu=Me("__cxa_can_catch",3),_u=Me("__cxa_get_exception_ptr",1)}var vu={__assert_fail:rs,__cxa_begin_catch:_r,__cxa_current_primary_exception:fa,__cxa_end_catch:Ki,__cxa_find_matching_catch_2:Gl,__cxa_find_matching_catch_3:Vl,__cxa_find_matching_catch_4:Hl,__cxa_rethrow:ss,__cxa_rethrow_primary_exception:C,__cxa_throw:V,__cxa_uncaught_exceptions:te,__resumeException:K,__syscall_dup3:Cn,__syscall_fcntl64:Hn,__syscall_fstat64:pa,__syscall_ioctl:Ff,__syscall_lstat64:Nf,__syscall_newfstatat:Uf,__syscall_openat:Of,__syscall_stat64:Bf,_abort_js:kf,_embind_register_bigint:Gf,_embind_register_bool:Vf,_embind_register_class:ap,_embind_register_class_class_function:lp,_embind_register_class_constructor:cp,_embind_register_class_function:hp,_embind_register_class_property:up,_embind_register_constant:dp,_embind_register_emval:Zh,_embind_register_enum:pp,_embind_register_enum_value:mp,_embind_register_float:_p,_embind_register_function:vp,_embind_register_integer:yp,_embind_register_memory_view:xp,_embind_register_optional:Mp,_embind_register_std_string:bp,_embind_register_std_wstring:Pp,_embind_register_user_type:Ip,_embind_register_void:Dp,_emscripten_throw_longjmp:Lp,_emval_as:Fp,_emval_call:Np,_emval_call_method:Op,_emval_decref:jl,_emval_get_global:Bp,_emval_get_method_caller:Gp,_emval_get_property:Vp,_emval_incref:Hp,_emval_is_number:Wp,_emval_is_string:Xp,_emval_new_array:qp,_emval_new_cstring:$p,_emval_run_destructors:Yp,_emval_take_value:jp,_emval_throw:Zp,_localtime_js:nm,_mktime_js:im,_tzset_js:rm,clock_time_get:om,emscripten_asm_const_int:hm,emscripten_date_now:tu,emscripten_get_heap_max:um,emscripten_get_now:eu,emscripten_resize_heap:pm,environ_get:gm,environ_sizes_get:_m,exit:xm,fd_close:Sm,fd_read:bm,fd_seek:wm,fd_write:Tm,invoke_ddd:v_,invoke_dddi:Ng,invoke_dddidi:Ug,invoke_ddidi:Fg,invoke_di:Og,invoke_dii:Eg,invoke_diii:sg,invoke_diiii:Lg,invoke_diiiidd:Ig,invoke_diiiidi:lg,invoke_diiiii:eg,invoke_diiiiii:pg,invoke_diiiiiii:Bg,invoke_diiiiiiiii:dg,invoke_diiiiiiiiiiii:fg,invoke_fiii:R_,invoke_i:tg,invoke_id:i_,invoke_ii:Ym,invoke_iid:Yg,invoke_iidddd:b_,invoke_iidiii:Mg,invoke_iidiiid:xg,invoke_iidiiiiidi:bg,invoke_iif:M_,invoke_iii:qm,invoke_iiid:wg,invoke_iiididdddddd:Sg,invoke_iiidiiiiiiii:yg,invoke_iiii:Jm,invoke_iiiidddiiiii:zg,invoke_iiiii:rg,invoke_iiiiid:s_,invoke_iiiiii:Qg,invoke_iiiiiii:Zg,invoke_iiiiiiii:$g,invoke_iiiiiiiidd:a_,invoke_iiiiiiiii:Pg,invoke_iiiiiiiiii:Jg,invoke_iiiiiiiiiidddiiiiiiiii:vg,invoke_iiiiiiiiiii:C_,invoke_iiiiiiiiiiii:P_,invoke_iiiiiiiiiiiii:u_,invoke_iiij:Kg,invoke_iiji:r_,invoke_j:T_,invoke_ji:g_,invoke_jiiii:e_,invoke_jij:__,invoke_v:Zm,invoke_vi:jm,invoke_vid:jg,invoke_viddd:t_,invoke_vidddd:n_,invoke_vidi:Dg,invoke_vidiii:gg,invoke_vii:Qm,invoke_viid:Cg,invoke_viiddi:h_,invoke_viiddidi:c_,invoke_viiddii:kg,invoke_viidi:Ag,invoke_viidii:og,invoke_viidiii:Xg,invoke_viidiiid:Hg,invoke_viidiiiii:_g,invoke_viidiiiiidi:qg,invoke_viidiiiiiiii:mg,invoke_viii:$m,invoke_viiid:hg,invoke_viiidd:l_,invoke_viiidi:Tg,invoke_viiididdddddd:Wg,invoke_viiidiiiiiiii:Vg,invoke_viiii:ig,invoke_viiiiddd:o_,invoke_viiiidi:y_,invoke_viiiifi:x_,invoke_viiiii:Km,invoke_viiiiid:cg,invoke_viiiiii:ng,invoke_viiiiiii:ag,invoke_viiiiiiii:Rg,invoke_viiiiiiiiii:p_,invoke_viiiiiiiiiidddiiiiiiiii:Gg,invoke_viiiiiiiiiiid:ug,invoke_viiiiiiiiiiiii:f_,invoke_viiiiiiiiiiiiiii:I_,invoke_viiiiiiiiiiiiiiiiii:m_,invoke_viiiij:w_,invoke_viij:E_,invoke_viijii:A_,invoke_vij:S_,invoke_vijjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjj:d_,llvm_eh_typeid_for:Am},rr=await Ee();function qm(s,a,c){var u=_e();try{return be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function $m(s,a,c,u){var p=_e();try{be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function Ym(s,a){var c=_e();try{return be(s)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function jm(s,a){var c=_e();try{be(s)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Zm(s){var a=_e();try{be(s)()}catch(c){if(ye(a),!(c instanceof H))throw c;xe(1,0)}}function Jm(s,a,c,u){var p=_e();try{return be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function Km(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function Qm(s,a,c){var u=_e();try{be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function eg(s,a,c,u,p,v){var E=_e();try{return be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function tg(s){var a=_e();try{return be(s)()}catch(c){if(ye(a),!(c instanceof H))throw c;xe(1,0)}}function ng(s,a,c,u,p,v,E){var A=_e();try{be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function ig(s,a,c,u,p){var v=_e();try{be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;xe(1,0)}}function rg(s,a,c,u,p){var v=_e();try{return be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;xe(1,0)}}function sg(s,a,c,u){var p=_e();try{return be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function ag(s,a,c,u,p,v,E,A){var F=_e();try{be(s)(a,c,u,p,v,E,A)}catch(q){if(ye(F),!(q instanceof H))throw q;xe(1,0)}}function og(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function lg(s,a,c,u,p,v,E){var A=_e();try{return be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function cg(s,a,c,u,p,v,E){var A=_e();try{be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function hg(s,a,c,u,p){var v=_e();try{be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;xe(1,0)}}function ug(s,a,c,u,p,v,E,A,F,q,Q,oe,fe){var ce=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function dg(s,a,c,u,p,v,E,A,F,q){var Q=_e();try{return be(s)(a,c,u,p,v,E,A,F,q)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function fg(s,a,c,u,p,v,E,A,F,q,Q,oe,fe){var ce=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function pg(s,a,c,u,p,v,E){var A=_e();try{return be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function mg(s,a,c,u,p,v,E,A,F,q,Q,oe){var fe=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function gg(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function _g(s,a,c,u,p,v,E,A,F){var q=_e();try{be(s)(a,c,u,p,v,E,A,F)}catch(Q){if(ye(q),!(Q instanceof H))throw Q;xe(1,0)}}function vg(s,a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,$t,Kt){var xn=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,$t,Kt)}catch(Nt){if(ye(xn),!(Nt instanceof H))throw Nt;xe(1,0)}}function yg(s,a,c,u,p,v,E,A,F,q,Q,oe){var fe=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function xg(s,a,c,u,p,v,E){var A=_e();try{return be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Sg(s,a,c,u,p,v,E,A,F,q,Q,oe){var fe=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function Mg(s,a,c,u,p,v){var E=_e();try{return be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function bg(s,a,c,u,p,v,E,A,F,q){var Q=_e();try{return be(s)(a,c,u,p,v,E,A,F,q)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function wg(s,a,c,u){var p=_e();try{return be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function Eg(s,a,c){var u=_e();try{return be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Tg(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function Ag(s,a,c,u,p){var v=_e();try{be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;xe(1,0)}}function Cg(s,a,c,u){var p=_e();try{be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function Rg(s,a,c,u,p,v,E,A,F){var q=_e();try{be(s)(a,c,u,p,v,E,A,F)}catch(Q){if(ye(q),!(Q instanceof H))throw Q;xe(1,0)}}function Pg(s,a,c,u,p,v,E,A,F){var q=_e();try{return be(s)(a,c,u,p,v,E,A,F)}catch(Q){if(ye(q),!(Q instanceof H))throw Q;xe(1,0)}}function Ig(s,a,c,u,p,v,E){var A=_e();try{return be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Dg(s,a,c,u){var p=_e();try{be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function Lg(s,a,c,u,p){var v=_e();try{return be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;xe(1,0)}}function Fg(s,a,c,u,p){var v=_e();try{return be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;xe(1,0)}}function Ng(s,a,c,u){var p=_e();try{return be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function Ug(s,a,c,u,p,v){var E=_e();try{return be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function Og(s,a){var c=_e();try{return be(s)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function Bg(s,a,c,u,p,v,E,A){var F=_e();try{return be(s)(a,c,u,p,v,E,A)}catch(q){if(ye(F),!(q instanceof H))throw q;xe(1,0)}}function kg(s,a,c,u,p,v,E){var A=_e();try{be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function zg(s,a,c,u,p,v,E,A,F,q,Q,oe){var fe=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function Gg(s,a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,$t,Kt,xn){var Nt=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,$t,Kt,xn)}catch(sr){if(ye(Nt),!(sr instanceof H))throw sr;xe(1,0)}}function Vg(s,a,c,u,p,v,E,A,F,q,Q,oe,fe){var ce=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Hg(s,a,c,u,p,v,E,A){var F=_e();try{be(s)(a,c,u,p,v,E,A)}catch(q){if(ye(F),!(q instanceof H))throw q;xe(1,0)}}function Wg(s,a,c,u,p,v,E,A,F,q,Q,oe,fe){var ce=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Xg(s,a,c,u,p,v,E){var A=_e();try{be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function qg(s,a,c,u,p,v,E,A,F,q,Q){var oe=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function $g(s,a,c,u,p,v,E,A){var F=_e();try{return be(s)(a,c,u,p,v,E,A)}catch(q){if(ye(F),!(q instanceof H))throw q;xe(1,0)}}function Yg(s,a,c){var u=_e();try{return be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function jg(s,a,c){var u=_e();try{be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function Zg(s,a,c,u,p,v,E){var A=_e();try{return be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function Jg(s,a,c,u,p,v,E,A,F,q){var Q=_e();try{return be(s)(a,c,u,p,v,E,A,F,q)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function Kg(s,a,c,u){var p=_e();try{return be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function Qg(s,a,c,u,p,v){var E=_e();try{return be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function e_(s,a,c,u,p){var v=_e();try{return be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;return xe(1,0),0n}}function t_(s,a,c,u,p){var v=_e();try{be(s)(a,c,u,p)}catch(E){if(ye(v),!(E instanceof H))throw E;xe(1,0)}}function n_(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function i_(s,a){var c=_e();try{return be(s)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;xe(1,0)}}function r_(s,a,c,u){var p=_e();try{return be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function s_(s,a,c,u,p,v){var E=_e();try{return be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function a_(s,a,c,u,p,v,E,A,F,q){var Q=_e();try{return be(s)(a,c,u,p,v,E,A,F,q)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function o_(s,a,c,u,p,v,E,A){var F=_e();try{be(s)(a,c,u,p,v,E,A)}catch(q){if(ye(F),!(q instanceof H))throw q;xe(1,0)}}function l_(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function c_(s,a,c,u,p,v,E,A){var F=_e();try{be(s)(a,c,u,p,v,E,A)}catch(q){if(ye(F),!(q instanceof H))throw q;xe(1,0)}}function h_(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function u_(s,a,c,u,p,v,E,A,F,q,Q,oe,fe){var ce=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function d_(s,a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,$t,Kt,xn,Nt,sr,N_,U_,O_,B_,k_,z_,G_,V_,H_,W_,X_,q_,$_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,C0,R0,P0,I0,D0,L0,F0,N0,U0,O0,B0,k0,z0,G0){var V0=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt,tt,$t,Kt,xn,Nt,sr,N_,U_,O_,B_,k_,z_,G_,V_,H_,W_,X_,q_,$_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,C0,R0,P0,I0,D0,L0,F0,N0,U0,O0,B0,k0,z0,G0)}catch(xu){if(ye(V0),!(xu instanceof H))throw xu;xe(1,0)}}function f_(s,a,c,u,p,v,E,A,F,q,Q,oe,fe,ce){var me=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe,ce)}catch(Ye){if(ye(me),!(Ye instanceof H))throw Ye;xe(1,0)}}function p_(s,a,c,u,p,v,E,A,F,q,Q){var oe=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function m_(s,a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt){var tt=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye,vt,st,bt)}catch($t){if(ye(tt),!($t instanceof H))throw $t;xe(1,0)}}function g_(s,a){var c=_e();try{return be(s)(a)}catch(u){if(ye(c),!(u instanceof H))throw u;return xe(1,0),0n}}function __(s,a,c){var u=_e();try{return be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;return xe(1,0),0n}}function v_(s,a,c){var u=_e();try{return be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function y_(s,a,c,u,p,v,E){var A=_e();try{be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function x_(s,a,c,u,p,v,E){var A=_e();try{be(s)(a,c,u,p,v,E)}catch(F){if(ye(A),!(F instanceof H))throw F;xe(1,0)}}function S_(s,a,c){var u=_e();try{be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function M_(s,a,c){var u=_e();try{return be(s)(a,c)}catch(p){if(ye(u),!(p instanceof H))throw p;xe(1,0)}}function b_(s,a,c,u,p,v){var E=_e();try{return be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function w_(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function E_(s,a,c,u){var p=_e();try{be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function T_(s){var a=_e();try{return be(s)()}catch(c){if(ye(a),!(c instanceof H))throw c;return xe(1,0),0n}}function A_(s,a,c,u,p,v){var E=_e();try{be(s)(a,c,u,p,v)}catch(A){if(ye(E),!(A instanceof H))throw A;xe(1,0)}}function C_(s,a,c,u,p,v,E,A,F,q,Q){var oe=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function R_(s,a,c,u){var p=_e();try{return be(s)(a,c,u)}catch(v){if(ye(p),!(v instanceof H))throw v;xe(1,0)}}function P_(s,a,c,u,p,v,E,A,F,q,Q,oe){var fe=_e();try{return be(s)(a,c,u,p,v,E,A,F,q,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function I_(s,a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye){var vt=_e();try{be(s)(a,c,u,p,v,E,A,F,q,Q,oe,fe,ce,me,Ye)}catch(st){if(ye(vt),!(st instanceof H))throw st;xe(1,0)}}var yu;function D_(){uu(),Se()}function rc(){if(Je>0){L=rc;return}if(D_(),Le(),Je>0){L=rc;return}function s(){G(!yu),yu=!0,t.calledRun=!0,!z&&(qt(),Ct?.(t),t.onRuntimeInitialized?.(),Fe("onRuntimeInitialized"),G(!t._main,'compiled without a main, but one is present. if you added it from JS, use Module["onRuntimeInitialized"]'),Ze())}t.setStatus?(t.setStatus("Running..."),setTimeout(()=>{setTimeout(()=>t.setStatus(""),1),s()},1)):s(),re()}function L_(){var s=U,a=I,c=!1;U=I=u=>{c=!0};try{tc(0),["stdout","stderr"].forEach(u=>{var p=b.analyzePath("/dev/"+u);if(p){var v=p.object,E=v.rdev,A=lt.ttys[E];A?.output?.length&&(c=!0)}})}catch{}U=s,I=a,c&&Qn("stdio streams had content in them that was not flushed. you should set EXIT_RUNTIME to 1 (see the Emscripten FAQ), or make sure to emit a newline when you printf etc.")}function F_(){if(t.preInit)for(typeof t.preInit=="function"&&(t.preInit=[t.preInit]);t.preInit.length>0;)t.preInit.shift()();Fe("preInit")}F_(),rc(),Rt?e=t:e=new Promise((s,a)=>{Ct=s,mt=a});for(let s of Object.keys(t))s in i||Object.defineProperty(i,s,{configurable:!0,get(){pe(`Access to module property ('${s}') is no longer possible via the module constructor argument; Instead, use the result of the module constructor.`)}});return e}),Eu=Q0;var Tu=i=>Eu({wasmBinary:i});function ev([i,e,t,n]){return[1-2*(t*t+n*n),2*(e*t-i*n),2*(e*n+i*t),2*(e*t+i*n),1-2*(e*e+n*n),2*(t*n-i*e),2*(e*n-i*t),2*(t*n+i*e),1-2*(e*e+t*t)]}var tv=([i,e,t,n])=>Math.atan2(2*(i*n+e*t),1-2*(t*t+n*n)),nv=i=>Math.abs(i%1)===.5?2*Math.round(i/2):Math.round(i),ds=class{constructor(e,t,n){this.mujoco=e,this.robot=n,this.model=e.MjModel.from_xml_string(t.xml),t.heights&&this.model.hfield_data.set(t.heights),this.data=new e.MjData(this.model),this.base=e.mj_name2id(this.model,e.mjtObj.mjOBJ_BODY.value,n.base),this.gravity=Math.hypot(...this.model.opt.gravity),this.compiled={mass:this.model.body_mass[this.base],inertia:this.model.body_inertia.slice(3*this.base,3*this.base+3)},this.play=new Float64Array(n.start.length-7),this.reset()}delete(){this.data.delete(),this.model.delete()}reset(e=this.robot.start){let{mujoco:t,model:n,data:r}=this,o=e.slice(7);if(t.mj_resetData(n,r),r.qpos.set(e),r.ctrl.set(o),this.play.set(o),n.nhistory){let{actuator_historyadr:l,actuator_history:h}=n,f=h.length/n.nu;o.forEach((d,m)=>{let y=l[m]+2+h[f*m];l[m]>=0&&r.history.fill(d,y,y+h[f*m])})}t.mj_forward(n,r),this.settled=!0}step(e){let{mujoco:t,model:n,data:r,robot:o}=this;r.ctrl.set(o.servo?this.servoTarget(e):e);for(let l=0;l<o.decimation;l++)this.settled||t.mj_step1(n,r),t.mj_step2(n,r),t.mj_step1(n,r),this.settled=!0}servoTarget(e){let{target_step:t,backlash:n,dead_band:r}=this.robot.servo,o=this.reading("joint_position");return Array.from(e,(l,h)=>{let f=t[h]>0?t[h]*nv(l/t[h]):l;this.play[h]=Math.min(Math.max(this.play[h],f-n[h]/2),f+n[h]/2);let d=this.play[h]-o[h];return this.play[h]-Math.min(Math.max(d,-r[h]),r[h])})}reading(e){return this.data.sensordata.slice(...this.robot.columns[e])}projectedGravity(){let e=ev(this.reading("orientation")),t=this.model.opt.gravity;return[0,1,2].map(n=>(e[n]*t[0]+e[3+n]*t[1]+e[6+n]*t[2])/this.gravity)}position(){return this.data.qpos.slice(0,3)}yaw(){return tv(this.data.qpos.slice(3,7))}fallen(){return!(this.projectedGravity()[2]<-.5)||this.reading("trunk_force")[0]>0||!Number.isFinite(this.data.qpos[0])}push(e){let{qvel:t}=this.data;e.forEach((n,r)=>{t[r]+=n}),this.settled=!1}setFriction(e){let{geom_friction:t}=this.model;for(let n=0;n<t.length;n+=3)t[n]=e;this.settled=!1}setPayload(e){let{mujoco:t,model:n,base:r,compiled:o}=this,l=o.mass+e;n.body_mass[r]=l,o.inertia.forEach((f,d)=>{n.body_inertia[3*r+d]=f*l/o.mass});let h=new t.MjData(n);t.mj_setConst(n,h),h.delete(),this.settled=!1}setSlope(e){this.model.opt.gravity.set([-this.gravity*Math.sin(e),0,-this.gravity*Math.cos(e)]),this.settled=!1}};var $i={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Yi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},rd=0,kc=1,sd=2;var ur=1,ad=2,Yr=3,ji=0,dn=1,fi=2,dr=0,jr=1,zc=2,Gc=3,Vc=4,od=5;var fr=100,ld=101,cd=102,hd=103,ud=104,dd=200,fd=201,pd=202,md=203,Hc=204,Wc=205,gd=206,_d=207,vd=208,yd=209,xd=210,Sd=211,Md=212,bd=213,wd=214,fo=0,po=1,mo=2,Ur=3,go=4,_o=5,vo=6,yo=7,Wo=0,Ed=1,Td=2,pi=0,Xc=1,qc=2,$c=3,Yc=4,jc=5,Zc=6,Ks=7;var Jc=300,pr=301,Zr=302,Xo=303,qo=304,Or=1e3,oi=1001,xo=1002,cn=1003,Ad=1004;var Qs=1005;var Mn=1006,$o=1007;var Ri=1008;var Tn=1009,Kc=1010,Qc=1011,Jr=1012,Yo=1013,Zn=1014,Vn=1015,Jn=1016,jo=1017,Zo=1018,mr=1020,eh=35902,th=35899,nh=1021,ih=1022,Kn=1023,Ei=1026,Pi=1027,Jo=1028,Ko=1029,Zi=1030,Qo=1031;var el=1033,ea=33776,ta=33777,na=33778,ia=33779,tl=35840,nl=35841,il=35842,rl=35843,sl=36196,al=37492,ol=37496,ll=37488,cl=37489,ra=37490,hl=37491,ul=37808,dl=37809,fl=37810,pl=37811,ml=37812,gl=37813,_l=37814,vl=37815,yl=37816,xl=37817,Sl=37818,Ml=37819,bl=37820,wl=37821,El=36492,Tl=36494,Al=36495,Cl=36283,Rl=36284,sa=36285,Pl=36286;var bs=2300,So=2301,ho=2302,Pc=2303,Ic=2400,Dc=2401,Lc=2402;var Cd=3200;var aa=0,Rd=1,Ii="",gn="srgb",ws="srgb-linear",Es="linear",Pt="srgb";var uo=7680;var Pd=519,Id=512,Dd=513,Ld=514,rh=515,Fd=516,Nd=517,sh=518,ah=519,Ud=35044;var oh="300 es",zn=2e3,Br=2001;function iv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function rv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ts(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Od(){let i=Ts("canvas");return i.style.display="block",i}var Au={},kr=null;function lh(...i){let e="THREE."+i.shift();kr?kr("log",e,...i):console.log(e,...i)}function Bd(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Qe(...i){i=Bd(i);let e="THREE."+i.shift();if(kr)kr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=Bd(i);let e="THREE."+i.shift();if(kr)kr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function xs(...i){let e=i.join(" ");e in Au||(Au[e]=!0,Qe(...i))}function kd(i,e,t){return new Promise(function(n,r){function o(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(o,t);break;default:n()}}setTimeout(o,t)})}var zd={[fo]:fo,[mo]:vo,[go]:go,[Ur]:_o,[po]:po,[vo]:mo,[yo]:yo,[_o]:Ur},jn=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let o=r.indexOf(t);o!==-1&&r.splice(o,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let o=0,l=r.length;o<l;o++)r[o].call(this,e);e.target=null}}},pn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Cu=1234567,Ss=Math.PI/180,zr=180/Math.PI;function Kr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(pn[i&255]+pn[i>>8&255]+pn[i>>16&255]+pn[i>>24&255]+"-"+pn[e&255]+pn[e>>8&255]+"-"+pn[e>>16&15|64]+pn[e>>24&255]+"-"+pn[t&63|128]+pn[t>>8&255]+"-"+pn[t>>16&255]+pn[t>>24&255]+pn[n&255]+pn[n>>8&255]+pn[n>>16&255]+pn[n>>24&255]).toLowerCase()}function yt(i,e,t){return Math.max(e,Math.min(t,i))}function ch(i,e){return(i%e+e)%e}function sv(i,e,t,n,r){return n+(i-e)*(r-n)/(t-e)}function av(i,e,t){return i!==e?(t-i)/(e-i):0}function Ms(i,e,t){return(1-t)*i+t*e}function ov(i,e,t,n){return Ms(i,e,1-Math.exp(-t*n))}function lv(i,e=1){return e-Math.abs(ch(i,e*2)-e)}function cv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function hv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function uv(i,e){return i+Math.floor(Math.random()*(e-i+1))}function dv(i,e){return i+Math.random()*(e-i)}function fv(i){return i*(.5-Math.random())}function pv(i){i!==void 0&&(Cu=i);let e=Cu+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function mv(i){return i*Ss}function gv(i){return i*zr}function _v(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function vv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function hh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function yv(i,e,t,n,r){let o=Math.cos,l=Math.sin,h=o(t/2),f=l(t/2),d=o((e+n)/2),m=l((e+n)/2),y=o((e-n)/2),g=l((e-n)/2),x=o((n-e)/2),M=l((n-e)/2);switch(r){case"XYX":i.set(h*m,f*y,f*g,h*d);break;case"YZY":i.set(f*g,h*m,f*y,h*d);break;case"ZXZ":i.set(f*y,f*g,h*m,h*d);break;case"XZX":i.set(h*m,f*M,f*x,h*d);break;case"YXY":i.set(f*x,h*m,f*M,h*d);break;case"ZYZ":i.set(f*M,f*x,h*m,h*d);break;default:Qe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function uh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Gd(i,e){if(e.constructor===Float32Array)return i;let t=uh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Vd(i,e){if(e.constructor===Float32Array)return i;let t=uh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var dh={DEG2RAD:Ss,RAD2DEG:zr,generateUUID:Kr,clamp:yt,euclideanModulo:ch,mapLinear:sv,inverseLerp:av,lerp:Ms,damp:ov,pingpong:lv,smoothstep:cv,smootherstep:hv,randInt:uv,randFloat:dv,randFloatSpread:fv,seededRandom:pv,degToRad:mv,radToDeg:gv,isPowerOfTwo:_v,ceilPowerOfTwo:vv,floorPowerOfTwo:hh,setQuaternionFromProperEuler:yv,normalize:Vd,denormalize:Gd},et=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),o=this.x-e.x,l=this.y-e.y;return this.x=o*n-l*r+e.x,this.y=o*r+l*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},bn=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,o,l,h){let f=n[r+0],d=n[r+1],m=n[r+2],y=n[r+3],g=o[l+0],x=o[l+1],M=o[l+2],R=o[l+3];if(y!==R||f!==g||d!==x||m!==M){let S=f*g+d*x+m*M+y*R;S<0&&(g=-g,x=-x,M=-M,R=-R,S=-S);let _=1-h;if(S<.9995){let P=Math.acos(S),U=Math.sin(P);_=Math.sin(_*P)/U,h=Math.sin(h*P)/U,f=f*_+g*h,d=d*_+x*h,m=m*_+M*h,y=y*_+R*h}else{f=f*_+g*h,d=d*_+x*h,m=m*_+M*h,y=y*_+R*h;let P=1/Math.sqrt(f*f+d*d+m*m+y*y);f*=P,d*=P,m*=P,y*=P}}e[t]=f,e[t+1]=d,e[t+2]=m,e[t+3]=y}static multiplyQuaternionsFlat(e,t,n,r,o,l){let h=n[r],f=n[r+1],d=n[r+2],m=n[r+3],y=o[l],g=o[l+1],x=o[l+2],M=o[l+3];return e[t]=h*M+m*y+f*x-d*g,e[t+1]=f*M+m*g+d*y-h*x,e[t+2]=d*M+m*x+h*g-f*y,e[t+3]=m*M-h*y-f*g-d*x,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,o=e._z,l=e._order,h=Math.cos,f=Math.sin,d=h(n/2),m=h(r/2),y=h(o/2),g=f(n/2),x=f(r/2),M=f(o/2);switch(l){case"XYZ":this._x=g*m*y+d*x*M,this._y=d*x*y-g*m*M,this._z=d*m*M+g*x*y,this._w=d*m*y-g*x*M;break;case"YXZ":this._x=g*m*y+d*x*M,this._y=d*x*y-g*m*M,this._z=d*m*M-g*x*y,this._w=d*m*y+g*x*M;break;case"ZXY":this._x=g*m*y-d*x*M,this._y=d*x*y+g*m*M,this._z=d*m*M+g*x*y,this._w=d*m*y-g*x*M;break;case"ZYX":this._x=g*m*y-d*x*M,this._y=d*x*y+g*m*M,this._z=d*m*M-g*x*y,this._w=d*m*y+g*x*M;break;case"YZX":this._x=g*m*y+d*x*M,this._y=d*x*y+g*m*M,this._z=d*m*M-g*x*y,this._w=d*m*y-g*x*M;break;case"XZY":this._x=g*m*y-d*x*M,this._y=d*x*y-g*m*M,this._z=d*m*M+g*x*y,this._w=d*m*y+g*x*M;break;default:Qe("Quaternion: .setFromEuler() encountered an unknown order: "+l)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],o=t[8],l=t[1],h=t[5],f=t[9],d=t[2],m=t[6],y=t[10],g=n+h+y;if(g>0){let x=.5/Math.sqrt(g+1);this._w=.25/x,this._x=(m-f)*x,this._y=(o-d)*x,this._z=(l-r)*x}else if(n>h&&n>y){let x=2*Math.sqrt(1+n-h-y);this._w=(m-f)/x,this._x=.25*x,this._y=(r+l)/x,this._z=(o+d)/x}else if(h>y){let x=2*Math.sqrt(1+h-n-y);this._w=(o-d)/x,this._x=(r+l)/x,this._y=.25*x,this._z=(f+m)/x}else{let x=2*Math.sqrt(1+y-n-h);this._w=(l-r)/x,this._x=(o+d)/x,this._y=(f+m)/x,this._z=.25*x}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,o=e._z,l=e._w,h=t._x,f=t._y,d=t._z,m=t._w;return this._x=n*m+l*h+r*d-o*f,this._y=r*m+l*f+o*h-n*d,this._z=o*m+l*d+n*f-r*h,this._w=l*m-n*h-r*f-o*d,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,o=e._z,l=e._w,h=this.dot(e);h<0&&(n=-n,r=-r,o=-o,l=-l,h=-h);let f=1-t;if(h<.9995){let d=Math.acos(h),m=Math.sin(d);f=Math.sin(f*d)/m,t=Math.sin(t*d)/m,this._x=this._x*f+n*t,this._y=this._y*f+r*t,this._z=this._z*f+o*t,this._w=this._w*f+l*t,this._onChangeCallback()}else this._x=this._x*f+n*t,this._y=this._y*f+r*t,this._z=this._z*f+o*t,this._w=this._w*f+l*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),o=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),o*Math.sin(t),o*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},j=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Ru.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Ru.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,o=e.elements;return this.x=o[0]*t+o[3]*n+o[6]*r,this.y=o[1]*t+o[4]*n+o[7]*r,this.z=o[2]*t+o[5]*n+o[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,o=e.elements,l=1/(o[3]*t+o[7]*n+o[11]*r+o[15]);return this.x=(o[0]*t+o[4]*n+o[8]*r+o[12])*l,this.y=(o[1]*t+o[5]*n+o[9]*r+o[13])*l,this.z=(o[2]*t+o[6]*n+o[10]*r+o[14])*l,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,o=e.x,l=e.y,h=e.z,f=e.w,d=2*(l*r-h*n),m=2*(h*t-o*r),y=2*(o*n-l*t);return this.x=t+f*d+l*y-h*m,this.y=n+f*m+h*d-o*y,this.z=r+f*y+o*m-l*d,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*r,this.y=o[1]*t+o[5]*n+o[9]*r,this.z=o[2]*t+o[6]*n+o[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,o=e.z,l=t.x,h=t.y,f=t.z;return this.x=r*f-o*h,this.y=o*l-n*f,this.z=n*h-r*l,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return lc.copy(this).projectOnVector(e),this.sub(lc)}reflect(e){return this.sub(lc.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},lc=new j,Ru=new bn,ct=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,o,l,h,f,d){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,o,l,h,f,d)}set(e,t,n,r,o,l,h,f,d){let m=this.elements;return m[0]=e,m[1]=r,m[2]=h,m[3]=t,m[4]=o,m[5]=f,m[6]=n,m[7]=l,m[8]=d,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,o=this.elements,l=n[0],h=n[3],f=n[6],d=n[1],m=n[4],y=n[7],g=n[2],x=n[5],M=n[8],R=r[0],S=r[3],_=r[6],P=r[1],U=r[4],I=r[7],O=r[2],N=r[5],w=r[8];return o[0]=l*R+h*P+f*O,o[3]=l*S+h*U+f*N,o[6]=l*_+h*I+f*w,o[1]=d*R+m*P+y*O,o[4]=d*S+m*U+y*N,o[7]=d*_+m*I+y*w,o[2]=g*R+x*P+M*O,o[5]=g*S+x*U+M*N,o[8]=g*_+x*I+M*w,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8];return t*l*m-t*h*d-n*o*m+n*h*f+r*o*d-r*l*f}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8],y=m*l-h*d,g=h*f-m*o,x=d*o-l*f,M=t*y+n*g+r*x;if(M===0)return this.set(0,0,0,0,0,0,0,0,0);let R=1/M;return e[0]=y*R,e[1]=(r*d-m*n)*R,e[2]=(h*n-r*l)*R,e[3]=g*R,e[4]=(m*t-r*f)*R,e[5]=(r*o-h*t)*R,e[6]=x*R,e[7]=(n*f-d*t)*R,e[8]=(l*t-n*o)*R,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,o,l,h){let f=Math.cos(o),d=Math.sin(o);return this.set(n*f,n*d,-n*(f*l+d*h)+l+e,-r*d,r*f,-r*(-d*l+f*h)+h+t,0,0,1),this}scale(e,t){return xs("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(cc.makeScale(e,t)),this}rotate(e){return xs("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(cc.makeRotation(-e)),this}translate(e,t){return xs("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(cc.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},cc=new ct,Pu=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Iu=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function xv(){let i={enabled:!0,workingColorSpace:ws,spaces:{},convert:function(r,o,l){return this.enabled===!1||o===l||!o||!l||(this.spaces[o].transfer===Pt&&(r.r=wi(r.r),r.g=wi(r.g),r.b=wi(r.b)),this.spaces[o].primaries!==this.spaces[l].primaries&&(r.applyMatrix3(this.spaces[o].toXYZ),r.applyMatrix3(this.spaces[l].fromXYZ)),this.spaces[l].transfer===Pt&&(r.r=Nr(r.r),r.g=Nr(r.g),r.b=Nr(r.b))),r},workingToColorSpace:function(r,o){return this.convert(r,this.workingColorSpace,o)},colorSpaceToWorking:function(r,o){return this.convert(r,o,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Ii?Es:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,o=this.workingColorSpace){return r.fromArray(this.spaces[o].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,o,l){return r.copy(this.spaces[l].fromXYZ).multiply(this.spaces[o].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ws]:{primaries:e,whitePoint:n,transfer:Es,toXYZ:Pu,fromXYZ:Iu,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:gn},outputColorSpaceConfig:{drawingBufferColorSpace:gn}},[gn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:Pu,fromXYZ:Iu,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:gn}}}),i}var St=xv();function wi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Nr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Sr,Mo=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Sr===void 0&&(Sr=Ts("canvas")),Sr.width=e.width,Sr.height=e.height;let r=Sr.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=Sr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ts("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),o=r.data;for(let l=0;l<o.length;l++)o[l]=wi(o[l]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(wi(t[n]/255)*255):t[n]=wi(t[n]);return{data:t,width:e.width,height:e.height}}else return Qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Sv=0,Gr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Sv++}),this.uuid=Kr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let o;if(Array.isArray(r)){o=[];for(let l=0,h=r.length;l<h;l++)r[l].isDataTexture?o.push(hc(r[l].image)):o.push(hc(r[l]))}else o=hc(r);n.url=o}return t||(e.images[this.uuid]=n),n}};function hc(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Mo.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Qe("Texture: Unable to serialize Texture."),{})}var Mv=0,uc=new j,wn=class i extends jn{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=oi,r=oi,o=Mn,l=Ri,h=Kn,f=Tn,d=i.DEFAULT_ANISOTROPY,m=Ii){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Mv++}),this.uuid=Kr(),this.name="",this.source=new Gr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=o,this.minFilter=l,this.anisotropy=d,this.format=h,this.internalFormat=null,this.type=f,this.offset=new et(0,0),this.repeat=new et(1,1),this.center=new et(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=m,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(uc).x}get height(){return this.source.getSize(uc).y}get depth(){return this.source.getSize(uc).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Qe(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Jc)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Or:e.x=e.x-Math.floor(e.x);break;case oi:e.x=e.x<0?0:1;break;case xo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Or:e.y=e.y-Math.floor(e.y);break;case oi:e.y=e.y<0?0:1;break;case xo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};wn.DEFAULT_IMAGE=null;wn.DEFAULT_MAPPING=Jc;wn.DEFAULT_ANISOTROPY=1;var Gt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,o=this.w,l=e.elements;return this.x=l[0]*t+l[4]*n+l[8]*r+l[12]*o,this.y=l[1]*t+l[5]*n+l[9]*r+l[13]*o,this.z=l[2]*t+l[6]*n+l[10]*r+l[14]*o,this.w=l[3]*t+l[7]*n+l[11]*r+l[15]*o,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,o,f=e.elements,d=f[0],m=f[4],y=f[8],g=f[1],x=f[5],M=f[9],R=f[2],S=f[6],_=f[10];if(Math.abs(m-g)<.01&&Math.abs(y-R)<.01&&Math.abs(M-S)<.01){if(Math.abs(m+g)<.1&&Math.abs(y+R)<.1&&Math.abs(M+S)<.1&&Math.abs(d+x+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let U=(d+1)/2,I=(x+1)/2,O=(_+1)/2,N=(m+g)/4,w=(y+R)/4,D=(M+S)/4;return U>I&&U>O?U<.01?(n=0,r=.707106781,o=.707106781):(n=Math.sqrt(U),r=N/n,o=w/n):I>O?I<.01?(n=.707106781,r=0,o=.707106781):(r=Math.sqrt(I),n=N/r,o=D/r):O<.01?(n=.707106781,r=.707106781,o=0):(o=Math.sqrt(O),n=w/o,r=D/o),this.set(n,r,o,t),this}let P=Math.sqrt((S-M)*(S-M)+(y-R)*(y-R)+(g-m)*(g-m));return Math.abs(P)<.001&&(P=1),this.x=(S-M)/P,this.y=(y-R)/P,this.z=(g-m)/P,this.w=Math.acos((d+x+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},bo=class extends jn{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Mn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t),this.textures=[];let r=n.count;for(let o=0;o<r;o++)this.textures[o]=new wn({width:e,height:t,depth:n.depth}),this.textures[o].isRenderTargetTexture=!0,this.textures[o].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Mn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,o=this.textures.length;r<o;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Gr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ln=class extends bo{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},As=class extends wn{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=cn,this.minFilter=cn,this.wrapR=oi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var wo=class extends wn{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=cn,this.minFilter=cn,this.wrapR=oi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Lt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,o,l,h,f,d,m,y,g,x,M,R,S){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,o,l,h,f,d,m,y,g,x,M,R,S)}set(e,t,n,r,o,l,h,f,d,m,y,g,x,M,R,S){let _=this.elements;return _[0]=e,_[4]=t,_[8]=n,_[12]=r,_[1]=o,_[5]=l,_[9]=h,_[13]=f,_[2]=d,_[6]=m,_[10]=y,_[14]=g,_[3]=x,_[7]=M,_[11]=R,_[15]=S,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/Mr.setFromMatrixColumn(e,0).length(),o=1/Mr.setFromMatrixColumn(e,1).length(),l=1/Mr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*o,t[5]=n[5]*o,t[6]=n[6]*o,t[7]=0,t[8]=n[8]*l,t[9]=n[9]*l,t[10]=n[10]*l,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,o=e.z,l=Math.cos(n),h=Math.sin(n),f=Math.cos(r),d=Math.sin(r),m=Math.cos(o),y=Math.sin(o);if(e.order==="XYZ"){let g=l*m,x=l*y,M=h*m,R=h*y;t[0]=f*m,t[4]=-f*y,t[8]=d,t[1]=x+M*d,t[5]=g-R*d,t[9]=-h*f,t[2]=R-g*d,t[6]=M+x*d,t[10]=l*f}else if(e.order==="YXZ"){let g=f*m,x=f*y,M=d*m,R=d*y;t[0]=g+R*h,t[4]=M*h-x,t[8]=l*d,t[1]=l*y,t[5]=l*m,t[9]=-h,t[2]=x*h-M,t[6]=R+g*h,t[10]=l*f}else if(e.order==="ZXY"){let g=f*m,x=f*y,M=d*m,R=d*y;t[0]=g-R*h,t[4]=-l*y,t[8]=M+x*h,t[1]=x+M*h,t[5]=l*m,t[9]=R-g*h,t[2]=-l*d,t[6]=h,t[10]=l*f}else if(e.order==="ZYX"){let g=l*m,x=l*y,M=h*m,R=h*y;t[0]=f*m,t[4]=M*d-x,t[8]=g*d+R,t[1]=f*y,t[5]=R*d+g,t[9]=x*d-M,t[2]=-d,t[6]=h*f,t[10]=l*f}else if(e.order==="YZX"){let g=l*f,x=l*d,M=h*f,R=h*d;t[0]=f*m,t[4]=R-g*y,t[8]=M*y+x,t[1]=y,t[5]=l*m,t[9]=-h*m,t[2]=-d*m,t[6]=x*y+M,t[10]=g-R*y}else if(e.order==="XZY"){let g=l*f,x=l*d,M=h*f,R=h*d;t[0]=f*m,t[4]=-y,t[8]=d*m,t[1]=g*y+R,t[5]=l*m,t[9]=x*y-M,t[2]=M*y-x,t[6]=h*m,t[10]=R*y+g}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(bv,e,wv)}lookAt(e,t,n){let r=this.elements;return Rn.subVectors(e,t),Rn.lengthSq()===0&&(Rn.z=1),Rn.normalize(),Ni.crossVectors(n,Rn),Ni.lengthSq()===0&&(Math.abs(n.z)===1?Rn.x+=1e-4:Rn.z+=1e-4,Rn.normalize(),Ni.crossVectors(n,Rn)),Ni.normalize(),za.crossVectors(Rn,Ni),r[0]=Ni.x,r[4]=za.x,r[8]=Rn.x,r[1]=Ni.y,r[5]=za.y,r[9]=Rn.y,r[2]=Ni.z,r[6]=za.z,r[10]=Rn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,o=this.elements,l=n[0],h=n[4],f=n[8],d=n[12],m=n[1],y=n[5],g=n[9],x=n[13],M=n[2],R=n[6],S=n[10],_=n[14],P=n[3],U=n[7],I=n[11],O=n[15],N=r[0],w=r[4],D=r[8],X=r[12],k=r[1],Y=r[5],Z=r[9],ee=r[13],z=r[2],ie=r[6],G=r[10],ne=r[14],Se=r[3],re=r[7],H=r[11],ge=r[15];return o[0]=l*N+h*k+f*z+d*Se,o[4]=l*w+h*Y+f*ie+d*re,o[8]=l*D+h*Z+f*G+d*H,o[12]=l*X+h*ee+f*ne+d*ge,o[1]=m*N+y*k+g*z+x*Se,o[5]=m*w+y*Y+g*ie+x*re,o[9]=m*D+y*Z+g*G+x*H,o[13]=m*X+y*ee+g*ne+x*ge,o[2]=M*N+R*k+S*z+_*Se,o[6]=M*w+R*Y+S*ie+_*re,o[10]=M*D+R*Z+S*G+_*H,o[14]=M*X+R*ee+S*ne+_*ge,o[3]=P*N+U*k+I*z+O*Se,o[7]=P*w+U*Y+I*ie+O*re,o[11]=P*D+U*Z+I*G+O*H,o[15]=P*X+U*ee+I*ne+O*ge,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],o=e[12],l=e[1],h=e[5],f=e[9],d=e[13],m=e[2],y=e[6],g=e[10],x=e[14],M=e[3],R=e[7],S=e[11],_=e[15],P=f*x-d*g,U=h*x-d*y,I=h*g-f*y,O=l*x-d*m,N=l*g-f*m,w=l*y-h*m;return t*(R*P-S*U+_*I)-n*(M*P-S*O+_*N)+r*(M*U-R*O+_*w)-o*(M*I-R*N+S*w)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],o=e[1],l=e[5],h=e[9],f=e[2],d=e[6],m=e[10];return t*(l*m-h*d)-n*(o*m-h*f)+r*(o*d-l*f)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],o=e[3],l=e[4],h=e[5],f=e[6],d=e[7],m=e[8],y=e[9],g=e[10],x=e[11],M=e[12],R=e[13],S=e[14],_=e[15],P=t*h-n*l,U=t*f-r*l,I=t*d-o*l,O=n*f-r*h,N=n*d-o*h,w=r*d-o*f,D=m*R-y*M,X=m*S-g*M,k=m*_-x*M,Y=y*S-g*R,Z=y*_-x*R,ee=g*_-x*S,z=P*ee-U*Z+I*Y+O*k-N*X+w*D;if(z===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let ie=1/z;return e[0]=(h*ee-f*Z+d*Y)*ie,e[1]=(r*Z-n*ee-o*Y)*ie,e[2]=(R*w-S*N+_*O)*ie,e[3]=(g*N-y*w-x*O)*ie,e[4]=(f*k-l*ee-d*X)*ie,e[5]=(t*ee-r*k+o*X)*ie,e[6]=(S*I-M*w-_*U)*ie,e[7]=(m*w-g*I+x*U)*ie,e[8]=(l*Z-h*k+d*D)*ie,e[9]=(n*k-t*Z-o*D)*ie,e[10]=(M*N-R*I+_*P)*ie,e[11]=(y*I-m*N-x*P)*ie,e[12]=(h*X-l*Y-f*D)*ie,e[13]=(t*Y-n*X+r*D)*ie,e[14]=(R*U-M*O-S*P)*ie,e[15]=(m*O-y*U+g*P)*ie,this}scale(e){let t=this.elements,n=e.x,r=e.y,o=e.z;return t[0]*=n,t[4]*=r,t[8]*=o,t[1]*=n,t[5]*=r,t[9]*=o,t[2]*=n,t[6]*=r,t[10]*=o,t[3]*=n,t[7]*=r,t[11]*=o,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),o=1-n,l=e.x,h=e.y,f=e.z,d=o*l,m=o*h;return this.set(d*l+n,d*h-r*f,d*f+r*h,0,d*h+r*f,m*h+n,m*f-r*l,0,d*f-r*h,m*f+r*l,o*f*f+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,o,l){return this.set(1,n,o,0,e,1,l,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,o=t._x,l=t._y,h=t._z,f=t._w,d=o+o,m=l+l,y=h+h,g=o*d,x=o*m,M=o*y,R=l*m,S=l*y,_=h*y,P=f*d,U=f*m,I=f*y,O=n.x,N=n.y,w=n.z;return r[0]=(1-(R+_))*O,r[1]=(x+I)*O,r[2]=(M-U)*O,r[3]=0,r[4]=(x-I)*N,r[5]=(1-(g+_))*N,r[6]=(S+P)*N,r[7]=0,r[8]=(M+U)*w,r[9]=(S-P)*w,r[10]=(1-(g+R))*w,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let o=this.determinantAffine();if(o===0)return n.set(1,1,1),t.identity(),this;let l=Mr.set(r[0],r[1],r[2]).length(),h=Mr.set(r[4],r[5],r[6]).length(),f=Mr.set(r[8],r[9],r[10]).length();o<0&&(l=-l),qn.copy(this);let d=1/l,m=1/h,y=1/f;return qn.elements[0]*=d,qn.elements[1]*=d,qn.elements[2]*=d,qn.elements[4]*=m,qn.elements[5]*=m,qn.elements[6]*=m,qn.elements[8]*=y,qn.elements[9]*=y,qn.elements[10]*=y,t.setFromRotationMatrix(qn),n.x=l,n.y=h,n.z=f,this}makePerspective(e,t,n,r,o,l,h=zn,f=!1){let d=this.elements,m=2*o/(t-e),y=2*o/(n-r),g=(t+e)/(t-e),x=(n+r)/(n-r),M,R;if(f)M=o/(l-o),R=l*o/(l-o);else if(h===zn)M=-(l+o)/(l-o),R=-2*l*o/(l-o);else if(h===Br)M=-l/(l-o),R=-l*o/(l-o);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+h);return d[0]=m,d[4]=0,d[8]=g,d[12]=0,d[1]=0,d[5]=y,d[9]=x,d[13]=0,d[2]=0,d[6]=0,d[10]=M,d[14]=R,d[3]=0,d[7]=0,d[11]=-1,d[15]=0,this}makeOrthographic(e,t,n,r,o,l,h=zn,f=!1){let d=this.elements,m=2/(t-e),y=2/(n-r),g=-(t+e)/(t-e),x=-(n+r)/(n-r),M,R;if(f)M=1/(l-o),R=l/(l-o);else if(h===zn)M=-2/(l-o),R=-(l+o)/(l-o);else if(h===Br)M=-1/(l-o),R=-o/(l-o);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+h);return d[0]=m,d[4]=0,d[8]=0,d[12]=g,d[1]=0,d[5]=y,d[9]=0,d[13]=x,d[2]=0,d[6]=0,d[10]=M,d[14]=R,d[3]=0,d[7]=0,d[11]=0,d[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Mr=new j,qn=new Lt,bv=new j(0,0,0),wv=new j(1,1,1),Ni=new j,za=new j,Rn=new j,Du=new Lt,Lu=new bn,li=class i{constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,o=r[0],l=r[4],h=r[8],f=r[1],d=r[5],m=r[9],y=r[2],g=r[6],x=r[10];switch(t){case"XYZ":this._y=Math.asin(yt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(-m,x),this._z=Math.atan2(-l,o)):(this._x=Math.atan2(g,d),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(m,-1,1)),Math.abs(m)<.9999999?(this._y=Math.atan2(h,x),this._z=Math.atan2(f,d)):(this._y=Math.atan2(-y,o),this._z=0);break;case"ZXY":this._x=Math.asin(yt(g,-1,1)),Math.abs(g)<.9999999?(this._y=Math.atan2(-y,x),this._z=Math.atan2(-l,d)):(this._y=0,this._z=Math.atan2(f,o));break;case"ZYX":this._y=Math.asin(-yt(y,-1,1)),Math.abs(y)<.9999999?(this._x=Math.atan2(g,x),this._z=Math.atan2(f,o)):(this._x=0,this._z=Math.atan2(-l,d));break;case"YZX":this._z=Math.asin(yt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(-m,d),this._y=Math.atan2(-y,o)):(this._x=0,this._y=Math.atan2(h,x));break;case"XZY":this._z=Math.asin(-yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(g,d),this._y=Math.atan2(h,o)):(this._x=Math.atan2(-m,x),this._y=0);break;default:Qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Du.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Du,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Lu.setFromEuler(this),this.setFromQuaternion(Lu,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};li.DEFAULT_ORDER="XYZ";var Vr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Ev=0,Fu=new j,br=new bn,yi=new Lt,Ga=new j,fs=new j,Tv=new j,Av=new bn,Nu=new j(1,0,0),Uu=new j(0,1,0),Ou=new j(0,0,1),Bu={type:"added"},Cv={type:"removed"},wr={type:"childadded",child:null},dc={type:"childremoved",child:null},Qt=class i extends jn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ev++}),this.uuid=Kr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new j,t=new li,n=new bn,r=new j(1,1,1);function o(){n.setFromEuler(t,!1)}function l(){t.setFromQuaternion(n,void 0,!1)}t._onChange(o),n._onChange(l),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Lt},normalMatrix:{value:new ct}}),this.matrix=new Lt,this.matrixWorld=new Lt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Vr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return br.setFromAxisAngle(e,t),this.quaternion.multiply(br),this}rotateOnWorldAxis(e,t){return br.setFromAxisAngle(e,t),this.quaternion.premultiply(br),this}rotateX(e){return this.rotateOnAxis(Nu,e)}rotateY(e){return this.rotateOnAxis(Uu,e)}rotateZ(e){return this.rotateOnAxis(Ou,e)}translateOnAxis(e,t){return Fu.copy(e).applyQuaternion(this.quaternion),this.position.add(Fu.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Nu,e)}translateY(e){return this.translateOnAxis(Uu,e)}translateZ(e){return this.translateOnAxis(Ou,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(yi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ga.copy(e):Ga.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),fs.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?yi.lookAt(fs,Ga,this.up):yi.lookAt(Ga,fs,this.up),this.quaternion.setFromRotationMatrix(yi),r&&(yi.extractRotation(r.matrixWorld),br.setFromRotationMatrix(yi),this.quaternion.premultiply(br.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Bu),wr.child=e,this.dispatchEvent(wr),wr.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Cv),dc.child=e,this.dispatchEvent(dc),dc.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),yi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),yi.multiply(e.parent.matrixWorld)),e.applyMatrix4(yi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Bu),wr.child=e,this.dispatchEvent(wr),wr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let l=this.children[n].getObjectByProperty(e,t);if(l!==void 0)return l}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let o=0,l=r.length;o<l;o++)r[o].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(fs,e,Tv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(fs,Av,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,o=this.matrix.elements;o[12]+=t-o[0]*t-o[4]*n-o[8]*r,o[13]+=n-o[1]*t-o[5]*n-o[9]*r,o[14]+=r-o[2]*t-o[6]*n-o[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let o=this.children;for(let l=0,h=o.length;l<h;l++)o[l].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(h=>({...h,boundingBox:h.boundingBox?h.boundingBox.toJSON():void 0,boundingSphere:h.boundingSphere?h.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(h=>({...h})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function o(h,f){return h[f.uuid]===void 0&&(h[f.uuid]=f.toJSON(e)),f.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=o(e.geometries,this.geometry);let h=this.geometry.parameters;if(h!==void 0&&h.shapes!==void 0){let f=h.shapes;if(Array.isArray(f))for(let d=0,m=f.length;d<m;d++){let y=f[d];o(e.shapes,y)}else o(e.shapes,f)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(o(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let h=[];for(let f=0,d=this.material.length;f<d;f++)h.push(o(e.materials,this.material[f]));r.material=h}else r.material=o(e.materials,this.material);if(this.children.length>0){r.children=[];for(let h=0;h<this.children.length;h++)r.children.push(this.children[h].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let h=0;h<this.animations.length;h++){let f=this.animations[h];r.animations.push(o(e.animations,f))}}if(t){let h=l(e.geometries),f=l(e.materials),d=l(e.textures),m=l(e.images),y=l(e.shapes),g=l(e.skeletons),x=l(e.animations),M=l(e.nodes);h.length>0&&(n.geometries=h),f.length>0&&(n.materials=f),d.length>0&&(n.textures=d),m.length>0&&(n.images=m),y.length>0&&(n.shapes=y),g.length>0&&(n.skeletons=g),x.length>0&&(n.animations=x),M.length>0&&(n.nodes=M)}return n.object=r,n;function l(h){let f=[];for(let d in h){let m=h[d];delete m.metadata,f.push(m)}return f}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Qt.DEFAULT_UP=new j(0,1,0);Qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Gn=class extends Qt{constructor(){super(),this.isGroup=!0,this.type="Group"}},Rv={type:"move"},Hr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Gn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Gn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new j,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new j),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Gn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new j,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new j,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,o=null,l=null,h=this._targetRay,f=this._grip,d=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(d&&e.hand){l=!0;for(let R of e.hand.values()){let S=t.getJointPose(R,n),_=this._getHandJoint(d,R);S!==null&&(_.matrix.fromArray(S.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=S.radius),_.visible=S!==null}let m=d.joints["index-finger-tip"],y=d.joints["thumb-tip"],g=m.position.distanceTo(y.position),x=.02,M=.005;d.inputState.pinching&&g>x+M?(d.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!d.inputState.pinching&&g<=x-M&&(d.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else f!==null&&e.gripSpace&&(o=t.getPose(e.gripSpace,n),o!==null&&(f.matrix.fromArray(o.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,o.linearVelocity?(f.hasLinearVelocity=!0,f.linearVelocity.copy(o.linearVelocity)):f.hasLinearVelocity=!1,o.angularVelocity?(f.hasAngularVelocity=!0,f.angularVelocity.copy(o.angularVelocity)):f.hasAngularVelocity=!1,f.eventsEnabled&&f.dispatchEvent({type:"gripUpdated",data:e,target:this})));h!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&o!==null&&(r=o),r!==null&&(h.matrix.fromArray(r.transform.matrix),h.matrix.decompose(h.position,h.quaternion,h.scale),h.matrixWorldNeedsUpdate=!0,r.linearVelocity?(h.hasLinearVelocity=!0,h.linearVelocity.copy(r.linearVelocity)):h.hasLinearVelocity=!1,r.angularVelocity?(h.hasAngularVelocity=!0,h.angularVelocity.copy(r.angularVelocity)):h.hasAngularVelocity=!1,this.dispatchEvent(Rv)))}return h!==null&&(h.visible=r!==null),f!==null&&(f.visible=o!==null),d!==null&&(d.visible=l!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Gn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Hd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ui={h:0,s:0,l:0},Va={h:0,s:0,l:0};function fc(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ht=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=gn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=St.workingColorSpace){if(e=ch(e,1),t=yt(t,0,1),n=yt(n,0,1),t===0)this.r=this.g=this.b=n;else{let o=n<=.5?n*(1+t):n+t-n*t,l=2*n-o;this.r=fc(l,o,e+1/3),this.g=fc(l,o,e),this.b=fc(l,o,e-1/3)}return St.colorSpaceToWorking(this,r),this}setStyle(e,t=gn){function n(o){o!==void 0&&parseFloat(o)<1&&Qe("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let o,l=r[1],h=r[2];switch(l){case"rgb":case"rgba":if(o=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setRGB(Math.min(255,parseInt(o[1],10))/255,Math.min(255,parseInt(o[2],10))/255,Math.min(255,parseInt(o[3],10))/255,t);if(o=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setRGB(Math.min(100,parseFloat(o[1]))/100,Math.min(100,parseFloat(o[2]))/100,Math.min(100,parseFloat(o[3]))/100,t);break;case"hsl":case"hsla":if(o=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(h))return n(o[4]),this.setHSL(parseFloat(o[1])/360,parseFloat(o[2])/100,parseFloat(o[3])/100,t);break;default:Qe("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let o=r[1],l=o.length;if(l===3)return this.setRGB(parseInt(o.charAt(0),16)/15,parseInt(o.charAt(1),16)/15,parseInt(o.charAt(2),16)/15,t);if(l===6)return this.setHex(parseInt(o,16),t);Qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=gn){let n=Hd[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=wi(e.r),this.g=wi(e.g),this.b=wi(e.b),this}copyLinearToSRGB(e){return this.r=Nr(e.r),this.g=Nr(e.g),this.b=Nr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=gn){return St.workingToColorSpace(mn.copy(this),e),Math.round(yt(mn.r*255,0,255))*65536+Math.round(yt(mn.g*255,0,255))*256+Math.round(yt(mn.b*255,0,255))}getHexString(e=gn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(mn.copy(this),t);let n=mn.r,r=mn.g,o=mn.b,l=Math.max(n,r,o),h=Math.min(n,r,o),f,d,m=(h+l)/2;if(h===l)f=0,d=0;else{let y=l-h;switch(d=m<=.5?y/(l+h):y/(2-l-h),l){case n:f=(r-o)/y+(r<o?6:0);break;case r:f=(o-n)/y+2;break;case o:f=(n-r)/y+4;break}f/=6}return e.h=f,e.s=d,e.l=m,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(mn.copy(this),t),e.r=mn.r,e.g=mn.g,e.b=mn.b,e}getStyle(e=gn){St.workingToColorSpace(mn.copy(this),e);let t=mn.r,n=mn.g,r=mn.b;return e!==gn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(Ui),this.setHSL(Ui.h+e,Ui.s+t,Ui.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ui),e.getHSL(Va);let n=Ms(Ui.h,Va.h,t),r=Ms(Ui.s,Va.s,t),o=Ms(Ui.l,Va.l,t);return this.setHSL(n,r,o),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,o=e.elements;return this.r=o[0]*t+o[3]*n+o[6]*r,this.g=o[1]*t+o[4]*n+o[7]*r,this.b=o[2]*t+o[5]*n+o[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},mn=new ht;ht.NAMES=Hd;var Cs=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ht(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},hr=class extends Qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new li,this.environmentIntensity=1,this.environmentRotation=new li,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},$n=new j,xi=new j,pc=new j,Si=new j,Er=new j,Tr=new j,ku=new j,mc=new j,gc=new j,_c=new j,vc=new Gt,yc=new Gt,xc=new Gt,zi=class i{constructor(e=new j,t=new j,n=new j){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),$n.subVectors(e,t),r.cross($n);let o=r.lengthSq();return o>0?r.multiplyScalar(1/Math.sqrt(o)):r.set(0,0,0)}static getBarycoord(e,t,n,r,o){$n.subVectors(r,t),xi.subVectors(n,t),pc.subVectors(e,t);let l=$n.dot($n),h=$n.dot(xi),f=$n.dot(pc),d=xi.dot(xi),m=xi.dot(pc),y=l*d-h*h;if(y===0)return o.set(0,0,0),null;let g=1/y,x=(d*f-h*m)*g,M=(l*m-h*f)*g;return o.set(1-x-M,M,x)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,Si)===null?!1:Si.x>=0&&Si.y>=0&&Si.x+Si.y<=1}static getInterpolation(e,t,n,r,o,l,h,f){return this.getBarycoord(e,t,n,r,Si)===null?(f.x=0,f.y=0,"z"in f&&(f.z=0),"w"in f&&(f.w=0),null):(f.setScalar(0),f.addScaledVector(o,Si.x),f.addScaledVector(l,Si.y),f.addScaledVector(h,Si.z),f)}static getInterpolatedAttribute(e,t,n,r,o,l){return vc.setScalar(0),yc.setScalar(0),xc.setScalar(0),vc.fromBufferAttribute(e,t),yc.fromBufferAttribute(e,n),xc.fromBufferAttribute(e,r),l.setScalar(0),l.addScaledVector(vc,o.x),l.addScaledVector(yc,o.y),l.addScaledVector(xc,o.z),l}static isFrontFacing(e,t,n,r){return $n.subVectors(n,t),xi.subVectors(e,t),$n.cross(xi).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $n.subVectors(this.c,this.b),xi.subVectors(this.a,this.b),$n.cross(xi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,o){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,o)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,o=this.c,l,h;Er.subVectors(r,n),Tr.subVectors(o,n),mc.subVectors(e,n);let f=Er.dot(mc),d=Tr.dot(mc);if(f<=0&&d<=0)return t.copy(n);gc.subVectors(e,r);let m=Er.dot(gc),y=Tr.dot(gc);if(m>=0&&y<=m)return t.copy(r);let g=f*y-m*d;if(g<=0&&f>=0&&m<=0&&f-m>0)return l=f/(f-m),t.copy(n).addScaledVector(Er,l);_c.subVectors(e,o);let x=Er.dot(_c),M=Tr.dot(_c);if(M>=0&&x<=M)return t.copy(o);let R=x*d-f*M;if(R<=0&&d>=0&&M<=0)return h=d/(d-M),t.copy(n).addScaledVector(Tr,h);let S=m*M-x*y;if(S<=0&&y-m>=0&&x-M>=0)return ku.subVectors(o,r),h=(y-m)/(y-m+(x-M)),t.copy(r).addScaledVector(ku,h);let _=1/(S+R+g);return l=R*_,h=g*_,t.copy(n).addScaledVector(Er,l).addScaledVector(Tr,h)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ci=class{constructor(e=new j(1/0,1/0,1/0),t=new j(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Yn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Yn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Yn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let o=n.getAttribute("position");if(t===!0&&o!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let l=0,h=o.count;l<h;l++)e.isMesh===!0?e.getVertexPosition(l,Yn):Yn.fromBufferAttribute(o,l),Yn.applyMatrix4(e.matrixWorld),this.expandByPoint(Yn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ha.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ha.copy(n.boundingBox)),Ha.applyMatrix4(e.matrixWorld),this.union(Ha)}let r=e.children;for(let o=0,l=r.length;o<l;o++)this.expandByObject(r[o],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Yn),Yn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ps),Wa.subVectors(this.max,ps),Ar.subVectors(e.a,ps),Cr.subVectors(e.b,ps),Rr.subVectors(e.c,ps),Oi.subVectors(Cr,Ar),Bi.subVectors(Rr,Cr),ar.subVectors(Ar,Rr);let t=[0,-Oi.z,Oi.y,0,-Bi.z,Bi.y,0,-ar.z,ar.y,Oi.z,0,-Oi.x,Bi.z,0,-Bi.x,ar.z,0,-ar.x,-Oi.y,Oi.x,0,-Bi.y,Bi.x,0,-ar.y,ar.x,0];return!Sc(t,Ar,Cr,Rr,Wa)||(t=[1,0,0,0,1,0,0,0,1],!Sc(t,Ar,Cr,Rr,Wa))?!1:(Xa.crossVectors(Oi,Bi),t=[Xa.x,Xa.y,Xa.z],Sc(t,Ar,Cr,Rr,Wa))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Yn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Yn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Mi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Mi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Mi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Mi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Mi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Mi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Mi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Mi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Mi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Mi=[new j,new j,new j,new j,new j,new j,new j,new j],Yn=new j,Ha=new ci,Ar=new j,Cr=new j,Rr=new j,Oi=new j,Bi=new j,ar=new j,ps=new j,Wa=new j,Xa=new j,or=new j;function Sc(i,e,t,n,r){for(let o=0,l=i.length-3;o<=l;o+=3){or.fromArray(i,o);let h=r.x*Math.abs(or.x)+r.y*Math.abs(or.y)+r.z*Math.abs(or.z),f=e.dot(or),d=t.dot(or),m=n.dot(or);if(Math.max(-Math.max(f,d,m),Math.min(f,d,m))>h)return!1}return!0}var Yt=new j,qa=new et,Pv=0,Dn=class extends jn{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Pv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Ud,this.updateRanges=[],this.gpuType=Vn,this.version=0,this._normalizationScale=e!==void 0?uh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,o=this.itemSize;r<o;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)qa.fromBufferAttribute(this,t),qa.applyMatrix3(e),this.setXY(t,qa.x,qa.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix3(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix4(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyNormalMatrix(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.transformDirection(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,o){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),o=this._normalize(o)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=o,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Gd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Vd(e,this.array)}};var Rs=class extends Dn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ps=class extends Dn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Xt=class extends Dn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Iv=new ci,ms=new j,Mc=new j,Ti=class{constructor(e=new j,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Iv.setFromPoints(e).getCenter(n);let r=0;for(let o=0,l=e.length;o<l;o++)r=Math.max(r,n.distanceToSquared(e[o]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ms.subVectors(e,this.center);let t=ms.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector(ms,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Mc.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ms.copy(e.center).add(Mc)),this.expandByPoint(ms.copy(e.center).sub(Mc))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Dv=0,kn=new Lt,bc=new Qt,Pr=new j,Pn=new ci,gs=new ci,ln=new j,En=class i extends jn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Dv++}),this.uuid=Kr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(iv(e)?Ps:Rs)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let o=new ct().getNormalMatrix(e);n.applyNormalMatrix(o),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return kn.makeRotationFromQuaternion(e),this.applyMatrix4(kn),this}rotateX(e){return kn.makeRotationX(e),this.applyMatrix4(kn),this}rotateY(e){return kn.makeRotationY(e),this.applyMatrix4(kn),this}rotateZ(e){return kn.makeRotationZ(e),this.applyMatrix4(kn),this}translate(e,t,n){return kn.makeTranslation(e,t,n),this.applyMatrix4(kn),this}scale(e,t,n){return kn.makeScale(e,t,n),this.applyMatrix4(kn),this}lookAt(e){return bc.lookAt(e),bc.updateMatrix(),this.applyMatrix4(bc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Pr).negate(),this.translate(Pr.x,Pr.y,Pr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,o=e.length;r<o;r++){let l=e[r];n.push(l.x,l.y,l.z||0)}this.setAttribute("position",new Xt(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let o=e[r];t.setXYZ(r,o.x,o.y,o.z||0)}e.length>t.count&&Qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ci);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new j(-1/0,-1/0,-1/0),new j(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let o=t[n];Pn.setFromBufferAttribute(o),this.morphTargetsRelative?(ln.addVectors(this.boundingBox.min,Pn.min),this.boundingBox.expandByPoint(ln),ln.addVectors(this.boundingBox.max,Pn.max),this.boundingBox.expandByPoint(ln)):(this.boundingBox.expandByPoint(Pn.min),this.boundingBox.expandByPoint(Pn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ti);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new j,1/0);return}if(e){let n=this.boundingSphere.center;if(Pn.setFromBufferAttribute(e),t)for(let o=0,l=t.length;o<l;o++){let h=t[o];gs.setFromBufferAttribute(h),this.morphTargetsRelative?(ln.addVectors(Pn.min,gs.min),Pn.expandByPoint(ln),ln.addVectors(Pn.max,gs.max),Pn.expandByPoint(ln)):(Pn.expandByPoint(gs.min),Pn.expandByPoint(gs.max))}Pn.getCenter(n);let r=0;for(let o=0,l=e.count;o<l;o++)ln.fromBufferAttribute(e,o),r=Math.max(r,n.distanceToSquared(ln));if(t)for(let o=0,l=t.length;o<l;o++){let h=t[o],f=this.morphTargetsRelative;for(let d=0,m=h.count;d<m;d++)ln.fromBufferAttribute(h,d),f&&(Pr.fromBufferAttribute(e,d),ln.add(Pr)),r=Math.max(r,n.distanceToSquared(ln))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,o=t.uv,l=this.getAttribute("tangent");(l===void 0||l.count!==n.count)&&(l=new Dn(new Float32Array(4*n.count),4),this.setAttribute("tangent",l));let h=[],f=[],d=new Uint8Array(n.count);for(let X=0;X<n.count;X++)h[X]=new j,f[X]=new j;let m=new j,y=new j,g=new j,x=new et,M=new et,R=new et,S=new j,_=new j;function P(X,k,Y){d[X]=d[k]=d[Y]=1,m.fromBufferAttribute(n,X),y.fromBufferAttribute(n,k),g.fromBufferAttribute(n,Y),x.fromBufferAttribute(o,X),M.fromBufferAttribute(o,k),R.fromBufferAttribute(o,Y),y.sub(m),g.sub(m),M.sub(x),R.sub(x);let Z=1/(M.x*R.y-R.x*M.y);isFinite(Z)&&(S.copy(y).multiplyScalar(R.y).addScaledVector(g,-M.y).multiplyScalar(Z),_.copy(g).multiplyScalar(M.x).addScaledVector(y,-R.x).multiplyScalar(Z),h[X].add(S),h[k].add(S),h[Y].add(S),f[X].add(_),f[k].add(_),f[Y].add(_))}let U=this.groups;U.length===0&&(U=[{start:0,count:e.count}]);for(let X=0,k=U.length;X<k;++X){let Y=U[X],Z=Y.start,ee=Y.count;for(let z=Z,ie=Z+ee;z<ie;z+=3)P(e.getX(z+0),e.getX(z+1),e.getX(z+2))}let I=new j,O=new j,N=new j,w=new j;function D(X){N.fromBufferAttribute(r,X),w.copy(N);let k=h[X];I.copy(k),I.sub(N.multiplyScalar(N.dot(k))).normalize(),O.crossVectors(w,k);let Z=O.dot(f[X])<0?-1:1;l.setXYZW(X,I.x,I.y,I.z,Z)}for(let X=0,k=n.count;X<k;++X)d[X]&&D(X);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Dn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let g=0,x=n.count;g<x;g++)n.setXYZ(g,0,0,0);let r=new j,o=new j,l=new j,h=new j,f=new j,d=new j,m=new j,y=new j;if(e)for(let g=0,x=e.count;g<x;g+=3){let M=e.getX(g+0),R=e.getX(g+1),S=e.getX(g+2);r.fromBufferAttribute(t,M),o.fromBufferAttribute(t,R),l.fromBufferAttribute(t,S),m.subVectors(l,o),y.subVectors(r,o),m.cross(y),h.fromBufferAttribute(n,M),f.fromBufferAttribute(n,R),d.fromBufferAttribute(n,S),h.add(m),f.add(m),d.add(m),n.setXYZ(M,h.x,h.y,h.z),n.setXYZ(R,f.x,f.y,f.z),n.setXYZ(S,d.x,d.y,d.z)}else for(let g=0,x=t.count;g<x;g+=3)r.fromBufferAttribute(t,g+0),o.fromBufferAttribute(t,g+1),l.fromBufferAttribute(t,g+2),m.subVectors(l,o),y.subVectors(r,o),m.cross(y),n.setXYZ(g+0,m.x,m.y,m.z),n.setXYZ(g+1,m.x,m.y,m.z),n.setXYZ(g+2,m.x,m.y,m.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)ln.fromBufferAttribute(e,t),ln.normalize(),e.setXYZ(t,ln.x,ln.y,ln.z)}toNonIndexed(){function e(h,f){let d=h.array,m=h.itemSize,y=h.normalized,g=new d.constructor(f.length*m),x=0,M=0;for(let R=0,S=f.length;R<S;R++){h.isInterleavedBufferAttribute?x=f[R]*h.data.stride+h.offset:x=f[R]*m;for(let _=0;_<m;_++)g[M++]=d[x++]}return new Dn(g,m,y)}if(this.index===null)return Qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let h in r){let f=r[h],d=e(f,n);t.setAttribute(h,d)}let o=this.morphAttributes;for(let h in o){let f=[],d=o[h];for(let m=0,y=d.length;m<y;m++){let g=d[m],x=e(g,n);f.push(x)}t.morphAttributes[h]=f}t.morphTargetsRelative=this.morphTargetsRelative;let l=this.groups;for(let h=0,f=l.length;h<f;h++){let d=l[h];t.addGroup(d.start,d.count,d.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let f=this.parameters;for(let d in f)f[d]!==void 0&&(e[d]=f[d]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let f in n){let d=n[f];e.data.attributes[f]=d.toJSON(e.data)}let r={},o=!1;for(let f in this.morphAttributes){let d=this.morphAttributes[f],m=[];for(let y=0,g=d.length;y<g;y++){let x=d[y];m.push(x.toJSON(e.data))}m.length>0&&(r[f]=m,o=!0)}o&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let l=this.groups;l.length>0&&(e.data.groups=JSON.parse(JSON.stringify(l)));let h=this.boundingSphere;return h!==null&&(e.data.boundingSphere=h.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let d in r){let m=r[d];this.setAttribute(d,m.clone(t))}let o=e.morphAttributes;for(let d in o){let m=[],y=o[d];for(let g=0,x=y.length;g<x;g++)m.push(y[g].clone(t));this.morphAttributes[d]=m}this.morphTargetsRelative=e.morphTargetsRelative;let l=e.groups;for(let d=0,m=l.length;d<m;d++){let y=l[d];this.addGroup(y.start,y.count,y.materialIndex)}let h=e.boundingBox;h!==null&&(this.boundingBox=h.clone());let f=e.boundingSphere;return f!==null&&(this.boundingSphere=f.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var wc=new j,Lv=new j,Fv=new ct,In=class{constructor(e=new j(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=wc.subVectors(n,t).cross(Lv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(wc),o=this.normal.dot(r);if(o===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let l=-(e.start.dot(this.normal)+this.constant)/o;return n===!0&&(l<0||l>1)?null:t.copy(e.start).addScaledVector(r,l)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Fv.getNormalMatrix(e),r=this.coplanarPoint(wc).applyMatrix4(e),o=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(o),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Nv=0,hi=class extends jn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Nv++}),this.uuid=Kr(),this.name="",this.type="Material",this.blending=jr,this.side=ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hc,this.blendDst=Wc,this.blendEquation=fr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=Ur,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Pd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=uo,this.stencilZFail=uo,this.stencilZPass=uo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Qe(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(o=>o.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(o){let l=[];for(let h in o){let f=o[h];delete f.metadata,l.push(f)}return l}if(t){let o=r(e.textures),l=r(e.images);o.length>0&&(n.textures=o),l.length>0&&(n.images=l)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new In().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new et().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new et().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let o=0;o!==r;++o)n[o]=t[o].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var bi=new j,Ec=new j,$a=new j,Ya=new j,Gi=class{constructor(e=new j,t=new j(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,bi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=bi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(bi.copy(this.origin).addScaledVector(this.direction,t),bi.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){Ec.copy(e).add(t).multiplyScalar(.5),$a.copy(t).sub(e).normalize(),Ya.copy(this.origin).sub(Ec);let o=e.distanceTo(t)*.5,l=-this.direction.dot($a),h=Ya.dot(this.direction),f=-Ya.dot($a),d=Ya.lengthSq(),m=Math.abs(1-l*l),y,g,x,M;if(m>0)if(y=l*f-h,g=l*h-f,M=o*m,y>=0)if(g>=-M)if(g<=M){let R=1/m;y*=R,g*=R,x=y*(y+l*g+2*h)+g*(l*y+g+2*f)+d}else g=o,y=Math.max(0,-(l*g+h)),x=-y*y+g*(g+2*f)+d;else g=-o,y=Math.max(0,-(l*g+h)),x=-y*y+g*(g+2*f)+d;else g<=-M?(y=Math.max(0,-(-l*o+h)),g=y>0?-o:Math.min(Math.max(-o,-f),o),x=-y*y+g*(g+2*f)+d):g<=M?(y=0,g=Math.min(Math.max(-o,-f),o),x=g*(g+2*f)+d):(y=Math.max(0,-(l*o+h)),g=y>0?o:Math.min(Math.max(-o,-f),o),x=-y*y+g*(g+2*f)+d);else g=l>0?-o:o,y=Math.max(0,-(l*g+h)),x=-y*y+g*(g+2*f)+d;return n&&n.copy(this.origin).addScaledVector(this.direction,y),r&&r.copy(Ec).addScaledVector($a,g),x}intersectSphere(e,t){if(e.radius<0)return null;bi.subVectors(e.center,this.origin);let n=bi.dot(this.direction),r=bi.dot(bi)-n*n,o=e.radius*e.radius;if(r>o)return null;let l=Math.sqrt(o-r),h=n-l,f=n+l;return f<0?null:h<0?this.at(f,t):this.at(h,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,o,l,h,f,d=1/this.direction.x,m=1/this.direction.y,y=1/this.direction.z,g=this.origin;return d>=0?(n=(e.min.x-g.x)*d,r=(e.max.x-g.x)*d):(n=(e.max.x-g.x)*d,r=(e.min.x-g.x)*d),m>=0?(o=(e.min.y-g.y)*m,l=(e.max.y-g.y)*m):(o=(e.max.y-g.y)*m,l=(e.min.y-g.y)*m),n>l||o>r||((o>n||isNaN(n))&&(n=o),(l<r||isNaN(r))&&(r=l),y>=0?(h=(e.min.z-g.z)*y,f=(e.max.z-g.z)*y):(h=(e.max.z-g.z)*y,f=(e.min.z-g.z)*y),n>f||h>r)||((h>n||n!==n)&&(n=h),(f<r||r!==r)&&(r=f),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,bi)!==null}intersectTriangle(e,t,n,r,o){let l=this.origin,h=this.direction,f=h.x,d=h.y,m=h.z,y=e.x-l.x,g=e.y-l.y,x=e.z-l.z,M=t.x-l.x,R=t.y-l.y,S=t.z-l.z,_=n.x-l.x,P=n.y-l.y,U=n.z-l.z,I=Math.abs(f),O=Math.abs(d),N=Math.abs(m),w,D,X,k,Y,Z,ee,z,ie,G,ne,Se;if(I>=O&&I>=N?(X=f,Z=y,ie=M,Se=_,f>=0?(w=d,D=m,k=g,Y=x,ee=R,z=S,G=P,ne=U):(w=m,D=d,k=x,Y=g,ee=S,z=R,G=U,ne=P)):O>=N?(X=d,Z=g,ie=R,Se=P,d>=0?(w=m,D=f,k=x,Y=y,ee=S,z=M,G=U,ne=_):(w=f,D=m,k=y,Y=x,ee=M,z=S,G=_,ne=U)):(X=m,Z=x,ie=S,Se=U,m>=0?(w=f,D=d,k=y,Y=g,ee=M,z=R,G=_,ne=P):(w=d,D=f,k=g,Y=y,ee=R,z=M,G=P,ne=_)),X===0)return null;let re=w/X,H=D/X,ge=1/X,We=k-re*Z,it=Y-H*Z,ue=ee-re*ie,Fe=z-H*ie,Pe=G-re*Se,je=ne-H*Se,Ue=Pe*Fe-je*ue,ot=We*je-it*Pe,Vt=ue*it-Fe*We;if(r){if(Ue<0||ot<0||Vt<0)return null}else if((Ue<0||ot<0||Vt<0)&&(Ue>0||ot>0||Vt>0))return null;let Ke=Ue+ot+Vt;if(Ke===0)return null;let Et=ge*(Ue*Z+ot*ie+Vt*Se);return(Ke>0?Et<0:Et>0)?null:this.at(Et/Ke,o)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Is=class extends hi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new li,this.combine=Wo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},zu=new Lt,lr=new Gi,ja=new Ti,Gu=new j,Za=new j,Ja=new j,Ka=new j,Tc=new j,Qa=new j,Vu=new j,eo=new j,zt=class extends Qt{constructor(e=new En,t=new Is){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,l=r.length;o<l;o++){let h=r[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[h]=o}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,o=n.morphAttributes.position,l=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let h=this.morphTargetInfluences;if(o&&h){Qa.set(0,0,0);for(let f=0,d=o.length;f<d;f++){let m=h[f],y=o[f];m!==0&&(Tc.fromBufferAttribute(y,e),l?Qa.addScaledVector(Tc,m):Qa.addScaledVector(Tc.sub(t),m))}t.add(Qa)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,o=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ja.copy(n.boundingSphere),ja.applyMatrix4(o),lr.copy(e.ray).recast(e.near),!(ja.containsPoint(lr.origin)===!1&&(lr.intersectSphere(ja,Gu)===null||lr.origin.distanceToSquared(Gu)>(e.far-e.near)**2))&&(zu.copy(o).invert(),lr.copy(e.ray).applyMatrix4(zu),!(n.boundingBox!==null&&lr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,lr)))}_computeIntersections(e,t,n){let r,o=this.geometry,l=this.material,h=o.index,f=o.attributes.position,d=o.attributes.uv,m=o.attributes.uv1,y=o.attributes.normal,g=o.groups,x=o.drawRange;if(h!==null)if(Array.isArray(l))for(let M=0,R=g.length;M<R;M++){let S=g[M],_=l[S.materialIndex],P=Math.max(S.start,x.start),U=Math.min(h.count,Math.min(S.start+S.count,x.start+x.count));for(let I=P,O=U;I<O;I+=3){let N=h.getX(I),w=h.getX(I+1),D=h.getX(I+2);r=to(this,_,e,n,d,m,y,N,w,D),r&&(r.faceIndex=Math.floor(I/3),r.face.materialIndex=S.materialIndex,t.push(r))}}else{let M=Math.max(0,x.start),R=Math.min(h.count,x.start+x.count);for(let S=M,_=R;S<_;S+=3){let P=h.getX(S),U=h.getX(S+1),I=h.getX(S+2);r=to(this,l,e,n,d,m,y,P,U,I),r&&(r.faceIndex=Math.floor(S/3),t.push(r))}}else if(f!==void 0)if(Array.isArray(l))for(let M=0,R=g.length;M<R;M++){let S=g[M],_=l[S.materialIndex],P=Math.max(S.start,x.start),U=Math.min(f.count,Math.min(S.start+S.count,x.start+x.count));for(let I=P,O=U;I<O;I+=3){let N=I,w=I+1,D=I+2;r=to(this,_,e,n,d,m,y,N,w,D),r&&(r.faceIndex=Math.floor(I/3),r.face.materialIndex=S.materialIndex,t.push(r))}}else{let M=Math.max(0,x.start),R=Math.min(f.count,x.start+x.count);for(let S=M,_=R;S<_;S+=3){let P=S,U=S+1,I=S+2;r=to(this,l,e,n,d,m,y,P,U,I),r&&(r.faceIndex=Math.floor(S/3),t.push(r))}}}};function Uv(i,e,t,n,r,o,l,h){let f;if(e.side===dn?f=n.intersectTriangle(l,o,r,!0,h):f=n.intersectTriangle(r,o,l,e.side===ji,h),f===null)return null;eo.copy(h),eo.applyMatrix4(i.matrixWorld);let d=t.ray.origin.distanceTo(eo);return d<t.near||d>t.far?null:{distance:d,point:eo.clone(),object:i}}function to(i,e,t,n,r,o,l,h,f,d){i.getVertexPosition(h,Za),i.getVertexPosition(f,Ja),i.getVertexPosition(d,Ka);let m=Uv(i,e,t,n,Za,Ja,Ka,Vu);if(m){let y=new j;zi.getBarycoord(Vu,Za,Ja,Ka,y),r&&(m.uv=zi.getInterpolatedAttribute(r,h,f,d,y,new et)),o&&(m.uv1=zi.getInterpolatedAttribute(o,h,f,d,y,new et)),l&&(m.normal=zi.getInterpolatedAttribute(l,h,f,d,y,new j),m.normal.dot(n.direction)>0&&m.normal.multiplyScalar(-1));let g={a:h,b:f,c:d,normal:new j,materialIndex:0};zi.getNormal(Za,Ja,Ka,g.normal),m.face=g,m.barycoord=y}return m}var Ds=class extends wn{constructor(e=null,t=1,n=1,r,o,l,h,f,d=cn,m=cn,y,g){super(null,l,h,f,d,m,r,o,y,g),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ls=class extends Dn{constructor(e,t,n,r=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Ir=new Lt,Hu=new Lt,no=[],Wu=new ci,Ov=new Lt,_s=new zt,vs=new Ti,Fs=class extends zt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Ls(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<n;r++)this.setMatrixAt(r,Ov)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new ci),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Ir),Wu.copy(e.boundingBox).applyMatrix4(Ir),this.boundingBox.union(Wu)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ti),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Ir),vs.copy(e.boundingSphere).applyMatrix4(Ir),this.boundingSphere.union(vs)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,r=this.morphTexture.source.data.data,o=n.length+1,l=e*o+1;for(let h=0;h<n.length;h++)n[h]=r[l+h]}raycast(e,t){let n=this.matrixWorld,r=this.count;if(_s.geometry=this.geometry,_s.material=this.material,_s.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),vs.copy(this.boundingSphere),vs.applyMatrix4(n),e.ray.intersectsSphere(vs)!==!1))for(let o=0;o<r;o++){this.getMatrixAt(o,Ir),Hu.multiplyMatrices(n,Ir),_s.matrixWorld=Hu,_s.raycast(e,no);for(let l=0,h=no.length;l<h;l++){let f=no[l];f.instanceId=o,f.object=this,t.push(f)}no.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Ls(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,r=n.length+1;this.morphTexture===null&&(this.morphTexture=new Ds(new Float32Array(r*this.count),r,this.count,Jo,Vn));let o=this.morphTexture.source.data.data,l=0;for(let d=0;d<n.length;d++)l+=n[d];let h=this.geometry.morphTargetsRelative?1:1-l,f=r*e;return o[f]=h,o.set(n,f+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},cr=new Ti,Bv=new et(.5,.5),io=new j,Vi=class{constructor(e=new In,t=new In,n=new In,r=new In,o=new In,l=new In){this.planes=[e,t,n,r,o,l]}set(e,t,n,r,o,l){let h=this.planes;return h[0].copy(e),h[1].copy(t),h[2].copy(n),h[3].copy(r),h[4].copy(o),h[5].copy(l),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=zn,n=!1){let r=this.planes,o=e.elements,l=o[0],h=o[1],f=o[2],d=o[3],m=o[4],y=o[5],g=o[6],x=o[7],M=o[8],R=o[9],S=o[10],_=o[11],P=o[12],U=o[13],I=o[14],O=o[15];if(r[0].setComponents(d-l,x-m,_-M,O-P).normalize(),r[1].setComponents(d+l,x+m,_+M,O+P).normalize(),r[2].setComponents(d+h,x+y,_+R,O+U).normalize(),r[3].setComponents(d-h,x-y,_-R,O-U).normalize(),n)r[4].setComponents(f,g,S,I).normalize(),r[5].setComponents(d-f,x-g,_-S,O-I).normalize();else if(r[4].setComponents(d-f,x-g,_-S,O-I).normalize(),t===zn)r[5].setComponents(d+f,x+g,_+S,O+I).normalize();else if(t===Br)r[5].setComponents(f,g,S,I).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),cr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),cr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(cr)}intersectsSprite(e){cr.center.set(0,0,0);let t=Bv.distanceTo(e.center);return cr.radius=.7071067811865476+t,cr.applyMatrix4(e.matrixWorld),this.intersectsSphere(cr)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let o=0;o<6;o++)if(t[o].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(io.x=r.normal.x>0?e.max.x:e.min.x,io.y=r.normal.y>0?e.max.y:e.min.y,io.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(io)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Xu=new Lt,Eo=class i{constructor(){this.coordinateSystem=zn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let o=t[r];Xu.multiplyMatrices(o.projectionMatrix,o.matrixWorldInverse),n[r]===void 0&&(n[r]=new Vi),n[r].setFromProjectionMatrix(Xu,o.coordinateSystem,o.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Vi),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ns=class extends hi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},To=new j,Ao=new j,qu=new Lt,ys=new Gi,ro=new Ti,Ac=new j,$u=new j,Co=class extends Qt{constructor(e=new En,t=new Ns){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let r=1,o=t.count;r<o;r++)To.fromBufferAttribute(t,r-1),Ao.fromBufferAttribute(t,r),n[r]=n[r-1],n[r]+=To.distanceTo(Ao);e.setAttribute("lineDistance",new Xt(n,1))}else Qe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,o=e.params.Line.threshold,l=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ro.copy(n.boundingSphere),ro.applyMatrix4(r),ro.radius+=o,e.ray.intersectsSphere(ro)===!1)return;qu.copy(r).invert(),ys.copy(e.ray).applyMatrix4(qu);let h=o/((this.scale.x+this.scale.y+this.scale.z)/3),f=h*h,d=this.isLineSegments?2:1,m=n.index,g=n.attributes.position;if(m!==null){let x=Math.max(0,l.start),M=Math.min(m.count,l.start+l.count);for(let R=x,S=M-1;R<S;R+=d){let _=m.getX(R),P=m.getX(R+1),U=so(this,e,ys,f,_,P,R);U&&t.push(U)}if(this.isLineLoop){let R=m.getX(M-1),S=m.getX(x),_=so(this,e,ys,f,R,S,M-1);_&&t.push(_)}}else{let x=Math.max(0,l.start),M=Math.min(g.count,l.start+l.count);for(let R=x,S=M-1;R<S;R+=d){let _=so(this,e,ys,f,R,R+1,R);_&&t.push(_)}if(this.isLineLoop){let R=so(this,e,ys,f,M-1,x,M-1);R&&t.push(R)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,l=r.length;o<l;o++){let h=r[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[h]=o}}}}};function so(i,e,t,n,r,o,l){let h=i.geometry.attributes.position;if(To.fromBufferAttribute(h,r),Ao.fromBufferAttribute(h,o),t.distanceSqToSegment(To,Ao,Ac,$u)>n)return;Ac.applyMatrix4(i.matrixWorld);let d=e.ray.origin.distanceTo(Ac);if(!(d<e.near||d>e.far))return{distance:d,point:$u.clone().applyMatrix4(i.matrixWorld),index:l,face:null,faceIndex:null,barycoord:null,object:i}}var Us=class extends wn{constructor(e=[],t=pr,n,r,o,l,h,f,d,m){super(e,t,n,r,o,l,h,f,d,m),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Os=class extends wn{constructor(e,t,n,r,o,l,h,f,d){super(e,t,n,r,o,l,h,f,d),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ai=class extends wn{constructor(e,t,n=Zn,r,o,l,h=cn,f=cn,d,m=Ei,y=1){if(m!==Ei&&m!==Pi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let g={width:e,height:t,depth:y};super(g,r,o,l,h,f,m,n,d),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Gr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Bs=class extends Ai{constructor(e,t=Zn,n=pr,r,o,l=cn,h=cn,f,d=Ei){let m={width:e,height:e,depth:1},y=[m,m,m,m,m,m];super(e,e,t,n,r,o,l,h,f,d),this.image=y,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ks=class extends wn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ui=class i extends En{constructor(e=1,t=1,n=1,r=1,o=1,l=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:o,depthSegments:l};let h=this;r=Math.floor(r),o=Math.floor(o),l=Math.floor(l);let f=[],d=[],m=[],y=[],g=0,x=0;M("z","y","x",-1,-1,n,t,e,l,o,0),M("z","y","x",1,-1,n,t,-e,l,o,1),M("x","z","y",1,1,e,n,t,r,l,2),M("x","z","y",1,-1,e,n,-t,r,l,3),M("x","y","z",1,-1,e,t,n,r,o,4),M("x","y","z",-1,-1,e,t,-n,r,o,5),this.setIndex(f),this.setAttribute("position",new Xt(d,3)),this.setAttribute("normal",new Xt(m,3)),this.setAttribute("uv",new Xt(y,2));function M(R,S,_,P,U,I,O,N,w,D,X){let k=I/w,Y=O/D,Z=I/2,ee=O/2,z=N/2,ie=w+1,G=D+1,ne=0,Se=0,re=new j;for(let H=0;H<G;H++){let ge=H*Y-ee;for(let We=0;We<ie;We++){let it=We*k-Z;re[R]=it*P,re[S]=ge*U,re[_]=z,d.push(re.x,re.y,re.z),re[R]=0,re[S]=0,re[_]=N>0?1:-1,m.push(re.x,re.y,re.z),y.push(We/w),y.push(1-H/D),ne+=1}}for(let H=0;H<D;H++)for(let ge=0;ge<w;ge++){let We=g+ge+ie*H,it=g+ge+ie*(H+1),ue=g+(ge+1)+ie*(H+1),Fe=g+(ge+1)+ie*H;f.push(We,it,Fe),f.push(it,ue,Fe),Se+=6}h.addGroup(x,Se,X),x+=Se,g+=ne}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},zs=class i extends En{constructor(e=1,t=1,n=4,r=8,o=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:r,heightSegments:o},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),r=Math.max(3,Math.floor(r)),o=Math.max(1,Math.floor(o));let l=[],h=[],f=[],d=[],m=t/2,y=Math.PI/2*e,g=t,x=2*y+g,M=n*2+o,R=r+1,S=new j,_=new j;for(let P=0;P<=M;P++){let U=0,I=0,O=0,N=0;if(P<=n){let X=P/n,k=X*Math.PI/2;I=-m-e*Math.cos(k),O=e*Math.sin(k),N=-e*Math.cos(k),U=X*y}else if(P<=n+o){let X=(P-n)/o;I=-m+X*t,O=e,N=0,U=y+X*g}else{let X=(P-n-o)/n,k=X*Math.PI/2;I=m+e*Math.sin(k),O=e*Math.cos(k),N=e*Math.sin(k),U=y+g+X*y}let w=Math.max(0,Math.min(1,U/x)),D=0;P===0?D=.5/r:P===M&&(D=-.5/r);for(let X=0;X<=r;X++){let k=X/r,Y=k*Math.PI*2,Z=Math.sin(Y),ee=Math.cos(Y);_.x=-O*ee,_.y=I,_.z=O*Z,h.push(_.x,_.y,_.z),S.set(-O*ee,N,O*Z),S.normalize(),f.push(S.x,S.y,S.z),d.push(k+D,w)}if(P>0){let X=(P-1)*R;for(let k=0;k<r;k++){let Y=X+k,Z=X+k+1,ee=P*R+k,z=P*R+k+1;l.push(Y,Z,ee),l.push(Z,z,ee)}}}this.setIndex(l),this.setAttribute("position",new Xt(h,3)),this.setAttribute("normal",new Xt(f,3)),this.setAttribute("uv",new Xt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var Wr=class i extends En{constructor(e=1,t=1,n=1,r=32,o=1,l=!1,h=0,f=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:r,heightSegments:o,openEnded:l,thetaStart:h,thetaLength:f};let d=this;r=Math.floor(r),o=Math.floor(o);let m=[],y=[],g=[],x=[],M=0,R=[],S=n/2,_=0;P(),l===!1&&(e>0&&U(!0),t>0&&U(!1)),this.setIndex(m),this.setAttribute("position",new Xt(y,3)),this.setAttribute("normal",new Xt(g,3)),this.setAttribute("uv",new Xt(x,2));function P(){let I=new j,O=new j,N=0,w=(t-e)/n;for(let D=0;D<=o;D++){let X=[],k=D/o,Y=k*(t-e)+e;for(let Z=0;Z<=r;Z++){let ee=Z/r,z=ee*f+h,ie=Math.sin(z),G=Math.cos(z);O.x=Y*ie,O.y=-k*n+S,O.z=Y*G,y.push(O.x,O.y,O.z),I.set(ie,w,G).normalize(),g.push(I.x,I.y,I.z),x.push(ee,1-k),X.push(M++)}R.push(X)}for(let D=0;D<r;D++)for(let X=0;X<o;X++){let k=R[X][D],Y=R[X+1][D],Z=R[X+1][D+1],ee=R[X][D+1];(e>0||X!==0)&&(m.push(k,Y,ee),N+=3),(t>0||X!==o-1)&&(m.push(Y,Z,ee),N+=3)}d.addGroup(_,N,0),_+=N}function U(I){let O=M,N=new et,w=new j,D=0,X=I===!0?e:t,k=I===!0?1:-1;for(let Z=1;Z<=r;Z++)y.push(0,S*k,0),g.push(0,k,0),x.push(.5,.5),M++;let Y=M;for(let Z=0;Z<=r;Z++){let z=Z/r*f+h,ie=Math.cos(z),G=Math.sin(z);w.x=X*G,w.y=S*k,w.z=X*ie,y.push(w.x,w.y,w.z),g.push(0,k,0),N.x=ie*.5+.5,N.y=G*.5*k+.5,x.push(N.x,N.y),M++}for(let Z=0;Z<r;Z++){let ee=O+Z,z=Y+Z;I===!0?m.push(z,z+1,ee):m.push(z+1,z,ee),D+=3}d.addGroup(_,D,I===!0?1:2),_+=D}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Ro=class i extends Wr{constructor(e=1,t=1,n=32,r=1,o=!1,l=0,h=Math.PI*2){super(0,e,t,n,r,o,l,h),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:r,openEnded:o,thetaStart:l,thetaLength:h}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Hi=class i extends En{constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let o=e/2,l=t/2,h=Math.floor(n),f=Math.floor(r),d=h+1,m=f+1,y=e/h,g=t/f,x=[],M=[],R=[],S=[];for(let _=0;_<m;_++){let P=_*g-l;for(let U=0;U<d;U++){let I=U*y-o;M.push(I,-P,0),R.push(0,0,1),S.push(U/h),S.push(1-_/f)}}for(let _=0;_<f;_++)for(let P=0;P<h;P++){let U=P+d*_,I=P+d*(_+1),O=P+1+d*(_+1),N=P+1+d*_;x.push(U,I,N),x.push(I,O,N)}this.setIndex(x),this.setAttribute("position",new Xt(M,3)),this.setAttribute("normal",new Xt(R,3)),this.setAttribute("uv",new Xt(S,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Xr=class i extends En{constructor(e=1,t=32,n=16,r=0,o=Math.PI*2,l=0,h=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:r,phiLength:o,thetaStart:l,thetaLength:h},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let f=Math.min(l+h,Math.PI),d=0,m=[],y=new j,g=new j,x=[],M=[],R=[],S=[];for(let _=0;_<=n;_++){let P=[],U=_/n,I=l+U*h,O=e*Math.cos(I),N=Math.sqrt(e*e-O*O),w=0;_===0&&l===0?w=.5/t:_===n&&f===Math.PI&&(w=-.5/t);for(let D=0;D<=t;D++){let X=D/t,k=r+X*o;y.x=-N*Math.cos(k),y.y=O,y.z=N*Math.sin(k),M.push(y.x,y.y,y.z),g.copy(y).normalize(),R.push(g.x,g.y,g.z),S.push(X+w,1-U),P.push(d++)}m.push(P)}for(let _=0;_<n;_++)for(let P=0;P<t;P++){let U=m[_][P+1],I=m[_][P],O=m[_+1][P],N=m[_+1][P+1];(_!==0||l>0)&&x.push(U,I,N),(_!==n-1||f<Math.PI)&&x.push(I,O,N)}this.setIndex(x),this.setAttribute("position",new Xt(M,3)),this.setAttribute("normal",new Xt(R,3)),this.setAttribute("uv",new Xt(S,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function gr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(Yu(r))r.isRenderTargetTexture?(Qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(Yu(r[0])){let o=[];for(let l=0,h=r.length;l<h;l++)o[l]=r[l].clone();e[t][n]=o}else e[t][n]=r.slice();else e[t][n]=r}}return e}function vn(i){let e={};for(let t=0;t<i.length;t++){let n=gr(i[t]);for(let r in n)e[r]=n[r]}return e}function Yu(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function kv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function fh(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Wd={clone:gr,merge:vn},zv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Gv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,di=class extends hi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=zv,this.fragmentShader=Gv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=gr(e.uniforms),this.uniformsGroups=kv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let l=this.uniforms[r].value;l&&l.isTexture?t.uniforms[r]={type:"t",value:l.toJSON(e).uuid}:l&&l.isColor?t.uniforms[r]={type:"c",value:l.getHex()}:l&&l.isVector2?t.uniforms[r]={type:"v2",value:l.toArray()}:l&&l.isVector3?t.uniforms[r]={type:"v3",value:l.toArray()}:l&&l.isVector4?t.uniforms[r]={type:"v4",value:l.toArray()}:l&&l.isMatrix3?t.uniforms[r]={type:"m3",value:l.toArray()}:l&&l.isMatrix4?t.uniforms[r]={type:"m4",value:l.toArray()}:t.uniforms[r]={value:l}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new ht().setHex(r.value);break;case"v2":this.uniforms[n].value=new et().fromArray(r.value);break;case"v3":this.uniforms[n].value=new j().fromArray(r.value);break;case"v4":this.uniforms[n].value=new Gt().fromArray(r.value);break;case"m3":this.uniforms[n].value=new ct().fromArray(r.value);break;case"m4":this.uniforms[n].value=new Lt().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Po=class extends di{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ci=class extends hi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=aa,this.normalScale=new et(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new li,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Gs=class extends hi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=aa,this.normalScale=new et(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new li,this.combine=Wo,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Io=class extends hi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Cd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Do=class extends hi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Dr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function ao(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Wi=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],o=t[n-1];e:{t:{let l;n:{i:if(!(e<r)){for(let h=n+2;;){if(r===void 0){if(e<o)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===h)break;if(o=r,r=t[++n],e<r)break t}l=t.length;break n}if(!(e>=o)){let h=t[1];e<h&&(n=2,o=h);for(let f=n-2;;){if(o===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===f)break;if(r=o,o=t[--n-1],e>=o)break t}l=n,n=0;break n}break e}for(;n<l;){let h=n+l>>>1;e<t[h]?l=h:n=h+1}if(r=t[n],o=t[n-1],o===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,o,r)}return this.interpolate_(n,o,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,o=e*r;for(let l=0;l!==r;++l)t[l]=n[o+l];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Lo=class extends Wi{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ic,endingEnd:Ic}}intervalChanged_(e,t,n){let r=this.parameterPositions,o=e-2,l=e+1,h=r[o],f=r[l];if(h===void 0)switch(this.getSettings_().endingStart){case Dc:o=e,h=2*t-n;break;case Lc:o=r.length-2,h=t+r[o]-r[o+1];break;default:o=e,h=n}if(f===void 0)switch(this.getSettings_().endingEnd){case Dc:l=e,f=2*n-t;break;case Lc:l=1,f=n+r[1]-r[0];break;default:l=e-1,f=t}let d=(n-t)*.5,m=this.valueSize;this._weightPrev=d/(t-h),this._weightNext=d/(f-n),this._offsetPrev=o*m,this._offsetNext=l*m}interpolate_(e,t,n,r){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=this._offsetPrev,y=this._offsetNext,g=this._weightPrev,x=this._weightNext,M=(n-t)/(r-t),R=M*M,S=R*M,_=-g*S+2*g*R-g*M,P=(1+g)*S+(-1.5-2*g)*R+(-.5+g)*M+1,U=(-1-x)*S+(1.5+x)*R+.5*M,I=x*S-x*R;for(let O=0;O!==h;++O)o[O]=_*l[m+O]+P*l[d+O]+U*l[f+O]+I*l[y+O];return o}},Fo=class extends Wi{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=(n-t)/(r-t),y=1-m;for(let g=0;g!==h;++g)o[g]=l[d+g]*y+l[f+g]*m;return o}},No=class extends Wi{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Uo=class extends Wi{interpolate_(e,t,n,r){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=e*h,d=f-h,m=this.inTangents,y=this.outTangents;if(!m||!y){let M=(n-t)/(r-t),R=1-M;for(let S=0;S!==h;++S)o[S]=l[d+S]*R+l[f+S]*M;return o}let g=h*2,x=e-1;for(let M=0;M!==h;++M){let R=l[d+M],S=l[f+M],_=x*g+M*2,P=y[_],U=y[_+1],I=e*g+M*2,O=m[I],N=m[I+1],w=Hv(n,t,P,O,r);o[M]=Xd(w,R,U,N,S)}return o}};function Xd(i,e,t,n,r){let o=1-i;return o*o*o*e+3*o*o*i*t+3*o*i*i*n+i*i*i*r}function Vv(i,e,t,n,r){let o=1-i;return 3*o*o*(t-e)+6*o*i*(n-t)+3*i*i*(r-n)}function Hv(i,e,t,n,r){let o=(i-e)/(r-e);for(let l=0;l<8;l++){let h=Xd(o,e,t,n,r)-i;if(Math.abs(h)<1e-10)break;let f=Vv(o,e,t,n,r);if(Math.abs(f)<1e-10)break;o=Math.max(0,Math.min(1,o-h/f))}return o}var Fn=class{constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Dr(t,this.TimeBufferType),this.values=Dr(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Dr(e.times,Array),values:Dr(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),ao(e.settings)&&(n.settings={inTangents:Dr(e.settings.inTangents,Array),outTangents:Dr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new No(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Fo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Lo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Uo(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case bs:t=this.InterpolantFactoryMethodDiscrete;break;case So:t=this.InterpolantFactoryMethodLinear;break;case ho:t=this.InterpolantFactoryMethodSmooth;break;case Pc:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return bs;case this.InterpolantFactoryMethodLinear:return So;case this.InterpolantFactoryMethodSmooth:return ho;case this.InterpolantFactoryMethodBezier:return Pc}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;ao(this.settings)&&(ju(this.settings.inTangents,e),ju(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;ao(this.settings)&&(Zu(this.settings.inTangents,e),Zu(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,o=0,l=r-1;for(;o!==r&&n[o]<e;)++o;for(;l!==-1&&n[l]>t;)--l;if(++l,o!==0||l!==r){o>=l&&(l=Math.max(l,1),o=l-1);let h=this.getValueSize();this.times=n.slice(o,l),this.values=this.values.slice(o*h,l*h)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,o=n.length;o===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let l=null;for(let h=0;h!==o;h++){let f=n[h];if(typeof f=="number"&&isNaN(f)){nt("KeyframeTrack: Time is not a valid number.",this,h,f),e=!1;break}if(l!==null&&l>f){nt("KeyframeTrack: Out of order keys.",this,h,f,l),e=!1;break}l=f}if(r!==void 0&&rv(r))for(let h=0,f=r.length;h!==f;++h){let d=r[h];if(isNaN(d)){nt("KeyframeTrack: Value is not a valid number.",this,h,d),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===ho,o=e.length-1,l=1;for(let h=1;h<o;++h){let f=!1,d=e[h],m=e[h+1];if(d!==m&&(h!==1||d!==e[0]))if(r)f=!0;else{let y=h*n,g=y-n,x=y+n;for(let M=0;M!==n;++M){let R=t[y+M];if(R!==t[g+M]||R!==t[x+M]){f=!0;break}}}if(f){if(h!==l){e[l]=e[h];let y=h*n,g=l*n;for(let x=0;x!==n;++x)t[g+x]=t[y+x]}++l}}if(o>0){e[l]=e[o];for(let h=o*n,f=l*n,d=0;d!==n;++d)t[f+d]=t[h+d];++l}return l!==e.length?(this.times=e.slice(0,l),this.values=t.slice(0,l*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,ao(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function ju(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Zu(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Fn.prototype.ValueTypeName="";Fn.prototype.TimeBufferType=Float32Array;Fn.prototype.ValueBufferType=Float32Array;Fn.prototype.DefaultInterpolation=So;var Xi=class extends Fn{constructor(e,t,n){super(e,t,n)}};Xi.prototype.ValueTypeName="bool";Xi.prototype.ValueBufferType=Array;Xi.prototype.DefaultInterpolation=bs;Xi.prototype.InterpolantFactoryMethodLinear=void 0;Xi.prototype.InterpolantFactoryMethodSmooth=void 0;var Oo=class extends Fn{constructor(e,t,n,r){super(e,t,n,r)}};Oo.prototype.ValueTypeName="color";var Bo=class extends Fn{constructor(e,t,n,r){super(e,t,n,r)}};Bo.prototype.ValueTypeName="number";var ko=class extends Wi{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let o=this.resultBuffer,l=this.sampleValues,h=this.valueSize,f=(n-t)/(r-t),d=e*h;for(let m=d+h;d!==m;d+=4)bn.slerpFlat(o,0,l,d-h,l,d,f);return o}},Vs=class extends Fn{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new ko(this.times,this.values,this.getValueSize(),e)}};Vs.prototype.ValueTypeName="quaternion";Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var qi=class extends Fn{constructor(e,t,n){super(e,t,n)}};qi.prototype.ValueTypeName="string";qi.prototype.ValueBufferType=Array;qi.prototype.DefaultInterpolation=bs;qi.prototype.InterpolantFactoryMethodLinear=void 0;qi.prototype.InterpolantFactoryMethodSmooth=void 0;var zo=class extends Fn{constructor(e,t,n,r){super(e,t,n,r)}};zo.prototype.ValueTypeName="vector";var Go=class{constructor(e,t,n){let r=this,o=!1,l=0,h=0,f,d=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(m){h++,o===!1&&r.onStart!==void 0&&r.onStart(m,l,h),o=!0},this.itemEnd=function(m){l++,r.onProgress!==void 0&&r.onProgress(m,l,h),l===h&&(o=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(m){r.onError!==void 0&&r.onError(m)},this.resolveURL=function(m){return m=m.normalize("NFC"),f?f(m):m},this.setURLModifier=function(m){return f=m,this},this.addHandler=function(m,y){return d.push(m,y),this},this.removeHandler=function(m){let y=d.indexOf(m);return y!==-1&&d.splice(y,2),this},this.getHandler=function(m){for(let y=0,g=d.length;y<g;y+=2){let x=d[y],M=d[y+1];if(x.global&&(x.lastIndex=0),x.test(m))return M}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},qd=new Go,Vo=class{constructor(e){this.manager=e!==void 0?e:qd,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,o){n.load(e,r,t,o)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Vo.DEFAULT_MATERIAL_NAME="__DEFAULT";var Hs=class extends Qt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Cc=new Lt,Ju=new j,Ku=new j,Ws=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new et(512,512),this.mapType=Tn,this.map=null,this.mapPass=null,this.matrix=new Lt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Vi,this._frameExtents=new et(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Ju.setFromMatrixPosition(e.matrixWorld),t.position.copy(Ju),Ku.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Ku),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,r){Cc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Cc,e.coordinateSystem,e.reversedDepth);let o=this._frameExtents,l=r?r.z/o.x:1,h=r?r.w/o.y:1,f=r?r.x/o.x:0,d=r?r.y/o.y:0;e.coordinateSystem===Br||e.reversedDepth?t.set(.5*l,0,0,.5*l+f,0,.5*h,0,.5*h+d,0,0,1,0,0,0,0,1):t.set(.5*l,0,0,.5*l+f,0,.5*h,0,.5*h+d,0,0,.5,.5,0,0,0,1),t.multiply(Cc)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},oo=new j,lo=new bn,ai=new j,Xs=class extends Qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Lt,this.projectionMatrix=new Lt,this.projectionMatrixInverse=new Lt,this.coordinateSystem=zn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(oo,lo,ai),ai.x===1&&ai.y===1&&ai.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oo,lo,ai.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(oo,lo,ai),ai.x===1&&ai.y===1&&ai.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oo,lo,ai.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ki=new j,Qu=new et,ed=new et,_n=class extends Xs{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=zr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ss*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return zr*2*Math.atan(Math.tan(Ss*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){ki.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ki.x,ki.y).multiplyScalar(-e/ki.z),ki.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ki.x,ki.y).multiplyScalar(-e/ki.z)}getViewSize(e,t){return this.getViewBounds(e,Qu,ed),t.subVectors(ed,Qu)}setViewOffset(e,t,n,r,o,l){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=o,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ss*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,o=-.5*r,l=this.view;if(this.view!==null&&this.view.enabled){let f=l.fullWidth,d=l.fullHeight;o+=l.offsetX*r/f,t-=l.offsetY*n/d,r*=l.width/f,n*=l.height/d}let h=this.filmOffset;h!==0&&(o+=e*h/this.getFilmWidth()),this.projectionMatrix.makePerspective(o,o+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Fc=class extends Ws{constructor(){super(new _n(90,1,.5,500)),this.isPointLightShadow=!0}},qs=class extends Hs{constructor(e,t,n=0,r=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=r,this.shadow=new Fc}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},$s=class extends Xs{constructor(e=-1,t=1,n=1,r=-1,o=.1,l=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=o,this.far=l,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,o,l){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=o,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,o=n-e,l=n+e,h=r+t,f=r-t;if(this.view!==null&&this.view.enabled){let d=(this.right-this.left)/this.view.fullWidth/this.zoom,m=(this.top-this.bottom)/this.view.fullHeight/this.zoom;o+=d*this.view.offsetX,l=o+d*this.view.width,h-=m*this.view.offsetY,f=h-m*this.view.height}this.projectionMatrix.makeOrthographic(o,l,h,f,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Nc=class extends Ws{constructor(){super(new $s(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ys=class extends Hs{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.shadow=new Nc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Lr=-90,Fr=1,qr=class extends Qt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new _n(Lr,Fr,e,t);r.layers=this.layers,this.add(r);let o=new _n(Lr,Fr,e,t);o.layers=this.layers,this.add(o);let l=new _n(Lr,Fr,e,t);l.layers=this.layers,this.add(l);let h=new _n(Lr,Fr,e,t);h.layers=this.layers,this.add(h);let f=new _n(Lr,Fr,e,t);f.layers=this.layers,this.add(f);let d=new _n(Lr,Fr,e,t);d.layers=this.layers,this.add(d)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,o,l,h,f]=t;for(let d of t)this.remove(d);if(e===zn)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),o.up.set(0,0,-1),o.lookAt(0,1,0),l.up.set(0,0,1),l.lookAt(0,-1,0),h.up.set(0,1,0),h.lookAt(0,0,1),f.up.set(0,1,0),f.lookAt(0,0,-1);else if(e===Br)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),o.up.set(0,0,1),o.lookAt(0,1,0),l.up.set(0,0,-1),l.lookAt(0,-1,0),h.up.set(0,-1,0),h.lookAt(0,0,1),f.up.set(0,-1,0),f.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let d of t)this.add(d),d.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[o,l,h,f,d,m]=this.children,y=e.getRenderTarget(),g=e.getActiveCubeFace(),x=e.getActiveMipmapLevel(),M=e.xr.enabled;e.xr.enabled=!1;let R=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let S=!1;e.isWebGLRenderer===!0?S=e.state.buffers.depth.getReversed():S=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,1,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,2,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(n,3,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,f),e.setRenderTarget(n,4,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,d),n.texture.mipmapsAutoUpdate=R,e.setRenderTarget(n,5,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,m),e.setRenderTarget(y,g,x),e.xr.enabled=M,n.texture.needsPMREMUpdate=!0}},Ho=class extends _n{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ph="\\[\\]\\.:\\/",Wv=new RegExp("["+ph+"]","g"),mh="[^"+ph+"]",Xv="[^"+ph.replace("\\.","")+"]",qv=/((?:WC+[\/:])*)/.source.replace("WC",mh),$v=/(WCOD+)?/.source.replace("WCOD",Xv),Yv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",mh),jv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",mh),Zv=new RegExp("^"+qv+$v+Yv+jv+"$"),Jv=["material","materials","bones","map"],Uc=class{constructor(e,t,n){let r=n||kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,o=n.length;r!==o;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Wv,"")}static parseTrackName(e){let t=Zv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let o=n.nodeName.substring(r+1);Jv.indexOf(o)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=o)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(o){for(let l=0;l<o.length;l++){let h=o[l];if(h.name===t||h.uuid===t)return h;let f=n(h.children);if(f)return f}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,o=n.length;r!==o;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,o=n.length;r!==o;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,o=n.length;r!==o;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,o=n.length;r!==o;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,o=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let d=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let m=0;m<e.length;m++)if(e[m].name===d){d=m;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(d!==void 0){if(e[d]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[d]}}let l=e[r];if(l===void 0){let d=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+d+"."+r+" but it wasn't found.",e);return}let h=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?h=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(h=this.Versioning.MatrixWorldNeedsUpdate);let f=this.BindingType.Direct;if(o!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[o]!==void 0&&(o=e.morphTargetDictionary[o])}f=this.BindingType.ArrayElement,this.resolvedProperty=l,this.propertyIndex=o}else l.fromArray!==void 0&&l.toArray!==void 0?(f=this.BindingType.HasFromToArray,this.resolvedProperty=l):Array.isArray(l)?(f=this.BindingType.EntireArray,this.resolvedProperty=l):this.propertyName=r;this.getValue=this.GetterByBindingType[f],this.setValue=this.SetterByBindingTypeAndVersioning[f][h]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};kt.Composite=Uc;kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};kt.prototype.GetterByBindingType=[kt.prototype._getValue_direct,kt.prototype._getValue_array,kt.prototype._getValue_arrayElement,kt.prototype._getValue_toArray];kt.prototype.SetterByBindingTypeAndVersioning=[[kt.prototype._setValue_direct,kt.prototype._setValue_direct_setNeedsUpdate,kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_array,kt.prototype._setValue_array_setNeedsUpdate,kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_arrayElement,kt.prototype._setValue_arrayElement_setNeedsUpdate,kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_fromArray,kt.prototype._setValue_fromArray_setNeedsUpdate,kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var $w=new Float32Array(1);var td=new Lt,js=class{constructor(e,t,n=0,r=1/0){this.ray=new Gi(e,t),this.near=n,this.far=r,this.camera=null,this.layers=new Vr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return td.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(td),this}intersectObject(e,t=!0,n=[]){return Oc(e,this,n,t),n.sort(nd),n}intersectObjects(e,t=!0,n=[]){for(let r=0,o=e.length;r<o;r++)Oc(e[r],this,n,t);return n.sort(nd),n}};function nd(i,e){return i.distance-e.distance}function Oc(i,e,t,n){let r=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(r=!1),r===!0&&n===!0){let o=i.children;for(let l=0,h=o.length;l<h;l++)Oc(o[l],e,t,!0)}}var $r=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(yt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Bc=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let o=this.elements;return o[0]=e,o[2]=t,o[1]=n,o[3]=r,this}};var id=new j,co,Rc,Zs=class extends Qt{constructor(e=new j(0,0,1),t=new j(0,0,0),n=1,r=16776960,o=n*.2,l=o*.2){super(),this.type="ArrowHelper",co===void 0&&(co=new En,co.setAttribute("position",new Xt([0,0,0,0,1,0],3)),Rc=new Ro(.5,1,5,1),Rc.translate(0,-.5,0)),this.position.copy(t),this.line=new Co(co,new Ns({color:r,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new zt(Rc,new Is({color:r,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,o,l)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{id.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(id,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var Js=class extends jn{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function gh(i,e,t,n){let r=Kv(n);switch(t){case nh:return i*e;case Jo:return i*e/r.components*r.byteLength;case Ko:return i*e/r.components*r.byteLength;case Zi:return i*e*2/r.components*r.byteLength;case Qo:return i*e*2/r.components*r.byteLength;case ih:return i*e*3/r.components*r.byteLength;case Kn:return i*e*4/r.components*r.byteLength;case el:return i*e*4/r.components*r.byteLength;case ea:case ta:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case na:case ia:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case nl:case rl:return Math.max(i,16)*Math.max(e,8)/4;case tl:case il:return Math.max(i,8)*Math.max(e,8)/2;case sl:case al:case ll:case cl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ol:case ra:case hl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ul:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case dl:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case fl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case pl:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ml:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case gl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case _l:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case vl:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case yl:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case xl:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Sl:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Ml:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case bl:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case wl:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case El:case Tl:case Al:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Cl:case Rl:return Math.ceil(i/4)*Math.ceil(e/4)*8;case sa:case Pl:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Kv(i){switch(i){case Tn:case Kc:return{byteLength:1,components:1};case Jr:case Qc:case Jn:return{byteLength:2,components:1};case jo:case Zo:return{byteLength:2,components:4};case Zn:case Yo:case Vn:return{byteLength:4,components:1};case eh:case th:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function mf(){let i=null,e=!1,t=null,n=null;function r(o,l){n=i.requestAnimationFrame(r),t(o,l)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(o){t=o},setContext:function(o){i=o}}}function ey(i){let e=new WeakMap;function t(h,f){let d=h.array,m=h.usage,y=d.byteLength,g=i.createBuffer();i.bindBuffer(f,g),i.bufferData(f,d,m),h.onUploadCallback();let x;if(d instanceof Float32Array)x=i.FLOAT;else if(typeof Float16Array<"u"&&d instanceof Float16Array)x=i.HALF_FLOAT;else if(d instanceof Uint16Array)h.isFloat16BufferAttribute?x=i.HALF_FLOAT:x=i.UNSIGNED_SHORT;else if(d instanceof Int16Array)x=i.SHORT;else if(d instanceof Uint32Array)x=i.UNSIGNED_INT;else if(d instanceof Int32Array)x=i.INT;else if(d instanceof Int8Array)x=i.BYTE;else if(d instanceof Uint8Array)x=i.UNSIGNED_BYTE;else if(d instanceof Uint8ClampedArray)x=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+d);return{buffer:g,type:x,bytesPerElement:d.BYTES_PER_ELEMENT,version:h.version,size:y}}function n(h,f,d){let m=f.array,y=f.updateRanges;if(i.bindBuffer(d,h),y.length===0)i.bufferSubData(d,0,m);else{y.sort((x,M)=>x.start-M.start);let g=0;for(let x=1;x<y.length;x++){let M=y[g],R=y[x];R.start<=M.start+M.count+1?M.count=Math.max(M.count,R.start+R.count-M.start):(++g,y[g]=R)}y.length=g+1;for(let x=0,M=y.length;x<M;x++){let R=y[x];i.bufferSubData(d,R.start*m.BYTES_PER_ELEMENT,m,R.start,R.count)}f.clearUpdateRanges()}f.onUploadCallback()}function r(h){return h.isInterleavedBufferAttribute&&(h=h.data),e.get(h)}function o(h){h.isInterleavedBufferAttribute&&(h=h.data);let f=e.get(h);f&&(i.deleteBuffer(f.buffer),e.delete(h))}function l(h,f){if(h.isInterleavedBufferAttribute&&(h=h.data),h.isGLBufferAttribute){let m=e.get(h);(!m||m.version<h.version)&&e.set(h,{buffer:h.buffer,type:h.type,bytesPerElement:h.elementSize,version:h.version});return}let d=e.get(h);if(d===void 0)e.set(h,t(h,f));else if(d.version<h.version){if(d.size!==h.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(d.buffer,h,f),d.version=h.version}}return{get:r,remove:o,update:l}}var ty=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ny=`#ifdef USE_ALPHAHASH
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
#endif`,iy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ry=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,sy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ay=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,oy=`#ifdef USE_AOMAP
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
#endif`,ly=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,cy=`#ifdef USE_BATCHING
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
#endif`,hy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,uy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,dy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,fy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,py=`#ifdef USE_IRIDESCENCE
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
#endif`,my=`#ifdef USE_BUMPMAP
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
#endif`,gy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,_y=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,vy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,yy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,xy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Sy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,My=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,by=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,wy=`#define PI 3.141592653589793
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
} // validated`,Ey=`vec3 transformedNormal = objectNormal;
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
#endif`,Ty=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ay=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Cy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ry=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Py="gl_FragColor = linearToOutputTexel( gl_FragColor );",Iy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Dy=`#ifdef USE_ENVMAP
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
#endif`,Ly=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Fy=`#ifdef USE_ENVMAP
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
#endif`,Ny=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Uy=`#ifdef USE_ENVMAP
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
#endif`,Oy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,By=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ky=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,zy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Gy=`#ifdef USE_GRADIENTMAP
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
}`,Vy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Hy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Wy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Xy=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,qy=`#ifdef USE_ENVMAP
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
#endif`,$y=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Yy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,jy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Zy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Jy=`PhysicalMaterial material;
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
#endif`,Ky=`uniform sampler2D dfgLUT;
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
}`,Qy=`
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
#endif`,ex=`#if defined( RE_IndirectDiffuse )
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
#endif`,tx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,nx=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,ix=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,rx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,sx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ax=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ox=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,lx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,cx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,hx=`#if defined( USE_POINTS_UV )
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
#endif`,ux=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,dx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,fx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,px=`#if defined( USE_MORPHCOLORS )
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
#endif`,mx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,gx=`#ifdef USE_MORPHTARGETS
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
#endif`,_x=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,vx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,yx=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,xx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Sx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Mx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,bx=`#ifdef USE_NORMALMAP
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
#endif`,wx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ex=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Tx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Ax=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Cx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Rx=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Px=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ix=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Dx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Lx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Fx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Nx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Ux=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Ox=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Bx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,kx=`float getShadowMask() {
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
}`,zx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Gx=`#ifdef USE_SKINNING
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
#endif`,Vx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Hx=`#ifdef USE_SKINNING
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
#endif`,Wx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Xx=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,qx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,$x=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Yx=`#ifdef USE_TRANSMISSION
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
#endif`,jx=`#ifdef USE_TRANSMISSION
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
#endif`,Zx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Jx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Kx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Qx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,eS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,tS=`uniform sampler2D t2D;
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
}`,nS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,iS=`uniform float backgroundBlurriness;
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
}`,rS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,sS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aS=`#include <common>
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
}`,oS=`#if DEPTH_PACKING == 3200
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
}`,lS=`#define DISTANCE
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
}`,cS=`#define DISTANCE
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
}`,hS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,uS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dS=`uniform float scale;
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
}`,fS=`uniform vec3 diffuse;
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
}`,pS=`#include <common>
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
}`,mS=`uniform vec3 diffuse;
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
}`,gS=`#define LAMBERT
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
}`,_S=`#define LAMBERT
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
}`,vS=`#define MATCAP
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
}`,yS=`#define MATCAP
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
}`,xS=`#define NORMAL
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
}`,SS=`#define NORMAL
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
}`,MS=`#define PHONG
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
}`,bS=`#define PHONG
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
}`,wS=`#define STANDARD
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
}`,ES=`#define STANDARD
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
}`,TS=`#define TOON
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
}`,AS=`#define TOON
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
}`,CS=`uniform float size;
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
}`,RS=`uniform vec3 diffuse;
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
}`,PS=`#include <common>
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
}`,IS=`uniform vec3 color;
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
}`,DS=`uniform float rotation;
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
}`,LS=`uniform vec3 diffuse;
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
}`,_t={alphahash_fragment:ty,alphahash_pars_fragment:ny,alphamap_fragment:iy,alphamap_pars_fragment:ry,alphatest_fragment:sy,alphatest_pars_fragment:ay,aomap_fragment:oy,aomap_pars_fragment:ly,batching_pars_vertex:cy,batching_vertex:hy,begin_vertex:uy,beginnormal_vertex:dy,bsdfs:fy,iridescence_fragment:py,bumpmap_pars_fragment:my,clipping_planes_fragment:gy,clipping_planes_pars_fragment:_y,clipping_planes_pars_vertex:vy,clipping_planes_vertex:yy,color_fragment:xy,color_pars_fragment:Sy,color_pars_vertex:My,color_vertex:by,common:wy,defaultnormal_vertex:Ey,displacementmap_pars_vertex:Ty,displacementmap_vertex:Ay,emissivemap_fragment:Cy,emissivemap_pars_fragment:Ry,colorspace_fragment:Py,colorspace_pars_fragment:Iy,envmap_fragment:Dy,envmap_common_pars_fragment:Ly,envmap_pars_fragment:Fy,envmap_pars_vertex:Ny,envmap_physical_pars_fragment:qy,envmap_vertex:Uy,fog_vertex:Oy,fog_pars_vertex:By,fog_fragment:ky,fog_pars_fragment:zy,gradientmap_pars_fragment:Gy,lightmap_pars_fragment:Vy,lights_lambert_fragment:Hy,lights_lambert_pars_fragment:Wy,lights_pars_begin:Xy,lights_toon_fragment:$y,lights_toon_pars_fragment:Yy,lights_phong_fragment:jy,lights_phong_pars_fragment:Zy,lights_physical_fragment:Jy,lights_physical_pars_fragment:Ky,lights_fragment_begin:Qy,lights_fragment_maps:ex,lights_fragment_end:tx,lightprobes_pars_fragment:nx,logdepthbuf_fragment:ix,logdepthbuf_pars_fragment:rx,logdepthbuf_pars_vertex:sx,logdepthbuf_vertex:ax,map_fragment:ox,map_pars_fragment:lx,map_particle_fragment:cx,map_particle_pars_fragment:hx,metalnessmap_fragment:ux,metalnessmap_pars_fragment:dx,morphinstance_vertex:fx,morphcolor_vertex:px,morphnormal_vertex:mx,morphtarget_pars_vertex:gx,morphtarget_vertex:_x,normal_fragment_begin:vx,normal_fragment_maps:yx,normal_pars_fragment:xx,normal_pars_vertex:Sx,normal_vertex:Mx,normalmap_pars_fragment:bx,clearcoat_normal_fragment_begin:wx,clearcoat_normal_fragment_maps:Ex,clearcoat_pars_fragment:Tx,iridescence_pars_fragment:Ax,opaque_fragment:Cx,packing:Rx,premultiplied_alpha_fragment:Px,project_vertex:Ix,dithering_fragment:Dx,dithering_pars_fragment:Lx,roughnessmap_fragment:Fx,roughnessmap_pars_fragment:Nx,shadowmap_pars_fragment:Ux,shadowmap_pars_vertex:Ox,shadowmap_vertex:Bx,shadowmask_pars_fragment:kx,skinbase_vertex:zx,skinning_pars_vertex:Gx,skinning_vertex:Vx,skinnormal_vertex:Hx,specularmap_fragment:Wx,specularmap_pars_fragment:Xx,tonemapping_fragment:qx,tonemapping_pars_fragment:$x,transmission_fragment:Yx,transmission_pars_fragment:jx,uv_pars_fragment:Zx,uv_pars_vertex:Jx,uv_vertex:Kx,worldpos_vertex:Qx,background_vert:eS,background_frag:tS,backgroundCube_vert:nS,backgroundCube_frag:iS,cube_vert:rS,cube_frag:sS,depth_vert:aS,depth_frag:oS,distance_vert:lS,distance_frag:cS,equirect_vert:hS,equirect_frag:uS,linedashed_vert:dS,linedashed_frag:fS,meshbasic_vert:pS,meshbasic_frag:mS,meshlambert_vert:gS,meshlambert_frag:_S,meshmatcap_vert:vS,meshmatcap_frag:yS,meshnormal_vert:xS,meshnormal_frag:SS,meshphong_vert:MS,meshphong_frag:bS,meshphysical_vert:wS,meshphysical_frag:ES,meshtoon_vert:TS,meshtoon_frag:AS,points_vert:CS,points_frag:RS,shadow_vert:PS,shadow_frag:IS,sprite_vert:DS,sprite_frag:LS},Be={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new et(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new et(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},gi={basic:{uniforms:vn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.fog]),vertexShader:_t.meshbasic_vert,fragmentShader:_t.meshbasic_frag},lambert:{uniforms:vn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:_t.meshlambert_vert,fragmentShader:_t.meshlambert_frag},phong:{uniforms:vn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_t.meshphong_vert,fragmentShader:_t.meshphong_frag},standard:{uniforms:vn([Be.common,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.roughnessmap,Be.metalnessmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag},toon:{uniforms:vn([Be.common,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.gradientmap,Be.fog,Be.lights,{emissive:{value:new ht(0)}}]),vertexShader:_t.meshtoon_vert,fragmentShader:_t.meshtoon_frag},matcap:{uniforms:vn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,{matcap:{value:null}}]),vertexShader:_t.meshmatcap_vert,fragmentShader:_t.meshmatcap_frag},points:{uniforms:vn([Be.points,Be.fog]),vertexShader:_t.points_vert,fragmentShader:_t.points_frag},dashed:{uniforms:vn([Be.common,Be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_t.linedashed_vert,fragmentShader:_t.linedashed_frag},depth:{uniforms:vn([Be.common,Be.displacementmap]),vertexShader:_t.depth_vert,fragmentShader:_t.depth_frag},normal:{uniforms:vn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,{opacity:{value:1}}]),vertexShader:_t.meshnormal_vert,fragmentShader:_t.meshnormal_frag},sprite:{uniforms:vn([Be.sprite,Be.fog]),vertexShader:_t.sprite_vert,fragmentShader:_t.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_t.background_vert,fragmentShader:_t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:_t.backgroundCube_vert,fragmentShader:_t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_t.cube_vert,fragmentShader:_t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_t.equirect_vert,fragmentShader:_t.equirect_frag},distance:{uniforms:vn([Be.common,Be.displacementmap,{referencePosition:{value:new j},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_t.distance_vert,fragmentShader:_t.distance_frag},shadow:{uniforms:vn([Be.lights,Be.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:_t.shadow_vert,fragmentShader:_t.shadow_frag}};gi.physical={uniforms:vn([gi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new et(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ct},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new et},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new et},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag};var Il={r:0,b:0,g:0},FS=new Lt,gf=new ct;gf.set(-1,0,0,0,1,0,0,0,1);function NS(i,e,t,n,r,o){let l=new ht(0),h=r===!0?0:1,f,d,m=null,y=0,g=null;function x(P){let U=P.isScene===!0?P.background:null;if(U&&U.isTexture){let I=P.backgroundBlurriness>0;U=e.get(U,I)}return U}function M(P){let U=!1,I=x(P);I===null?S(l,h):I&&I.isColor&&(S(I,1),U=!0);let O=i.xr.getEnvironmentBlendMode();O==="additive"?t.buffers.color.setClear(0,0,0,1,o):O==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,o),(i.autoClear||U)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function R(P,U){let I=x(U);I&&I.isCubeTexture?(d===void 0&&(d=new zt(new ui(1,1,1),new di({name:"BackgroundCubeMaterial",uniforms:gr(gi.backgroundCube.uniforms),vertexShader:gi.backgroundCube.vertexShader,fragmentShader:gi.backgroundCube.fragmentShader,side:dn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),d.geometry.deleteAttribute("normal"),d.geometry.deleteAttribute("uv"),d.onBeforeRender=function(O,N,w){this.matrixWorld.copyPosition(w.matrixWorld)},Object.defineProperty(d.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(d)),d.material.uniforms.envMap.value=I,d.material.uniforms.backgroundBlurriness.value=U.backgroundBlurriness,d.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,d.material.uniforms.backgroundRotation.value.setFromMatrix4(FS.makeRotationFromEuler(U.backgroundRotation)).transpose(),I.isRenderTargetTexture===!1&&d.material.uniforms.backgroundRotation.value.premultiply(gf),d.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,(m!==I||y!==I.version||g!==i.toneMapping)&&(d.material.needsUpdate=!0,m=I,y=I.version,g=i.toneMapping),d.layers.enableAll(),P.unshift(d,d.geometry,d.material,0,0,null)):I&&I.isTexture&&(f===void 0&&(f=new zt(new Hi(2,2),new di({name:"BackgroundMaterial",uniforms:gr(gi.background.uniforms),vertexShader:gi.background.vertexShader,fragmentShader:gi.background.fragmentShader,side:ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),f.geometry.deleteAttribute("normal"),Object.defineProperty(f.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(f)),f.material.uniforms.t2D.value=I,f.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,f.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,I.matrixAutoUpdate===!0&&I.updateMatrix(),f.material.uniforms.uvTransform.value.copy(I.matrix),(m!==I||y!==I.version||g!==i.toneMapping)&&(f.material.needsUpdate=!0,m=I,y=I.version,g=i.toneMapping),f.layers.enableAll(),P.unshift(f,f.geometry,f.material,0,0,null))}function S(P,U){P.getRGB(Il,fh(i)),t.buffers.color.setClear(Il.r,Il.g,Il.b,U,o)}function _(){d!==void 0&&(d.geometry.dispose(),d.material.dispose(),d=void 0),f!==void 0&&(f.geometry.dispose(),f.material.dispose(),f=void 0)}return{getClearColor:function(){return l},setClearColor:function(P,U=1){l.set(P),h=U,S(l,h)},getClearAlpha:function(){return h},setClearAlpha:function(P){h=P,S(l,h)},render:M,addToRenderList:R,dispose:_}}function US(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=g(null),o=r,l=!1;function h(Y,Z,ee,z,ie){let G=!1,ne=y(Y,z,ee,Z);o!==ne&&(o=ne,d(o.object)),G=x(Y,z,ee,ie),G&&M(Y,z,ee,ie),ie!==null&&e.update(ie,i.ELEMENT_ARRAY_BUFFER),(G||l)&&(l=!1,I(Y,Z,ee,z),ie!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(ie).buffer))}function f(){return i.createVertexArray()}function d(Y){return i.bindVertexArray(Y)}function m(Y){return i.deleteVertexArray(Y)}function y(Y,Z,ee,z){let ie=z.wireframe===!0,G=n[Z.id];G===void 0&&(G={},n[Z.id]=G);let ne=Y.isInstancedMesh===!0?Y.id:0,Se=G[ne];Se===void 0&&(Se={},G[ne]=Se);let re=Se[ee.id];re===void 0&&(re={},Se[ee.id]=re);let H=re[ie];return H===void 0&&(H=g(f()),re[ie]=H),H}function g(Y){let Z=[],ee=[],z=[];for(let ie=0;ie<t;ie++)Z[ie]=0,ee[ie]=0,z[ie]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:Z,enabledAttributes:ee,attributeDivisors:z,object:Y,attributes:{},index:null}}function x(Y,Z,ee,z){let ie=o.attributes,G=Z.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=ie[re],We=G[re];if(We===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(We=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(We=Y.instanceColor)),ge===void 0||ge.attribute!==We||We&&ge.data!==We.data)return!0;ne++}return o.attributesNum!==ne||o.index!==z}function M(Y,Z,ee,z){let ie={},G=Z.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=G[re];ge===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(ge=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(ge=Y.instanceColor));let We={};We.attribute=ge,ge&&ge.data&&(We.data=ge.data),ie[re]=We,ne++}o.attributes=ie,o.attributesNum=ne,o.index=z}function R(){let Y=o.newAttributes;for(let Z=0,ee=Y.length;Z<ee;Z++)Y[Z]=0}function S(Y){_(Y,0)}function _(Y,Z){let ee=o.newAttributes,z=o.enabledAttributes,ie=o.attributeDivisors;ee[Y]=1,z[Y]===0&&(i.enableVertexAttribArray(Y),z[Y]=1),ie[Y]!==Z&&(i.vertexAttribDivisor(Y,Z),ie[Y]=Z)}function P(){let Y=o.newAttributes,Z=o.enabledAttributes;for(let ee=0,z=Z.length;ee<z;ee++)Z[ee]!==Y[ee]&&(i.disableVertexAttribArray(ee),Z[ee]=0)}function U(Y,Z,ee,z,ie,G,ne){ne===!0?i.vertexAttribIPointer(Y,Z,ee,ie,G):i.vertexAttribPointer(Y,Z,ee,z,ie,G)}function I(Y,Z,ee,z){R();let ie=z.attributes,G=ee.getAttributes(),ne=Z.defaultAttributeValues;for(let Se in G){let re=G[Se];if(re.location>=0){let H=ie[Se];if(H===void 0&&(Se==="instanceMatrix"&&Y.instanceMatrix&&(H=Y.instanceMatrix),Se==="instanceColor"&&Y.instanceColor&&(H=Y.instanceColor)),H!==void 0){let ge=H.normalized,We=H.itemSize,it=e.get(H);if(it===void 0)continue;let ue=it.buffer,Fe=it.type,Pe=it.bytesPerElement,je=Fe===i.INT||Fe===i.UNSIGNED_INT||H.gpuType===Yo;if(H.isInterleavedBufferAttribute){let Ue=H.data,ot=Ue.isInterleavedBuffer===!0?Ue.stride:Ue.itemSize,Vt=H.offset;if(Ue.isInstancedInterleavedBuffer||Ue.isInstancedBufferAttribute){for(let Ke=0;Ke<re.locationSize;Ke++)_(re.location+Ke,Ue.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=Ue.meshPerAttribute*Ue.count)}else for(let Ke=0;Ke<re.locationSize;Ke++)S(re.location+Ke);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Ke=0;Ke<re.locationSize;Ke++)U(re.location+Ke,We/re.locationSize,Fe,ge,ot*Pe,(Vt+We/re.locationSize*Ke)*Pe,je)}else{if(H.isInstancedBufferAttribute){for(let Ue=0;Ue<re.locationSize;Ue++)_(re.location+Ue,H.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=H.meshPerAttribute*H.count)}else for(let Ue=0;Ue<re.locationSize;Ue++)S(re.location+Ue);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Ue=0;Ue<re.locationSize;Ue++)U(re.location+Ue,We/re.locationSize,Fe,ge,We*Pe,We/re.locationSize*Ue*Pe,je)}}else if(ne!==void 0){let ge=ne[Se];if(ge!==void 0)switch(ge.length){case 2:i.vertexAttrib2fv(re.location,ge);break;case 3:i.vertexAttrib3fv(re.location,ge);break;case 4:i.vertexAttrib4fv(re.location,ge);break;default:i.vertexAttrib1fv(re.location,ge)}}}}P()}function O(){X();for(let Y in n){let Z=n[Y];for(let ee in Z){let z=Z[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y]}}function N(Y){if(n[Y.id]===void 0)return;let Z=n[Y.id];for(let ee in Z){let z=Z[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y.id]}function w(Y){for(let Z in n){let ee=n[Z];for(let z in ee){let ie=ee[z];if(ie[Y.id]===void 0)continue;let G=ie[Y.id];for(let ne in G)m(G[ne].object),delete G[ne];delete ie[Y.id]}}}function D(Y){for(let Z in n){let ee=n[Z],z=Y.isInstancedMesh===!0?Y.id:0,ie=ee[z];if(ie!==void 0){for(let G in ie){let ne=ie[G];for(let Se in ne)m(ne[Se].object),delete ne[Se];delete ie[G]}delete ee[z],Object.keys(ee).length===0&&delete n[Z]}}}function X(){k(),l=!0,o!==r&&(o=r,d(o.object))}function k(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:h,reset:X,resetDefaultState:k,dispose:O,releaseStatesOfGeometry:N,releaseStatesOfObject:D,releaseStatesOfProgram:w,initAttributes:R,enableAttribute:S,disableUnusedAttributes:P}}function OS(i,e,t){let n;function r(f){n=f}function o(f,d){i.drawArrays(n,f,d),t.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawArraysInstanced(n,f,d,m),t.update(d,n,m))}function h(f,d,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,f,0,d,0,m);let g=0;for(let x=0;x<m;x++)g+=d[x];t.update(g,n,1)}this.setMode=r,this.render=o,this.renderInstances=l,this.renderMultiDraw=h}function BS(i,e,t,n){let r;function o(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let w=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(w.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function l(w){return!(w!==Kn&&n.convert(w)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function h(w){let D=w===Jn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(w!==Tn&&w!==Vn&&!D&&n.convert(w)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function f(w){if(w==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";w="mediump"}return w==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let d=t.precision!==void 0?t.precision:"highp",m=f(d);m!==d&&(Qe("WebGLRenderer:",d,"not supported, using",m,"instead."),d=m);let y=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),g=t.logarithmicDepthBuffer===!0&&y===!1;t.reversedDepthBuffer===!0&&y===!1&&Qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&y===!0&&Qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let x=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),R=i.getParameter(i.MAX_TEXTURE_SIZE),S=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),_=i.getParameter(i.MAX_VERTEX_ATTRIBS),P=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),U=i.getParameter(i.MAX_VARYING_VECTORS),I=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),O=i.getParameter(i.MAX_SAMPLES),N=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:o,getMaxPrecision:f,textureFormatReadable:l,textureTypeReadable:h,precision:d,logarithmicDepthBuffer:g,reversedDepthBuffer:y,maxTextures:x,maxVertexTextures:M,maxTextureSize:R,maxCubemapSize:S,maxAttributes:_,maxVertexUniforms:P,maxVaryings:U,maxFragmentUniforms:I,maxSamples:O,samples:N}}function kS(i){let e=this,t=null,n=0,r=!1,o=!1,l=new In,h=new ct,f={value:null,needsUpdate:!1};this.uniform=f,this.numPlanes=0,this.numIntersection=0,this.init=function(y,g){let x=y.length!==0||g||n!==0||r;return r=g,n=y.length,x},this.beginShadows=function(){o=!0,m(null)},this.endShadows=function(){o=!1},this.setGlobalState=function(y,g){t=m(y,g,0)},this.setState=function(y,g,x){let M=y.clippingPlanes,R=y.clipIntersection,S=y.clipShadows,_=i.get(y);if(!r||M===null||M.length===0||o&&!S)o?m(null):d();else{let P=o?0:n,U=P*4,I=_.clippingState||null;f.value=I,I=m(M,g,U,x);for(let O=0;O!==U;++O)I[O]=t[O];_.clippingState=I,this.numIntersection=R?this.numPlanes:0,this.numPlanes+=P}};function d(){f.value!==t&&(f.value=t,f.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function m(y,g,x,M){let R=y!==null?y.length:0,S=null;if(R!==0){if(S=f.value,M!==!0||S===null){let _=x+R*4,P=g.matrixWorldInverse;h.getNormalMatrix(P),(S===null||S.length<_)&&(S=new Float32Array(_));for(let U=0,I=x;U!==R;++U,I+=4)l.copy(y[U]).applyMatrix4(P,h),l.normal.toArray(S,I),S[I+3]=l.constant}f.value=S,f.needsUpdate=!0}return e.numPlanes=R,e.numIntersection=0,S}}var ca=class extends Ln{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new Us(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new ui(5,5,5),o=new di({name:"CubemapFromEquirect",uniforms:gr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:dn,blending:dr});o.uniforms.tEquirect.value=t;let l=new zt(r,o),h=t.minFilter;return t.minFilter===Ri&&(t.minFilter=Mn),new qr(1,10,this).update(e,l),t.minFilter=h,l.geometry.dispose(),l.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let o=e.getRenderTarget();for(let l=0;l<6;l++)e.setRenderTarget(this,l),e.clear(t,n,r);e.setRenderTarget(o)}},$d=256,zS=3,GS=20,_f=256,vf=16,VS=3,HS=new j,WS=new ht,es=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new qr(1,10,null),this._boxMesh=new zt(new ui(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,o={}){let{size:l=256,position:h=HS}=o,f=this._renderer;this._setSize(l);let d=this._allocateTarget(),m=this._getSourceTarget(!0);t>0&&(m.texture.mipmapsAutoUpdate=!1);let y=f.autoClear,g=f.autoClearColor,x=f.autoClearDepth,M=f.autoClearStencil,R=e.background;f.autoClear=!0,f.autoClearColor=!0,f.autoClearDepth=!0,f.autoClearStencil=!0,R===null&&(e.background=f.getClearColor(WS));let S=new qr(n,r,m);return S.position.copy(h),S.update(f,e),f.autoClear=y,f.autoClearColor=g,f.autoClearDepth=x,f.autoClearStencil=M,e.background=R,t>0&&(m.texture.mipmapsAutoUpdate=!0,this._blur(d,t)),this._applyPMREM(d),d}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Zd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=jd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max($d,hh(e))}_fromTexture(e,t){e.mapping===pr||e.mapping===Zr?this._setSize(e.image.length===0?$d:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Yd(e,!1,!1),n=Math.log2(e)-zS;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Yd(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,o=this._cubeCamera;r.material=n,o.renderTarget=e,o.activeMipmapLevel=t;let l=e.width>>t;e.viewport.set(0,0,l,l),o.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===pr||e.mapping===Zr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Zd()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=jd()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=XS(),this._integrationMaterial=qS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let o=this._integrationMaterial.uniforms;o.envMap.value=this._sourceTarget.texture,o.sourceLod.value=Math.log2(t/vf);for(let l=0;l<=n;l++){let h=i.lodToRoughness(l,n);if(l>n-VS)o.roughness.value=h,this._renderCube(e,l,this._integrationMaterial);else{let f=h>0?Math.log2(t)+.5*Math.log2(6/(_f*Math.pow(h,4)))+.5:0;r.roughness.value=h,r.lodBias.value=f,this._renderCube(e,l,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=$S());let n=this._blurMaterial,r=n.uniforms,o=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=o.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(o,0,n)}};function Yd(i,e,t){return new ca(i,{minFilter:Ri,generateMipmaps:e,type:Jn,colorSpace:ws,depthBuffer:t})}function ha(i,e,t){return new di({name:i,uniforms:e,vertexShader:_t.cube_vert,fragmentShader:t,side:dn,blending:dr,depthTest:!1,depthWrite:!1})}function XS(){return ha("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${_f}u

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
	`)}function qS(){return ha("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:vf}},`

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
	`)}function $S(){return ha("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${GS}
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
	`)}function jd(){return ha("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Zd(){return ha("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function YS(i){let e=new WeakMap,t=new WeakMap,n=null;function r(g,x=!1){return g==null?null:x?l(g):o(g)}function o(g){if(g&&g.isTexture){let x=g.mapping;if(x===Xo||x===qo)if(e.has(g)){let M=e.get(g).texture;return h(M,g.mapping)}else{let M=g.image;if(M&&M.height>0){let R=new ca(M.height);return R.fromEquirectangularTexture(i,g),e.set(g,R),g.addEventListener("dispose",d),h(R.texture,g.mapping)}else return null}}return g}function l(g){if(g&&g.isTexture&&g.isPMREMTexture!==!0){let x=g.mapping,M=x===Xo||x===qo,R=x===pr||x===Zr;if(M||R){let S=t.get(g),_=S!==void 0?S.texture.pmremVersion:0;if(g.isRenderTargetTexture&&g.pmremVersion!==_)return n===null&&(n=new es(i)),S=M?n.fromEquirectangular(g,S):n.fromCubemap(g,S),S.texture.pmremVersion=g.pmremVersion,t.set(g,S),S.texture;if(S!==void 0)return S.texture;{let P=g.image;return M&&P&&P.height>0||R&&P&&f(P)?(n===null&&(n=new es(i)),S=M?n.fromEquirectangular(g):n.fromCubemap(g),S.texture.pmremVersion=g.pmremVersion,t.set(g,S),g.addEventListener("dispose",m),S.texture):null}}}return g}function h(g,x){return x===Xo?g.mapping=pr:x===qo&&(g.mapping=Zr),g}function f(g){let x=0,M=6;for(let R=0;R<M;R++)g[R]!==void 0&&x++;return x===M}function d(g){let x=g.target;x.removeEventListener("dispose",d);let M=e.get(x);M!==void 0&&(e.delete(x),M.dispose())}function m(g){let x=g.target;x.removeEventListener("dispose",m);let M=t.get(x);M!==void 0&&(t.delete(x),M.dispose())}function y(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:y}}function jS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let r=t(n);return r===null&&xs("WebGLRenderer: "+n+" extension not supported."),r}}}function ZS(i,e,t,n){let r={},o=new WeakMap,l=new FinalizationRegistry(M=>delete r[M]);function h(M){f(M.target)}function f(M){M.index!==null&&e.remove(M.index);for(let S in M.attributes)e.remove(M.attributes[S]);M.removeEventListener("dispose",h),delete r[M.id],l.unregister(M);let R=o.get(M);R&&(e.remove(R),o.delete(M)),n.releaseStatesOfGeometry(M),M.isInstancedBufferGeometry===!0&&delete M._maxInstanceCount,t.memory.geometries--}function d(M,R){return r[R.id]!==void 0||(R.addEventListener("dispose",h),r[R.id]=new WeakRef(R),l.register(R,R.id,R),t.memory.geometries++),R}function m(M){let R=M.attributes;for(let S in R)e.update(R[S],i.ARRAY_BUFFER)}function y(M){let R=M.index,S=M.attributes.position,_=0;if(S===void 0)return;let P=R!==null?R.array.length:S.array.length/3-1,U=S.count>=65535?Ps:Rs,I=new U(Math.ceil(P/3)*6,1),O=I.array;if(R!==null){let w=R.array;_=R.version;for(let D=0,X=0;D<P;D+=3){let k=w[D+0],Y=w[D+1],Z=w[D+2];O[X++]=k,O[X++]=Y,O[X++]=Y,O[X++]=Z,O[X++]=Z,O[X++]=k}}else{_=S.version;for(let w=0,D=0;w<P;w+=3){let X=w+0,k=w+1,Y=w+2;O[D++]=X,O[D++]=k,O[D++]=k,O[D++]=Y,O[D++]=Y,O[D++]=X}}I.version=_;let N=o.get(M);N&&e.remove(N),o.set(M,I)}function g(M){let R=o.get(M);if(R){let S=M.index;S!==null&&R.version<S.version&&y(M)}else y(M);return o.get(M)}function x(){for(let M in r){let R=r[M].deref();R!==void 0&&f(R)}}return{get:d,update:m,getWireframeAttribute:g,dispose:x}}function JS(i,e,t){let n;function r(y){n=y}let o,l;function h(y){o=y.type,l=y.bytesPerElement}function f(y,g){i.drawElements(n,g,o,y*l),t.update(g,n,1)}function d(y,g,x){x!==0&&(i.drawElementsInstanced(n,g,o,y*l,x),t.update(g,n,x))}function m(y,g,x){if(x===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,g,0,o,y,0,x);let R=0;for(let S=0;S<x;S++)R+=g[S];t.update(R,n,1)}this.setMode=r,this.setIndex=h,this.render=f,this.renderInstances=d,this.renderMultiDraw=m}function KS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(o,l,h){switch(t.calls++,l){case i.TRIANGLES:t.triangles+=h*(o/3);break;case i.LINES:t.lines+=h*(o/2);break;case i.LINE_STRIP:t.lines+=h*(o-1);break;case i.LINE_LOOP:t.lines+=h*o;break;case i.POINTS:t.points+=h*o;break;default:nt("WebGLInfo: Unknown draw mode:",l);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}function QS(i,e,t){let n=new WeakMap,r=new Gt;function o(l,h,f){let d=l.morphTargetInfluences,m=h.morphAttributes.position||h.morphAttributes.normal||h.morphAttributes.color,y=m!==void 0?m.length:0,g=n.get(h);if(g===void 0||g.count!==y){let X=function(){w.dispose(),n.delete(h),h.removeEventListener("dispose",X)};g!==void 0&&g.texture.dispose();let x=h.morphAttributes.position!==void 0,M=h.morphAttributes.normal!==void 0,R=h.morphAttributes.color!==void 0,S=h.morphAttributes.position||[],_=h.morphAttributes.normal||[],P=h.morphAttributes.color||[],U=0;x===!0&&(U=1),M===!0&&(U=2),R===!0&&(U=3);let I=h.attributes.position.count*U,O=1;I>e.maxTextureSize&&(O=Math.ceil(I/e.maxTextureSize),I=e.maxTextureSize);let N=new Float32Array(I*O*4*y),w=new As(N,I,O,y);w.type=Vn,w.needsUpdate=!0;let D=U*4;for(let k=0;k<y;k++){let Y=S[k],Z=_[k],ee=P[k],z=I*O*4*k;for(let ie=0;ie<Y.count;ie++){let G=ie*D;x===!0&&(r.fromBufferAttribute(Y,ie),N[z+G+0]=r.x,N[z+G+1]=r.y,N[z+G+2]=r.z,N[z+G+3]=0),M===!0&&(r.fromBufferAttribute(Z,ie),N[z+G+4]=r.x,N[z+G+5]=r.y,N[z+G+6]=r.z,N[z+G+7]=0),R===!0&&(r.fromBufferAttribute(ee,ie),N[z+G+8]=r.x,N[z+G+9]=r.y,N[z+G+10]=r.z,N[z+G+11]=ee.itemSize===4?r.w:1)}}g={count:y,texture:w,size:new et(I,O)},n.set(h,g),h.addEventListener("dispose",X)}if(l.isInstancedMesh===!0&&l.morphTexture!==null)f.getUniforms().setValue(i,"morphTexture",l.morphTexture,t);else{let x=0;for(let R=0;R<d.length;R++)x+=d[R];let M=h.morphTargetsRelative?1:1-x;f.getUniforms().setValue(i,"morphTargetBaseInfluence",M),f.getUniforms().setValue(i,"morphTargetInfluences",d)}f.getUniforms().setValue(i,"morphTargetsTexture",g.texture,t),f.getUniforms().setValue(i,"morphTargetsTextureSize",g.size)}return{update:o}}function eM(i,e,t,n,r){let o=new WeakMap;function l(d){let m=r.render.frame,y=d.geometry,g=e.get(d,y);if(o.get(g)!==m&&(e.update(g),o.set(g,m)),d.isInstancedMesh&&(d.hasEventListener("dispose",f)===!1&&d.addEventListener("dispose",f),o.get(d)!==m&&(t.update(d.instanceMatrix,i.ARRAY_BUFFER),d.instanceColor!==null&&t.update(d.instanceColor,i.ARRAY_BUFFER),o.set(d,m))),d.isSkinnedMesh){let x=d.skeleton;o.get(x)!==m&&(x.update(),o.set(x,m))}return g}function h(){o=new WeakMap}function f(d){let m=d.target;m.removeEventListener("dispose",f),n.releaseStatesOfObject(m),t.remove(m.instanceMatrix),m.instanceColor!==null&&t.remove(m.instanceColor)}return{update:l,dispose:h}}var tM={[Xc]:"LINEAR_TONE_MAPPING",[qc]:"REINHARD_TONE_MAPPING",[$c]:"CINEON_TONE_MAPPING",[Yc]:"ACES_FILMIC_TONE_MAPPING",[Zc]:"AGX_TONE_MAPPING",[Ks]:"NEUTRAL_TONE_MAPPING",[jc]:"CUSTOM_TONE_MAPPING"};function nM(i,e,t,n,r,o){let l=new Ln(e,t,{type:i,depthBuffer:r,stencilBuffer:o,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),h=null,f=null,d=null,m=new En;m.setAttribute("position",new Xt([-1,3,0,-1,-1,0,3,-1,0],3)),m.setAttribute("uv",new Xt([0,2,0,0,2,0],2));let y=new Po({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),g=new zt(m,y),x=new $s(-1,1,1,-1,0,1),M=null,R=null,S=!1,_,P=null,U=[],I=!1;this.setSize=function(O,N){l.setSize(O,N),h!==null&&h.setSize(O,N),f!==null&&f.setSize(O,N);for(let w=0;w<U.length;w++){let D=U[w];D.setSize&&D.setSize(O,N)}},this.setEffects=function(O){U=O,I=U.length>0&&U[0].isRenderPass===!0;let N=l.width,w=l.height;U.length>0&&h===null&&(h=new Ln(N,w,{type:Jn,depthBuffer:!1,stencilBuffer:!1}),f=new Ln(N,w,{type:Jn,depthBuffer:!1,stencilBuffer:!1}));let D=r===!0&&U.some(X=>X.needsDepthTexture===!0);D!==(l.depthTexture!==null)&&(D===!0&&d===null&&(d=new Ai(N,w),o===!0&&(d.format=Pi,d.type=mr)),l.dispose(),l.depthTexture=D?d:null,l.resolveDepthBuffer=D,l.storeMultisampledDepthBuffer=D);for(let X=0;X<U.length;X++){let k=U[X];k.setSize&&k.setSize(N,w),D&&k.needsDepthTexture===!0&&k.setDepthTexture&&k.setDepthTexture(d)}},this.begin=function(O,N){if(S||O.toneMapping===pi&&U.length===0)return!1;if(P=N,N!==null){let w=N.width,D=N.height;(l.width!==w||l.height!==D)&&this.setSize(w,D)}return I===!1&&O.setRenderTarget(l),_=O.toneMapping,O.toneMapping=pi,!0},this.hasRenderPass=function(){return I},this.end=function(O,N){O.toneMapping=_,S=!0;let w=l,D=h;for(let X=0;X<U.length;X++){let k=U[X];k.enabled!==!1&&(k.render(O,D,w,N),k.needsSwap!==!1&&(w=D,D=D===h?f:h))}if(M!==O.outputColorSpace||R!==O.toneMapping){M=O.outputColorSpace,R=O.toneMapping,y.defines={},St.getTransfer(M)===Pt&&(y.defines.SRGB_TRANSFER="");let X=tM[R];X&&(y.defines[X]=""),y.needsUpdate=!0}y.uniforms.tDiffuse.value=w.texture,O.setRenderTarget(P),O.render(g,x),P=null,S=!1},this.isCompositing=function(){return S},this.dispose=function(){l.dispose(),h!==null&&h.dispose(),f!==null&&f.dispose(),m.dispose(),y.dispose()}}var yf=new wn,xf=new Ai(1,1),Sf=new Bs(1),Mf=new As,bf=new wo,wf=new Us,Jd=[],Kd=[],Qd=new Float32Array(16),ef=new Float32Array(9),tf=new Float32Array(4);function ts(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,o=Jd[r];if(o===void 0&&(o=new Float32Array(r),Jd[r]=o),e!==0){n.toArray(o,0);for(let l=1,h=0;l!==e;++l)h+=t,i[l].toArray(o,h)}return o}function en(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Fl(i,e){let t=Kd[e];t===void 0&&(t=new Int32Array(e),Kd[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function iM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function rM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2fv(this.addr,e),tn(t,e)}}function sM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(en(t,e))return;i.uniform3fv(this.addr,e),tn(t,e)}}function aM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4fv(this.addr,e),tn(t,e)}}function oM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;tf.set(n),i.uniformMatrix2fv(this.addr,!1,tf),tn(t,n)}}function lM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;ef.set(n),i.uniformMatrix3fv(this.addr,!1,ef),tn(t,n)}}function cM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Qd.set(n),i.uniformMatrix4fv(this.addr,!1,Qd),tn(t,n)}}function hM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function uM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2iv(this.addr,e),tn(t,e)}}function dM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3iv(this.addr,e),tn(t,e)}}function fM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4iv(this.addr,e),tn(t,e)}}function pM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function mM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2uiv(this.addr,e),tn(t,e)}}function gM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3uiv(this.addr,e),tn(t,e)}}function _M(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4uiv(this.addr,e),tn(t,e)}}function Nl(i){return i.version===0&&(i.compareFunction=ah,i.needsUpdate=!0),i}function vM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let o;this.type===i.SAMPLER_2D_SHADOW?o=Nl(xf):o=yf,t.setTexture2D(e||o,r)}function yM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||bf,r)}function xM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Nl(Sf):o=wf,t.setTextureCube(e||o,r)}function SM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||Mf,r)}function MM(i){switch(i){case 5126:return iM;case 35664:return rM;case 35665:return sM;case 35666:return aM;case 35674:return oM;case 35675:return lM;case 35676:return cM;case 5124:case 35670:return hM;case 35667:case 35671:return uM;case 35668:case 35672:return dM;case 35669:case 35673:return fM;case 5125:return pM;case 36294:return mM;case 36295:return gM;case 36296:return _M;case 35678:case 36198:case 36298:case 36306:case 35682:return vM;case 35679:case 36299:case 36307:return yM;case 35680:case 36300:case 36308:case 36293:return xM;case 36289:case 36303:case 36311:case 36292:return SM}}function bM(i,e){i.uniform1fv(this.addr,e)}function wM(i,e){let t=ts(e,this.size,2);i.uniform2fv(this.addr,t)}function EM(i,e){let t=ts(e,this.size,3);i.uniform3fv(this.addr,t)}function TM(i,e){let t=ts(e,this.size,4);i.uniform4fv(this.addr,t)}function AM(i,e){let t=ts(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function CM(i,e){let t=ts(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function RM(i,e){let t=ts(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function PM(i,e){i.uniform1iv(this.addr,e)}function IM(i,e){i.uniform2iv(this.addr,e)}function DM(i,e){i.uniform3iv(this.addr,e)}function LM(i,e){i.uniform4iv(this.addr,e)}function FM(i,e){i.uniform1uiv(this.addr,e)}function NM(i,e){i.uniform2uiv(this.addr,e)}function UM(i,e){i.uniform3uiv(this.addr,e)}function OM(i,e){i.uniform4uiv(this.addr,e)}function BM(i,e,t){let n=this.cache,r=e.length,o=Fl(t,r);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));let l;this.type===i.SAMPLER_2D_SHADOW?l=Nl(xf):l=yf;for(let h=0;h!==r;++h)t.setTexture2D(e[h]||l,o[h])}function kM(i,e,t){let n=this.cache,r=e.length,o=Fl(t,r);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let l=0;l!==r;++l)t.setTexture3D(e[l]||bf,o[l])}function zM(i,e,t){let n=this.cache,r=e.length,o=Fl(t,r);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));let l;this.type===i.SAMPLER_CUBE_SHADOW?l=Nl(Sf):l=wf;for(let h=0;h!==r;++h)t.setTextureCube(e[h]||l,o[h])}function GM(i,e,t){let n=this.cache,r=e.length,o=Fl(t,r);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let l=0;l!==r;++l)t.setTexture2DArray(e[l]||Mf,o[l])}function VM(i){switch(i){case 5126:return bM;case 35664:return wM;case 35665:return EM;case 35666:return TM;case 35674:return AM;case 35675:return CM;case 35676:return RM;case 5124:case 35670:return PM;case 35667:case 35671:return IM;case 35668:case 35672:return DM;case 35669:case 35673:return LM;case 5125:return FM;case 36294:return NM;case 36295:return UM;case 36296:return OM;case 35678:case 36198:case 36298:case 36306:case 35682:return BM;case 35679:case 36299:case 36307:return kM;case 35680:case 36300:case 36308:case 36293:return zM;case 36289:case 36303:case 36311:case 36292:return GM}}var yh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=MM(t.type)}},xh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=VM(t.type)}},Sh=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let o=0,l=r.length;o!==l;++o){let h=r[o];h.setValue(e,t[h.id],n)}}},_h=/(\w+)(\])?(\[|\.)?/g;function nf(i,e){i.seq.push(e),i.map[e.id]=e}function HM(i,e,t){let n=i.name,r=n.length;for(_h.lastIndex=0;;){let o=_h.exec(n),l=_h.lastIndex,h=o[1],f=o[2]==="]",d=o[3];if(f&&(h=h|0),d===void 0||d==="["&&l+2===r){nf(t,d===void 0?new yh(h,i,e):new xh(h,i,e));break}else{let y=t.map[h];y===void 0&&(y=new Sh(h),nf(t,y)),t=y}}}var Qr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let l=0;l<n;++l){let h=e.getActiveUniform(t,l),f=e.getUniformLocation(t,h.name);HM(h,f,this)}let r=[],o=[];for(let l of this.seq)l.type===e.SAMPLER_2D_SHADOW||l.type===e.SAMPLER_CUBE_SHADOW||l.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(l):o.push(l);r.length>0&&(this.seq=r.concat(o))}setValue(e,t,n,r){let o=this.map[t];o!==void 0&&o.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let o=0,l=t.length;o!==l;++o){let h=t[o],f=n[h.id];f.needsUpdate!==!1&&h.setValue(e,f.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,o=e.length;r!==o;++r){let l=e[r];l.id in t&&n.push(l)}return n}};function rf(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var WM=37297,XM=0;function qM(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),o=Math.min(e+6,t.length);for(let l=r;l<o;l++){let h=l+1;n.push(`${h===e?">":" "} ${h}: ${t[l]}`)}return n.join(`
`)}var sf=new ct;function $M(i){St._getMatrix(sf,St.workingColorSpace,i);let e=`mat3( ${sf.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case Es:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function af(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),o=(i.getShaderInfoLog(e)||"").trim();if(n&&o==="")return"";let l=/ERROR: 0:(\d+)/.exec(o);if(l){let h=parseInt(l[1]);return t.toUpperCase()+`

`+o+`

`+qM(i.getShaderSource(e),h)}else return o}function YM(i,e){let t=$M(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var jM={[Xc]:"Linear",[qc]:"Reinhard",[$c]:"Cineon",[Yc]:"ACESFilmic",[Zc]:"AgX",[Ks]:"Neutral",[jc]:"Custom"};function ZM(i,e){let t=jM[e];return t===void 0?(Qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Dl=new j;function JM(){St.getLuminanceCoefficients(Dl);let i=Dl.x.toFixed(4),e=Dl.y.toFixed(4),t=Dl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function KM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(la).join(`
`)}function QM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function eb(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let o=i.getActiveAttrib(e,r),l=o.name,h=1;o.type===i.FLOAT_MAT2&&(h=2),o.type===i.FLOAT_MAT3&&(h=3),o.type===i.FLOAT_MAT4&&(h=4),t[l]={type:o.type,location:i.getAttribLocation(e,l),locationSize:h}}return t}function la(i){return i!==""}function of(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function lf(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var tb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Mh(i){return i.replace(tb,nb)}function nb(i,e){let t=_t[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Mh(t)}var ib=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function cf(i){return i.replace(ib,rb)}function rb(i,e,t,n){let r="";for(let o=parseInt(e);o<parseInt(t);o++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+o+" ]").replace(/UNROLLED_LOOP_INDEX/g,o);return r}function hf(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var sb={[ur]:"SHADOWMAP_TYPE_PCF",[Yr]:"SHADOWMAP_TYPE_VSM"};function ab(i){return sb[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ob={[Zr]:"ENVMAP_MODE_REFRACTION"};function lb(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":ob[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var cb={[Wo]:"ENVMAP_BLENDING_MULTIPLY",[Ed]:"ENVMAP_BLENDING_MIX",[Td]:"ENVMAP_BLENDING_ADD"};function hb(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":cb[i.combine]||"ENVMAP_BLENDING_NONE"}function ub(i,e,t,n){let r=i.getContext(),o=t.defines,l=t.vertexShader,h=t.fragmentShader,f=ab(t),d=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",m=lb(t),y=hb(t),g=KM(t),x=QM(o),M=r.createProgram(),R,S,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(R=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x].filter(la).join(`
`),R.length>0&&(R+=`
`),S=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x].filter(la).join(`
`),S.length>0&&(S+=`
`)):(R=[hf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+m:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(la).join(`
`),S=[hf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,x,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+d:"",t.envMap?"#define "+m:"",t.envMap?"#define "+y:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==pi?"#define TONE_MAPPING":"",t.toneMapping!==pi?_t.tonemapping_pars_fragment:"",t.toneMapping!==pi?ZM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",_t.colorspace_pars_fragment,YM("linearToOutputTexel",t.outputColorSpace),JM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(la).join(`
`)),l=Mh(l),l=of(l,t),l=lf(l,t),h=Mh(h),h=of(h,t),h=lf(h,t),l=cf(l),h=cf(h),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,R=[g,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+R,S=["#define varying in",t.glslVersion===oh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===oh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+S);let P=_+R+l,U=_+S+h,I=rf(r,r.VERTEX_SHADER,P),O=rf(r,r.FRAGMENT_SHADER,U);r.attachShader(M,I),r.attachShader(M,O),t.index0AttributeName!==void 0?r.bindAttribLocation(M,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(M,0,"position"),r.linkProgram(M);function N(k){if(i.debug.checkShaderErrors){let Y=r.getProgramInfoLog(M)||"",Z=r.getShaderInfoLog(I)||"",ee=r.getShaderInfoLog(O)||"",z=Y.trim(),ie=Z.trim(),G=ee.trim(),ne=!0,Se=!0;if(r.getProgramParameter(M,r.LINK_STATUS)===!1)if(ne=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,M,I,O);else{let re=af(r,I,"vertex"),H=af(r,O,"fragment");nt("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(M,r.VALIDATE_STATUS)+`

Material Name: `+k.name+`
Material Type: `+k.type+`

Program Info Log: `+z+`
`+re+`
`+H)}else z!==""?Qe("WebGLProgram: Program Info Log:",z):(ie===""||G==="")&&(Se=!1);Se&&(k.diagnostics={runnable:ne,programLog:z,vertexShader:{log:ie,prefix:R},fragmentShader:{log:G,prefix:S}})}r.deleteShader(I),r.deleteShader(O),w=new Qr(r,M),D=eb(r,M)}let w;this.getUniforms=function(){return w===void 0&&N(this),w};let D;this.getAttributes=function(){return D===void 0&&N(this),D};let X=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return X===!1&&(X=r.getProgramParameter(M,WM)),X},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(M),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=XM++,this.cacheKey=e,this.usedTimes=1,this.program=M,this.vertexShader=I,this.fragmentShader=O,this}var db=0,bh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new wh(e),t.set(e,n)),n}},wh=class{constructor(e){this.id=db++,this.code=e,this.usedTimes=0}};function fb(i){return i===Zi||i===ra||i===sa}function pb(i,e,t,n,r,o){let l=new Vr,h=new bh,f=new Set,d=[],m=new Map,y=n.logarithmicDepthBuffer,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(w){return f.add(w),w===0?"uv":`uv${w}`}function M(w,D,X,k,Y,Z){let ee=k.fog,z=Y.geometry,ie=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?k.environment:null,G=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap,ne=e.get(w.envMap||ie,G),Se=g[w.type],re=n.precision;w.precision!==null&&(re=n.getMaxPrecision(w.precision),re!==w.precision&&Qe("WebGLProgram.getParameters:",w.precision,"not supported, using",re,"instead."));let H=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,ge=H!==void 0?H.length:0,We=0;z.morphAttributes.position!==void 0&&(We=1),z.morphAttributes.normal!==void 0&&(We=2),z.morphAttributes.color!==void 0&&(We=3);let it,ue,Fe,Pe;if(Se){let Oe=gi[Se];it=Oe.vertexShader,ue=Oe.fragmentShader}else{it=w.vertexShader,ue=w.fragmentShader;let Oe=h.getVertexShaderStage(w),Tt=h.getFragmentShaderStage(w);h.update(w,Oe,Tt),Fe=Oe.id,Pe=Tt.id}let je=i.getRenderTarget(),Ue=i.state.buffers.depth.getReversed(),ot=Y.isInstancedMesh===!0,Vt=Y.isBatchedMesh===!0,Ke=!!w.map,Et=!!w.matcap,Ct=!!ne,mt=Ct&&ne.isPMREMTexture===!0,Ht=!!w.aoMap,pt=!!w.lightMap,It=!!w.bumpMap&&w.wireframe===!1,Mt=!!w.normalMap,rn=!!w.displacementMap,De=!!w.emissiveMap,qe=!!w.metalnessMap,hn=!!w.roughnessMap,sn=w.anisotropy>0,W=w.clearcoat>0,yn=w.diffuseRoughness>0,Rt=w.dispersion>0,Ut=w.retroreflectivity>0,Le=w.iridescence>0,qt=w.sheen>0,Ze=w.transmission>0,Je=sn&&!!w.anisotropyMap,L=W&&!!w.clearcoatMap,T=W&&!!w.clearcoatNormalMap,J=W&&!!w.clearcoatRoughnessMap,ve=yn&&!!w.diffuseRoughnessMap,de=Le&&!!w.iridescenceMap,pe=Le&&!!w.iridescenceThicknessMap,Me=qt&&!!w.sheenColorMap,ae=qt&&!!w.sheenRoughnessMap,le=!!w.specularMap,Ce=!!w.specularColorMap,B=!!w.specularIntensityMap,he=Ze&&!!w.transmissionMap,se=Ze&&!!w.thicknessMap,Re=!!w.gradientMap,Ee=!!w.alphaMap,Ae=w.alphaTest>0,Xe=!!w.alphaHash,ut=!!w.extensions,we=pi;w.toneMapped&&(je===null||je.isXRRenderTarget===!0)&&(we=i.toneMapping);let $e=mt?ne.isCompressedCubeTexture?ne.image[0].mipmaps:ne.mipmaps:null,dt={shaderID:Se,shaderType:w.type,shaderName:w.name,vertexShader:it,fragmentShader:ue,defines:w.defines,customVertexShaderID:Fe,customFragmentShaderID:Pe,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:re,batching:Vt,batchingColor:Vt&&Y._colorsTexture!==null,instancing:ot,instancingColor:ot&&Y.instanceColor!==null,instancingMorph:ot&&Y.morphTexture!==null,outputColorSpace:je===null?i.outputColorSpace:je.isXRRenderTarget===!0?je.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!w.alphaToCoverage,map:Ke,matcap:Et,envMap:Ct,envMapMode:Ct&&ne.mapping,envMapPMREM:mt,envMapMaxLod:mt?$e.length-1:null,envMapSize:mt?$e[0].width:null,aoMap:Ht,lightMap:pt,bumpMap:It,normalMap:Mt,displacementMap:rn,emissiveMap:De,normalMapObjectSpace:Mt&&w.normalMapType===Rd,normalMapTangentSpace:Mt&&w.normalMapType===aa,packedNormalMap:Mt&&w.normalMapType===aa&&fb(w.normalMap.format),metalnessMap:qe,roughnessMap:hn,anisotropy:sn,anisotropyMap:Je,clearcoat:W,clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:J,diffuseRoughness:yn,diffuseRoughnessMap:ve,dispersion:Rt,retroreflection:Ut,iridescence:Le,iridescenceMap:de,iridescenceThicknessMap:pe,sheen:qt,sheenColorMap:Me,sheenRoughnessMap:ae,specularMap:le,specularColorMap:Ce,specularIntensityMap:B,transmission:Ze,transmissionMap:he,thicknessMap:se,gradientMap:Re,opaque:w.transparent===!1&&w.blending===jr&&w.alphaToCoverage===!1,alphaMap:Ee,alphaTest:Ae,alphaHash:Xe,combine:w.combine,mapUv:Ke&&x(w.map.channel),aoMapUv:Ht&&x(w.aoMap.channel),lightMapUv:pt&&x(w.lightMap.channel),bumpMapUv:It&&x(w.bumpMap.channel),normalMapUv:Mt&&x(w.normalMap.channel),displacementMapUv:rn&&x(w.displacementMap.channel),emissiveMapUv:De&&x(w.emissiveMap.channel),metalnessMapUv:qe&&x(w.metalnessMap.channel),roughnessMapUv:hn&&x(w.roughnessMap.channel),anisotropyMapUv:Je&&x(w.anisotropyMap.channel),clearcoatMapUv:L&&x(w.clearcoatMap.channel),clearcoatNormalMapUv:T&&x(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&x(w.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ve&&x(w.diffuseRoughnessMap.channel),iridescenceMapUv:de&&x(w.iridescenceMap.channel),iridescenceThicknessMapUv:pe&&x(w.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&x(w.sheenColorMap.channel),sheenRoughnessMapUv:ae&&x(w.sheenRoughnessMap.channel),specularMapUv:le&&x(w.specularMap.channel),specularColorMapUv:Ce&&x(w.specularColorMap.channel),specularIntensityMapUv:B&&x(w.specularIntensityMap.channel),transmissionMapUv:he&&x(w.transmissionMap.channel),thicknessMapUv:se&&x(w.thicknessMap.channel),alphaMapUv:Ee&&x(w.alphaMap.channel),vertexTangents:!!z.attributes.tangent&&(Mt||sn),vertexNormals:!!z.attributes.normal,vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,pointsUvs:Y.isPoints===!0&&!!z.attributes.uv&&(Ke||Ee),fog:!!ee,useFog:w.fog===!0,fogExp2:!!ee&&ee.isFogExp2,flatShading:w.wireframe===!1&&(w.flatShading===!0||z.attributes.normal===void 0&&Mt===!1&&(w.isMeshLambertMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isMeshPhysicalMaterial)),sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:y,reversedDepthBuffer:Ue,skinning:Y.isSkinnedMesh===!0,hasPositionAttribute:z.attributes.position!==void 0,morphTargets:z.morphAttributes.position!==void 0,morphNormals:z.morphAttributes.normal!==void 0,morphColors:z.morphAttributes.color!==void 0,morphTargetsCount:ge,morphTextureStride:We,numSunLights:D.sun.length,numDirLights:D.directional.length,numPointLights:D.point.length,numSpotLights:D.spot.length,numSpotLightMaps:D.spotLightMap.length,numRectAreaLights:D.rectArea.length,numHemiLights:D.hemi.length,numSunLightShadows:D.sunShadowMap.length,numDirLightShadows:D.directionalShadowMap.length,numPointLightShadows:D.pointShadowMap.length,numSpotLightShadows:D.spotShadowMap.length,numSpotLightShadowsWithMaps:D.numSpotLightShadowsWithMaps,numLightProbes:D.numLightProbes,numLightProbeGrids:Z.filter(Oe=>Oe.texture!==null).length,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&X.length>0,shadowMapType:i.shadowMap.type,toneMapping:we,decodeVideoTexture:Ke&&w.map.isVideoTexture===!0&&St.getTransfer(w.map.colorSpace)===Pt,decodeVideoTextureEmissive:De&&w.emissiveMap.isVideoTexture===!0&&St.getTransfer(w.emissiveMap.colorSpace)===Pt,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===fi,flipSided:w.side===dn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:ut&&w.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ut&&w.extensions.multiDraw===!0||Vt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return dt.vertexUv1s=f.has(1),dt.vertexUv2s=f.has(2),dt.vertexUv3s=f.has(3),f.clear(),dt}function R(w){let D=[];if(w.shaderID?D.push(w.shaderID):(D.push(w.customVertexShaderID),D.push(w.customFragmentShaderID)),w.defines!==void 0)for(let X in w.defines)D.push(X),D.push(w.defines[X]);return w.isRawShaderMaterial===!1&&(S(D,w),_(D,w),D.push(i.outputColorSpace)),D.push(w.customProgramCacheKey),D.join()}function S(w,D){w.push(D.precision),w.push(D.outputColorSpace),w.push(D.envMapMode),w.push(D.envMapPMREM),w.push(D.envMapMaxLod),w.push(D.envMapSize),w.push(D.mapUv),w.push(D.alphaMapUv),w.push(D.lightMapUv),w.push(D.aoMapUv),w.push(D.bumpMapUv),w.push(D.normalMapUv),w.push(D.displacementMapUv),w.push(D.emissiveMapUv),w.push(D.metalnessMapUv),w.push(D.roughnessMapUv),w.push(D.anisotropyMapUv),w.push(D.clearcoatMapUv),w.push(D.clearcoatNormalMapUv),w.push(D.clearcoatRoughnessMapUv),w.push(D.diffuseRoughnessMapUv),w.push(D.iridescenceMapUv),w.push(D.iridescenceThicknessMapUv),w.push(D.sheenColorMapUv),w.push(D.sheenRoughnessMapUv),w.push(D.specularMapUv),w.push(D.specularColorMapUv),w.push(D.specularIntensityMapUv),w.push(D.transmissionMapUv),w.push(D.thicknessMapUv),w.push(D.combine),w.push(D.fogExp2),w.push(D.sizeAttenuation),w.push(D.morphTargetsCount),w.push(D.numSunLights),w.push(D.numDirLights),w.push(D.numPointLights),w.push(D.numSpotLights),w.push(D.numSpotLightMaps),w.push(D.numHemiLights),w.push(D.numRectAreaLights),w.push(D.numSunLightShadows),w.push(D.numDirLightShadows),w.push(D.numPointLightShadows),w.push(D.numSpotLightShadows),w.push(D.numSpotLightShadowsWithMaps),w.push(D.numLightProbes),w.push(D.numLightProbeGrids),w.push(D.shadowMapType),w.push(D.toneMapping),w.push(D.numClippingPlanes),w.push(D.numClipIntersection),w.push(D.depthPacking)}function _(w,D){l.disableAll(),D.instancing&&l.enable(0),D.instancingColor&&l.enable(1),D.instancingMorph&&l.enable(2),D.matcap&&l.enable(3),D.envMap&&l.enable(4),D.normalMapObjectSpace&&l.enable(5),D.normalMapTangentSpace&&l.enable(6),D.clearcoat&&l.enable(7),D.iridescence&&l.enable(8),D.alphaTest&&l.enable(9),D.vertexColors&&l.enable(10),D.vertexAlphas&&l.enable(11),D.vertexUv1s&&l.enable(12),D.vertexUv2s&&l.enable(13),D.vertexUv3s&&l.enable(14),D.vertexTangents&&l.enable(15),D.anisotropy&&l.enable(16),D.alphaHash&&l.enable(17),D.batching&&l.enable(18),D.dispersion&&l.enable(19),D.retroreflection&&l.enable(24),D.diffuseRoughness&&l.enable(25),D.batchingColor&&l.enable(20),D.gradientMap&&l.enable(21),D.packedNormalMap&&l.enable(22),D.vertexNormals&&l.enable(23),w.push(l.mask),l.disableAll(),D.fog&&l.enable(0),D.useFog&&l.enable(1),D.flatShading&&l.enable(2),D.logarithmicDepthBuffer&&l.enable(3),D.reversedDepthBuffer&&l.enable(4),D.skinning&&l.enable(5),D.morphTargets&&l.enable(6),D.morphNormals&&l.enable(7),D.morphColors&&l.enable(8),D.premultipliedAlpha&&l.enable(9),D.shadowMapEnabled&&l.enable(10),D.doubleSided&&l.enable(11),D.flipSided&&l.enable(12),D.useDepthPacking&&l.enable(13),D.dithering&&l.enable(14),D.transmission&&l.enable(15),D.sheen&&l.enable(16),D.opaque&&l.enable(17),D.pointsUvs&&l.enable(18),D.decodeVideoTexture&&l.enable(19),D.decodeVideoTextureEmissive&&l.enable(20),D.alphaToCoverage&&l.enable(21),D.numLightProbeGrids>0&&l.enable(22),D.hasPositionAttribute&&l.enable(23),w.push(l.mask)}function P(w){let D=g[w.type],X;if(D){let k=gi[D];X=Wd.clone(k.uniforms)}else X=w.uniforms;return X}function U(w,D){let X=m.get(D);return X!==void 0?++X.usedTimes:(X=new ub(i,D,w,r),d.push(X),m.set(D,X)),X}function I(w){if(--w.usedTimes===0){let D=d.indexOf(w);d[D]=d[d.length-1],d.pop(),m.delete(w.cacheKey),w.destroy()}}function O(w){h.remove(w)}function N(){h.dispose()}return{getParameters:M,getProgramCacheKey:R,getUniforms:P,acquireProgram:U,releaseProgram:I,releaseShaderCache:O,programs:d,dispose:N}}function mb(){let i=new WeakMap;function e(l){return i.has(l)}function t(l){let h=i.get(l);return h===void 0&&(h={},i.set(l,h)),h}function n(l){i.delete(l)}function r(l,h,f){i.get(l)[h]=f}function o(){i=new WeakMap}return{has:e,get:t,remove:n,update:r,dispose:o}}function gb(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function uf(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function df(){let i=[],e=0,t=[],n=[],r=[];function o(){e=0,t.length=0,n.length=0,r.length=0}function l(g){let x=0;return g.isInstancedMesh&&(x+=2),g.isSkinnedMesh&&(x+=1),x}function h(g,x,M,R,S,_){let P=i[e];return P===void 0?(P={id:g.id,object:g,geometry:x,material:M,materialVariant:l(g),groupOrder:R,renderOrder:g.renderOrder,z:S,group:_},i[e]=P):(P.id=g.id,P.object=g,P.geometry=x,P.material=M,P.materialVariant=l(g),P.groupOrder=R,P.renderOrder=g.renderOrder,P.z=S,P.group=_),e++,P}function f(g,x,M,R,S,_,P){P.reversedDepth===!0&&(S=-S);let U=h(g,x,M,R,S,_);M.transmission>0?n.push(U):M.transparent===!0?r.push(U):t.push(U)}function d(g,x,M,R,S,_){let P=h(g,x,M,R,S,_);M.transmission>0?n.unshift(P):M.transparent===!0?r.unshift(P):t.unshift(P)}function m(g,x){t.length>1&&t.sort(g||gb),n.length>1&&n.sort(x||uf),r.length>1&&r.sort(x||uf)}function y(){for(let g=e,x=i.length;g<x;g++){let M=i[g];if(M.id===null)break;M.id=null,M.object=null,M.geometry=null,M.material=null,M.group=null}}return{opaque:t,transmissive:n,transparent:r,init:o,push:f,unshift:d,finish:y,sort:m}}function _b(){let i=new WeakMap;function e(n,r){let o=i.get(n),l;return o===void 0?(l=new df,i.set(n,[l])):r>=o.length?(l=new df,o.push(l)):l=o[r],l}function t(){i=new WeakMap}return{get:e,dispose:t}}function vb(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new j,color:new ht};break;case"SpotLight":t={position:new j,direction:new j,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new j,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new j,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new j,halfWidth:new j,halfHeight:new j};break}return i[e.id]=t,t}}}function yb(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var xb=0;function Sb(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Mb(i){let e=new vb,t=yb(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let d=0;d<9;d++)n.probe.push(new j);let r=new j,o=new Lt,l=new Lt;function h(d){let m=0,y=0,g=0;for(let Z=0;Z<9;Z++)n.probe[Z].set(0,0,0);let x=0,M=0,R=0,S=0,_=0,P=0,U=0,I=0,O=0,N=0,w=0,D=0,X=0,k=0;d.sort(Sb);for(let Z=0,ee=d.length;Z<ee;Z++){let z=d[Z],ie=z.color,G=z.intensity,ne=z.distance,Se=null;if(z.shadow&&z.shadow.map&&(z.shadow.map.texture.format===Zi?Se=z.shadow.map.texture:Se=z.shadow.map.depthTexture||z.shadow.map.texture),z.isAmbientLight)m+=ie.r*G,y+=ie.g*G,g+=ie.b*G;else if(z.isLightProbe){for(let re=0;re<9;re++)n.probe[re].addScaledVector(z.sh.coefficients[re],G);k++}else if(z.isSunLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize.copy(H.mapSize).multiply(H.getFrameExtents()),n.sunShadow[M]=ge,n.sunShadowMap[M]=Se;let We=H.getViewportCount();for(let it=0;it<We;it++)n.sunShadowMatrix[R+it]=H.getMatrix(it),n.sunShadowCascade[R+it]=H._cascadeData[it];R+=We,M++}n.sun[x]=re,x++}else if(z.isDirectionalLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.directionalShadow[S]=ge,n.directionalShadowMap[S]=Se,n.directionalShadowMatrix[S]=z.shadow.matrix,O++}n.directional[S]=re,S++}else if(z.isSpotLight){let re=e.get(z);re.position.setFromMatrixPosition(z.matrixWorld),re.color.copy(ie).multiplyScalar(G),re.distance=ne,re.coneCos=Math.cos(z.angle),re.penumbraCos=Math.cos(z.angle*(1-z.penumbra)),re.decay=z.decay,n.spot[P]=re;let H=z.shadow;if(z.map&&(n.spotLightMap[D]=z.map,D++,H.updateMatrices(z),z.castShadow&&X++),n.spotLightMatrix[P]=H.matrix,z.castShadow){let ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.spotShadow[P]=ge,n.spotShadowMap[P]=Se,w++}P++}else if(z.isRectAreaLight){let re=e.get(z);re.color.copy(ie).multiplyScalar(G),re.halfWidth.set(z.width*.5,0,0),re.halfHeight.set(0,z.height*.5,0),n.rectArea[U]=re,U++}else if(z.isPointLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),re.distance=z.distance,re.decay=z.decay,z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,ge.shadowCameraNear=H.camera.near,ge.shadowCameraFar=H.camera.far,n.pointShadow[_]=ge,n.pointShadowMap[_]=Se,n.pointShadowMatrix[_]=z.shadow.matrix,N++}n.point[_]=re,_++}else if(z.isHemisphereLight){let re=e.get(z);re.skyColor.copy(z.color).multiplyScalar(G),re.groundColor.copy(z.groundColor).multiplyScalar(G),n.hemi[I]=re,I++}}U>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Be.LTC_FLOAT_1,n.rectAreaLTC2=Be.LTC_FLOAT_2):(n.rectAreaLTC1=Be.LTC_HALF_1,n.rectAreaLTC2=Be.LTC_HALF_2)),n.ambient[0]=m,n.ambient[1]=y,n.ambient[2]=g;let Y=n.hash;(Y.sunLength!==x||Y.directionalLength!==S||Y.pointLength!==_||Y.spotLength!==P||Y.rectAreaLength!==U||Y.hemiLength!==I||Y.numSunShadows!==M||Y.numDirectionalShadows!==O||Y.numPointShadows!==N||Y.numSpotShadows!==w||Y.numSpotMaps!==D||Y.numLightProbes!==k)&&(n.sun.length=x,n.directional.length=S,n.spot.length=P,n.rectArea.length=U,n.point.length=_,n.hemi.length=I,n.sunShadow.length=M,n.sunShadowMap.length=M,n.sunShadowMatrix.length=R,n.sunShadowCascade.length=R,n.directionalShadow.length=O,n.directionalShadowMap.length=O,n.directionalShadowMatrix.length=O,n.pointShadow.length=N,n.pointShadowMap.length=N,n.pointShadowMatrix.length=N,n.spotShadow.length=w,n.spotShadowMap.length=w,n.spotLightMatrix.length=w+D-X,n.spotLightMap.length=D,n.numSpotLightShadowsWithMaps=X,n.numLightProbes=k,Y.sunLength=x,Y.directionalLength=S,Y.pointLength=_,Y.spotLength=P,Y.rectAreaLength=U,Y.hemiLength=I,Y.numSunShadows=M,Y.numDirectionalShadows=O,Y.numPointShadows=N,Y.numSpotShadows=w,Y.numSpotMaps=D,Y.numLightProbes=k,n.version=xb++)}function f(d,m){let y=0,g=0,x=0,M=0,R=0,S=0,_=m.matrixWorldInverse;for(let P=0,U=d.length;P<U;P++){let I=d[P];if(I.isSunLight){let O=n.sun[y];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(_),y++}else if(I.isDirectionalLight){let O=n.directional[g];O.direction.setFromMatrixPosition(I.matrixWorld),r.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(r),O.direction.transformDirection(_),g++}else if(I.isSpotLight){let O=n.spot[M];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(_),O.direction.setFromMatrixPosition(I.matrixWorld),r.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(r),O.direction.transformDirection(_),M++}else if(I.isRectAreaLight){let O=n.rectArea[R];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(_),l.identity(),o.copy(I.matrixWorld),o.premultiply(_),l.extractRotation(o),O.halfWidth.set(I.width*.5,0,0),O.halfHeight.set(0,I.height*.5,0),O.halfWidth.applyMatrix4(l),O.halfHeight.applyMatrix4(l),R++}else if(I.isPointLight){let O=n.point[x];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(_),x++}else if(I.isHemisphereLight){let O=n.hemi[S];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(_),S++}}}return{setup:h,setupView:f,state:n}}function ff(i){let e=new Mb(i),t=[],n=[],r=[];function o(y){m.camera=y,t.length=0,n.length=0,r.length=0}function l(y){y.isLightProbeGrid?r.push(y):t.push(y)}function h(y){n.push(y)}function f(){e.setup(t),r.sort((y,g)=>y.priority-g.priority||y.id-g.id)}function d(y){e.setupView(t,y)}let m={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:o,state:m,setupLights:f,setupLightsView:d,pushLight:l,pushShadow:h}}function bb(i){let e=new WeakMap;function t(r,o=0){let l=e.get(r),h;return l===void 0?(h=new ff(i),e.set(r,[h])):o>=l.length?(h=new ff(i),l.push(h)):h=l[o],h}function n(){e=new WeakMap}return{get:t,dispose:n}}var wb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Eb=`uniform sampler2D shadow_pass;
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
}`,Tb=[new j(1,0,0),new j(-1,0,0),new j(0,1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1)],Ab=[new j(0,-1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1),new j(0,-1,0),new j(0,-1,0)],pf=new Lt,oa=new j,vh=new j;function Cb(i,e,t){let n=new Vi,r=new et,o=new et,l=new Gt,h=new Io,f=new Do,d={},m=t.maxTextureSize,y={[ji]:dn,[dn]:ji,[fi]:fi},g=new di({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new et},radius:{value:4}},vertexShader:wb,fragmentShader:Eb}),x=g.clone();x.defines.HORIZONTAL_PASS=1;let M=new En;M.setAttribute("position",new Dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let R=new zt(M,g),S=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ur;let _=this.type;this.render=function(N,w,D){if(S.enabled===!1||S.autoUpdate===!1&&S.needsUpdate===!1||N.length===0)return;this.type===ad&&(Qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ur);let X=i.getRenderTarget(),k=i.getActiveCubeFace(),Y=i.getActiveMipmapLevel(),Z=i.state;Z.setBlending(dr),Z.buffers.depth.getReversed()===!0?Z.buffers.color.setClear(0,0,0,0):Z.buffers.color.setClear(1,1,1,1),Z.buffers.depth.setTest(!0),Z.setScissorTest(!1);let ee=_!==this.type;ee&&w.traverse(function(z){z.material&&(Array.isArray(z.material)?z.material.forEach(ie=>ie.needsUpdate=!0):z.material.needsUpdate=!0)});for(let z=0,ie=N.length;z<ie;z++){let G=N[z],ne=G.shadow;if(ne===void 0){Qe("WebGLShadowMap:",G,"has no shadow.");continue}if(ne.autoUpdate===!1&&ne.needsUpdate===!1)continue;r.copy(ne.mapSize);let Se=ne.getFrameExtents();r.multiply(Se),o.copy(ne.mapSize),(r.x>m||r.y>m)&&(r.x>m&&(o.x=Math.floor(m/Se.x),r.x=o.x*Se.x,ne.mapSize.x=o.x),r.y>m&&(o.y=Math.floor(m/Se.y),r.y=o.y*Se.y,ne.mapSize.y=o.y));let re=i.state.buffers.depth.getReversed();if(ne.camera._reversedDepth=re,ne.map===null||ee===!0){if(ne.map!==null&&(ne.map.depthTexture!==null&&(ne.map.depthTexture.dispose(),ne.map.depthTexture=null),ne.map.dispose()),this.type===Yr){if(G.isPointLight){Qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}ne.map=new Ln(r.x,r.y,{format:Zi,type:Jn,minFilter:Mn,magFilter:Mn,generateMipmaps:!1}),ne.map.texture.name=G.name+".shadowMap",ne.map.depthTexture=new Ai(r.x,r.y,Vn),ne.map.depthTexture.name=G.name+".shadowMapDepth",ne.map.depthTexture.format=Ei,ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn}else G.isPointLight?(ne.map=new ca(r.x),ne.map.depthTexture=new Bs(r.x,Zn)):(ne.map=new Ln(r.x,r.y),ne.map.depthTexture=new Ai(r.x,r.y,Zn)),ne.map.depthTexture.name=G.name+".shadowMap",ne.map.depthTexture.format=Ei,this.type===ur?(ne.map.depthTexture.compareFunction=re?sh:rh,ne.map.depthTexture.minFilter=Mn,ne.map.depthTexture.magFilter=Mn):(ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn);ne.camera.updateProjectionMatrix()}ne.map.isWebGLCubeRenderTarget!==!0&&(ne.map.width!==r.x||ne.map.height!==r.y)&&ne.map.setSize(r.x,r.y);let H=ne.map.isWebGLCubeRenderTarget?6:ne.getViewportCount();G.isPointLight!==!0&&ne.updateMatrices(G,D);let ge=(ne.camera.layers.mask&4294967294)!==0?ne.camera.layers:D.layers;for(let We=0;We<H;We++){let it=ne.getCamera(We);if(G.isPointLight){let ue=ne.camera,Fe=ne.matrix,Pe=G.distance||ue.far;Pe!==ue.far&&(ue.far=Pe,ue.updateProjectionMatrix()),oa.setFromMatrixPosition(G.matrixWorld),ue.position.copy(oa),vh.copy(ue.position),vh.add(Tb[We]),ue.up.copy(Ab[We]),ue.lookAt(vh),ue.updateMatrixWorld(),Fe.makeTranslation(-oa.x,-oa.y,-oa.z),pf.multiplyMatrices(ue.projectionMatrix,ue.matrixWorldInverse),ne._frustum.setFromProjectionMatrix(pf,ue.coordinateSystem,ue.reversedDepth)}if(ne.map.isWebGLCubeRenderTarget)i.setRenderTarget(ne.map,We),i.clear();else{We===0&&(i.setRenderTarget(ne.map),i.clear());let ue=ne.getViewport(We);l.set(o.x*ue.x,o.y*ue.y,o.x*ue.z,o.y*ue.w),Z.viewport(l)}n=ne.getFrustum(We),I(w,D,it,G,ge,this.type)}ne.isPointLightShadow!==!0&&this.type===Yr&&P(ne,D),ne.needsUpdate=!1}_=this.type,S.needsUpdate=!1,i.setRenderTarget(X,k,Y)};function P(N,w){let D=e.update(R);g.defines.VSM_SAMPLES!==N.blurSamples&&(g.defines.VSM_SAMPLES=N.blurSamples,x.defines.VSM_SAMPLES=N.blurSamples,g.needsUpdate=!0,x.needsUpdate=!0),N.mapPass===null?N.mapPass=new Ln(r.x,r.y,{format:Zi,type:Jn}):(N.mapPass.width!==N.map.width||N.mapPass.height!==N.map.height)&&N.mapPass.setSize(N.map.width,N.map.height),g.uniforms.shadow_pass.value=N.map.depthTexture,g.uniforms.resolution.value.set(N.map.width,N.map.height),g.uniforms.radius.value=N.radius,i.setRenderTarget(N.mapPass),i.clear(),i.renderBufferDirect(w,null,D,g,R,null),x.uniforms.shadow_pass.value=N.mapPass.texture,x.uniforms.resolution.value.set(N.map.width,N.map.height),x.uniforms.radius.value=N.radius,i.setRenderTarget(N.map),i.clear(),i.renderBufferDirect(w,null,D,x,R,null)}function U(N,w,D,X){let k=null,Y=D.isPointLight===!0?N.customDistanceMaterial:N.customDepthMaterial;if(Y!==void 0)k=Y;else if(k=D.isPointLight===!0?f:h,i.localClippingEnabled&&w.clipShadows===!0&&Array.isArray(w.clippingPlanes)&&w.clippingPlanes.length!==0||w.displacementMap&&w.displacementScale!==0||w.alphaMap&&w.alphaTest>0||w.map&&w.alphaTest>0||w.alphaToCoverage===!0){let Z=k.uuid,ee=w.uuid,z=d[Z];z===void 0&&(z={},d[Z]=z);let ie=z[ee];ie===void 0&&(ie=k.clone(),z[ee]=ie,w.addEventListener("dispose",O)),k=ie}if(k.visible=w.visible,k.wireframe=w.wireframe,X===Yr?k.side=w.shadowSide!==null?w.shadowSide:w.side:k.side=w.shadowSide!==null?w.shadowSide:y[w.side],k.alphaMap=w.alphaMap,k.alphaTest=w.alphaToCoverage===!0?.5:w.alphaTest,k.map=w.map,k.clipShadows=w.clipShadows,k.clippingPlanes=w.clippingPlanes,k.clipIntersection=w.clipIntersection,k.displacementMap=w.displacementMap,k.displacementScale=w.displacementScale,k.displacementBias=w.displacementBias,k.wireframeLinewidth=w.wireframeLinewidth,k.linewidth=w.linewidth,D.isPointLight===!0&&k.isMeshDistanceMaterial===!0){let Z=i.properties.get(k);Z.light=D}return k}function I(N,w,D,X,k,Y){if(N.visible===!1)return;if(N.layers.test(k)&&(N.isMesh||N.isLine||N.isPoints)&&(N.castShadow||N.receiveShadow&&Y===Yr)&&(!N.frustumCulled||N.intersectsFrustum(n))){N.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,N.matrixWorld);let z=e.update(N),ie=N.material;if(Array.isArray(ie)){let G=z.groups;for(let ne=0,Se=G.length;ne<Se;ne++){let re=G[ne],H=ie[re.materialIndex];if(H&&H.visible){let ge=U(N,H,X,Y);N.onBeforeShadow(i,N,w,D,z,ge,re),i.renderBufferDirect(D,null,z,ge,N,re),N.onAfterShadow(i,N,w,D,z,ge,re)}}}else if(ie.visible){let G=U(N,ie,X,Y);N.onBeforeShadow(i,N,w,D,z,G,null),i.renderBufferDirect(D,null,z,G,N,null),N.onAfterShadow(i,N,w,D,z,G,null)}}let ee=N.children;for(let z=0,ie=ee.length;z<ie;z++)I(ee[z],w,D,X,k,Y)}function O(N){N.target.removeEventListener("dispose",O);for(let D in d){let X=d[D],k=N.target.uuid;k in X&&(X[k].dispose(),delete X[k])}}}function Rb(i,e){function t(){let B=!1,he=new Gt,se=null,Re=new Gt(0,0,0,0);return{setMask:function(Ee){se!==Ee&&!B&&(i.colorMask(Ee,Ee,Ee,Ee),se=Ee)},setLocked:function(Ee){B=Ee},setClear:function(Ee,Ae,Xe,ut,we){we===!0&&(Ee*=ut,Ae*=ut,Xe*=ut),he.set(Ee,Ae,Xe,ut),Re.equals(he)===!1&&(i.clearColor(Ee,Ae,Xe,ut),Re.copy(he))},reset:function(){B=!1,se=null,Re.set(-1,0,0,0)}}}function n(){let B=!1,he=!1,se=null,Re=null,Ee=null;return{setReversed:function(Ae){if(he!==Ae){let Xe=e.get("EXT_clip_control");Ae?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),he=Ae;let ut=Ee;Ee=null,this.setClear(ut)}},getReversed:function(){return he},setTest:function(Ae){Ae?Ue(i.DEPTH_TEST):ot(i.DEPTH_TEST)},setMask:function(Ae){se!==Ae&&!B&&(i.depthMask(Ae),se=Ae)},setFunc:function(Ae){if(he&&(Ae=zd[Ae]),Re!==Ae){switch(Ae){case fo:i.depthFunc(i.NEVER);break;case po:i.depthFunc(i.ALWAYS);break;case mo:i.depthFunc(i.LESS);break;case Ur:i.depthFunc(i.LEQUAL);break;case go:i.depthFunc(i.EQUAL);break;case _o:i.depthFunc(i.GEQUAL);break;case vo:i.depthFunc(i.GREATER);break;case yo:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ae}},setLocked:function(Ae){B=Ae},setClear:function(Ae){Ee!==Ae&&(Ee=Ae,he&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){B=!1,se=null,Re=null,Ee=null,he=!1}}}function r(){let B=!1,he=null,se=null,Re=null,Ee=null,Ae=null,Xe=null,ut=null,we=null;return{setTest:function($e){B||($e?Ue(i.STENCIL_TEST):ot(i.STENCIL_TEST))},setMask:function($e){he!==$e&&!B&&(i.stencilMask($e),he=$e)},setFunc:function($e,dt,Oe){(se!==$e||Re!==dt||Ee!==Oe)&&(i.stencilFunc($e,dt,Oe),se=$e,Re=dt,Ee=Oe)},setOp:function($e,dt,Oe){(Ae!==$e||Xe!==dt||ut!==Oe)&&(i.stencilOp($e,dt,Oe),Ae=$e,Xe=dt,ut=Oe)},setLocked:function($e){B=$e},setClear:function($e){we!==$e&&(i.clearStencil($e),we=$e)},reset:function(){B=!1,he=null,se=null,Re=null,Ee=null,Ae=null,Xe=null,ut=null,we=null}}}let o=new t,l=new n,h=new r,f={},d=new WeakMap,m={},y={},g={},x=new WeakMap,M=[],R=null,S=!1,_=null,P=null,U=null,I=null,O=null,N=null,w=null,D=new ht(0,0,0),X=0,k=!1,Y=null,Z=null,ee=null,z=null,ie=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),ne=!1,Se=0,re=i.getParameter(i.VERSION);re.indexOf("WebGL")!==-1?(Se=parseFloat(/^WebGL (\d)/.exec(re)[1]),ne=Se>=1):re.indexOf("OpenGL ES")!==-1&&(Se=parseFloat(/^OpenGL ES (\d)/.exec(re)[1]),ne=Se>=2);let H=null,ge={},We=i.getParameter(i.SCISSOR_BOX),it=i.getParameter(i.VIEWPORT),ue=new Gt().fromArray(We),Fe=new Gt().fromArray(it);function Pe(B,he,se,Re){let Ee=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(B,Ae),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xe=0;Xe<se;Xe++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(he,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,Ee):i.texImage2D(he+Xe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Ee);return Ae}let je={};je[i.TEXTURE_2D]=Pe(i.TEXTURE_2D,i.TEXTURE_2D,1),je[i.TEXTURE_CUBE_MAP]=Pe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),je[i.TEXTURE_2D_ARRAY]=Pe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),je[i.TEXTURE_3D]=Pe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),o.setClear(0,0,0,1),l.setClear(1),h.setClear(0),Ue(i.DEPTH_TEST),l.setFunc(Ur),It(!1),Mt(kc),Ue(i.CULL_FACE),Ht(dr);function Ue(B){m[B]!==!0&&(i.enable(B),m[B]=!0)}function ot(B){m[B]!==!1&&(i.disable(B),m[B]=!1)}function Vt(B,he){return g[B]!==he?(i.bindFramebuffer(B,he),g[B]=he,B===i.DRAW_FRAMEBUFFER&&(g[i.FRAMEBUFFER]=he),B===i.FRAMEBUFFER&&(g[i.DRAW_FRAMEBUFFER]=he),!0):!1}function Ke(B,he){let se=M,Re=!1;if(B){se=x.get(he),se===void 0&&(se=[],x.set(he,se));let Ee=B.textures;if(se.length!==Ee.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Xe=Ee.length;Ae<Xe;Ae++)se[Ae]=i.COLOR_ATTACHMENT0+Ae;se.length=Ee.length,Re=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,Re=!0);Re&&i.drawBuffers(se)}function Et(B){return R!==B?(i.useProgram(B),R=B,!0):!1}let Ct={[fr]:i.FUNC_ADD,[ld]:i.FUNC_SUBTRACT,[cd]:i.FUNC_REVERSE_SUBTRACT};Ct[hd]=i.MIN,Ct[ud]=i.MAX;let mt={[dd]:i.ZERO,[fd]:i.ONE,[pd]:i.SRC_COLOR,[Hc]:i.SRC_ALPHA,[xd]:i.SRC_ALPHA_SATURATE,[vd]:i.DST_COLOR,[gd]:i.DST_ALPHA,[md]:i.ONE_MINUS_SRC_COLOR,[Wc]:i.ONE_MINUS_SRC_ALPHA,[yd]:i.ONE_MINUS_DST_COLOR,[_d]:i.ONE_MINUS_DST_ALPHA,[Sd]:i.CONSTANT_COLOR,[Md]:i.ONE_MINUS_CONSTANT_COLOR,[bd]:i.CONSTANT_ALPHA,[wd]:i.ONE_MINUS_CONSTANT_ALPHA};function Ht(B,he,se,Re,Ee,Ae,Xe,ut,we,$e){if(B===dr){S===!0&&(ot(i.BLEND),S=!1);return}if(S===!1&&(Ue(i.BLEND),S=!0),B!==od){if(B!==_||$e!==k){if((P!==fr||O!==fr)&&(i.blendEquation(i.FUNC_ADD),P=fr,O=fr),$e)switch(B){case jr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case zc:i.blendFunc(i.ONE,i.ONE);break;case Gc:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Vc:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",B);break}else switch(B){case jr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case zc:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Gc:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vc:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",B);break}U=null,I=null,N=null,w=null,D.set(0,0,0),X=0,_=B,k=$e}return}Ee=Ee||he,Ae=Ae||se,Xe=Xe||Re,(he!==P||Ee!==O)&&(i.blendEquationSeparate(Ct[he],Ct[Ee]),P=he,O=Ee),(se!==U||Re!==I||Ae!==N||Xe!==w)&&(i.blendFuncSeparate(mt[se],mt[Re],mt[Ae],mt[Xe]),U=se,I=Re,N=Ae,w=Xe),(ut.equals(D)===!1||we!==X)&&(i.blendColor(ut.r,ut.g,ut.b,we),D.copy(ut),X=we),_=B,k=!1}function pt(B,he){B.side===fi?ot(i.CULL_FACE):Ue(i.CULL_FACE);let se=B.side===dn;he&&(se=!se),It(se),B.blending===jr&&B.transparent===!1?Ht(dr):Ht(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),l.setFunc(B.depthFunc),l.setTest(B.depthTest),l.setMask(B.depthWrite),o.setMask(B.colorWrite);let Re=B.stencilWrite;h.setTest(Re),Re&&(h.setMask(B.stencilWriteMask),h.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),h.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),De(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Ue(i.SAMPLE_ALPHA_TO_COVERAGE):ot(i.SAMPLE_ALPHA_TO_COVERAGE)}function It(B){Y!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),Y=B)}function Mt(B){B!==rd?(Ue(i.CULL_FACE),B!==Z&&(B===kc?i.cullFace(i.BACK):B===sd?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):ot(i.CULL_FACE),Z=B}function rn(B){B!==ee&&(ne&&i.lineWidth(B),ee=B)}function De(B,he,se){B?(Ue(i.POLYGON_OFFSET_FILL),(z!==he||ie!==se)&&(z=he,ie=se,l.getReversed()&&(he=-he,se=-se),i.polygonOffset(he,se))):ot(i.POLYGON_OFFSET_FILL)}function qe(B){B?Ue(i.SCISSOR_TEST):ot(i.SCISSOR_TEST)}function hn(B){B===void 0&&(B=i.TEXTURE0+G-1),H!==B&&(i.activeTexture(B),H=B)}function sn(B,he,se){se===void 0&&(H===null?se=i.TEXTURE0+G-1:se=H);let Re=ge[se];Re===void 0&&(Re={type:void 0,texture:void 0},ge[se]=Re),(Re.type!==B||Re.texture!==he)&&(H!==se&&(i.activeTexture(se),H=se),i.bindTexture(B,he||je[B]),Re.type=B,Re.texture=he)}function W(){let B=ge[H];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function yn(){try{i.compressedTexImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Rt(){try{i.compressedTexImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function Ut(){try{i.texSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Le(){try{i.texSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function qt(){try{i.compressedTexSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Ze(){try{i.compressedTexSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function Je(){try{i.texStorage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function L(){try{i.texStorage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function T(){try{i.texImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function J(){try{i.texImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function ve(B){return y[B]!==void 0?y[B]:i.getParameter(B)}function de(B,he){y[B]!==he&&(i.pixelStorei(B,he),y[B]=he)}function pe(B){ue.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),ue.copy(B))}function Me(B){Fe.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),Fe.copy(B))}function ae(B,he){let se=d.get(he);se===void 0&&(se=new WeakMap,d.set(he,se));let Re=se.get(B);Re===void 0&&(Re=i.getUniformBlockIndex(he,B.name),i.uniformBlockBinding(he,Re,Re),se.set(B,Re))}function le(B,he,se){let Ee=d.get(he).get(B);f[Ee]!==se&&(i.bindBufferBase(i.UNIFORM_BUFFER,Ee,se),f[Ee]=se)}function Ce(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),l.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),m={},y={},H=null,ge={},g={},f={},x=new WeakMap,M=[],R=null,S=!1,_=null,P=null,U=null,I=null,O=null,N=null,w=null,D=new ht(0,0,0),X=0,k=!1,Y=null,Z=null,ee=null,z=null,ie=null,ue.set(0,0,i.canvas.width,i.canvas.height),Fe.set(0,0,i.canvas.width,i.canvas.height),o.reset(),l.reset(),h.reset()}return{buffers:{color:o,depth:l,stencil:h},enable:Ue,disable:ot,bindFramebuffer:Vt,drawBuffers:Ke,useProgram:Et,setBlending:Ht,setMaterial:pt,setFlipSided:It,setCullFace:Mt,setLineWidth:rn,setPolygonOffset:De,setScissorTest:qe,activeTexture:hn,bindTexture:sn,unbindTexture:W,compressedTexImage2D:yn,compressedTexImage3D:Rt,texImage2D:T,texImage3D:J,pixelStorei:de,getParameter:ve,updateUBOMapping:ae,uniformBlockBinding:le,texStorage2D:Je,texStorage3D:L,texSubImage2D:Ut,texSubImage3D:Le,compressedTexSubImage2D:qt,compressedTexSubImage3D:Ze,scissor:pe,viewport:Me,reset:Ce}}function Pb(i,e,t,n,r,o,l){let h=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,f=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),d=new et,m=new WeakMap,y=new Set,g,x=new WeakMap,M=new Set,R=new FinalizationRegistry(L=>M.delete(L)),S=!1;try{S=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(L,T){return S?new OffscreenCanvas(L,T):Ts("canvas")}function P(L,T,J){let ve=1,de=Je(L);if((de.width>J||de.height>J)&&(ve=J/Math.max(de.width,de.height)),ve<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let pe=Math.floor(ve*de.width),Me=Math.floor(ve*de.height);g===void 0&&(g=_(pe,Me));let ae=T?_(pe,Me):g;return ae.width=pe,ae.height=Me,ae.getContext("2d").drawImage(L,0,0,pe,Me),Qe("WebGLRenderer: Texture has been resized from ("+de.width+"x"+de.height+") to ("+pe+"x"+Me+")."),ae}else return"data"in L&&Qe("WebGLRenderer: Image in DataTexture is too big ("+de.width+"x"+de.height+")."),L;return L}function U(L){return L.generateMipmaps}function I(L){i.generateMipmap(L)}function O(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function N(L,T,J,ve,de,pe=!1){if(L!==null){if(i[L]!==void 0)return i[L];Qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let Me;ve&&(Me=e.get("EXT_texture_norm16"),Me||Qe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ae=T;if(T===i.RED&&(J===i.FLOAT&&(ae=i.R32F),J===i.HALF_FLOAT&&(ae=i.R16F),J===i.UNSIGNED_BYTE&&(ae=i.R8),J===i.UNSIGNED_SHORT&&Me&&(ae=Me.R16_EXT),J===i.SHORT&&Me&&(ae=Me.R16_SNORM_EXT)),T===i.RED_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.R8UI),J===i.UNSIGNED_SHORT&&(ae=i.R16UI),J===i.UNSIGNED_INT&&(ae=i.R32UI),J===i.BYTE&&(ae=i.R8I),J===i.SHORT&&(ae=i.R16I),J===i.INT&&(ae=i.R32I)),T===i.RG&&(J===i.FLOAT&&(ae=i.RG32F),J===i.HALF_FLOAT&&(ae=i.RG16F),J===i.UNSIGNED_BYTE&&(ae=i.RG8),J===i.UNSIGNED_SHORT&&Me&&(ae=Me.RG16_EXT),J===i.SHORT&&Me&&(ae=Me.RG16_SNORM_EXT)),T===i.RG_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.RG8UI),J===i.UNSIGNED_SHORT&&(ae=i.RG16UI),J===i.UNSIGNED_INT&&(ae=i.RG32UI),J===i.BYTE&&(ae=i.RG8I),J===i.SHORT&&(ae=i.RG16I),J===i.INT&&(ae=i.RG32I)),T===i.RGB_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.RGB8UI),J===i.UNSIGNED_SHORT&&(ae=i.RGB16UI),J===i.UNSIGNED_INT&&(ae=i.RGB32UI),J===i.BYTE&&(ae=i.RGB8I),J===i.SHORT&&(ae=i.RGB16I),J===i.INT&&(ae=i.RGB32I)),T===i.RGBA_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.RGBA8UI),J===i.UNSIGNED_SHORT&&(ae=i.RGBA16UI),J===i.UNSIGNED_INT&&(ae=i.RGBA32UI),J===i.BYTE&&(ae=i.RGBA8I),J===i.SHORT&&(ae=i.RGBA16I),J===i.INT&&(ae=i.RGBA32I)),T===i.RGB&&(J===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGB16_EXT),J===i.SHORT&&Me&&(ae=Me.RGB16_SNORM_EXT),J===i.UNSIGNED_INT_5_9_9_9_REV&&(ae=i.RGB9_E5),J===i.UNSIGNED_INT_10F_11F_11F_REV&&(ae=i.R11F_G11F_B10F)),T===i.RGBA){let le=pe?Es:St.getTransfer(de);J===i.FLOAT&&(ae=i.RGBA32F),J===i.HALF_FLOAT&&(ae=i.RGBA16F),J===i.UNSIGNED_BYTE&&(ae=le===Pt?i.SRGB8_ALPHA8:i.RGBA8),J===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGBA16_EXT),J===i.SHORT&&Me&&(ae=Me.RGBA16_SNORM_EXT),J===i.UNSIGNED_SHORT_4_4_4_4&&(ae=i.RGBA4),J===i.UNSIGNED_SHORT_5_5_5_1&&(ae=i.RGB5_A1)}return(ae===i.R16F||ae===i.R32F||ae===i.RG16F||ae===i.RG32F||ae===i.RGBA16F||ae===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ae}function w(L,T){let J;return L?T===null||T===Zn||T===mr?J=i.DEPTH24_STENCIL8:T===Vn?J=i.DEPTH32F_STENCIL8:T===Jr&&(J=i.DEPTH24_STENCIL8,Qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Zn||T===mr?J=i.DEPTH_COMPONENT24:T===Vn?J=i.DEPTH_COMPONENT32F:T===Jr&&(J=i.DEPTH_COMPONENT16),J}function D(L,T){return U(L)===!0||L.isFramebufferTexture&&L.minFilter!==cn&&L.minFilter!==Mn?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?T.mipmaps.length:1}function X(L){let T=new WeakRef(L);n.get(L).__ref=T,M.add(T),R.register(L,T,T)}function k(L){let T=n.get(L).__ref;T!==void 0&&(M.delete(T),R.unregister(T))}function Y(L){ee(L.target)}function Z(L){z(L.target)}function ee(L){L.removeEventListener("dispose",Y),k(L),G(L),L.isVideoTexture&&m.delete(L),L.isHTMLTexture&&y.delete(L)}function z(L){L.removeEventListener("dispose",Z),k(L),Se(L)}function ie(){for(let L of M){let T=L.deref();T!==void 0&&(T.isRenderTarget===!0?z(T):ee(T))}M.clear(),y.clear()}function G(L){let T=n.get(L);if(T.__webglInit===void 0)return;let J=L.source,ve=x.get(J);if(ve){let de=ve[T.__cacheKey];de.usedTimes--,de.usedTimes===0&&ne(L),Object.keys(ve).length===0&&x.delete(J)}n.remove(L)}function ne(L){let T=n.get(L);i.deleteTexture(T.__webglTexture);let J=L.source,ve=x.get(J);delete ve[T.__cacheKey],l.memory.textures--}function Se(L){let T=n.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let J=L.depthTexture;if(J&&J.renderTarget===L&&ee(J),L.isWebGLCubeRenderTarget)for(let de=0;de<6;de++){if(Array.isArray(T.__webglFramebuffer[de]))for(let pe=0;pe<T.__webglFramebuffer[de].length;pe++)i.deleteFramebuffer(T.__webglFramebuffer[de][pe]);else i.deleteFramebuffer(T.__webglFramebuffer[de]);T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer[de])}else{if(Array.isArray(T.__webglFramebuffer))for(let de=0;de<T.__webglFramebuffer.length;de++)i.deleteFramebuffer(T.__webglFramebuffer[de]);else i.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&i.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let de=0;de<T.__webglColorRenderbuffer.length;de++)T.__webglColorRenderbuffer[de]&&i.deleteRenderbuffer(T.__webglColorRenderbuffer[de]);T.__webglDepthRenderbuffer&&i.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ve=L.textures;for(let de=0,pe=ve.length;de<pe;de++){let Me=n.get(ve[de]);Me.__webglTexture&&(i.deleteTexture(Me.__webglTexture),l.memory.textures--),n.remove(ve[de])}n.remove(L)}let re=0;function H(){re=0}function ge(){return re}function We(L){re=L}function it(){let L=re;return L>=r.maxTextures&&Qe("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+r.maxTextures),re+=1,L}function ue(L){let T=[];return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.join()}function Fe(L,T){let J=n.get(L);if(L.isVideoTexture&&qt(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&J.__version!==L.version){let ve=L.image;if(ve===null)Qe("WebGLRenderer: Texture marked for update but no image data found.");else if(ve.complete===!1)Qe("WebGLRenderer: Texture marked for update but image is incomplete");else{pt(J,L,T);return}}else L.isExternalTexture&&(J.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,J.__webglTexture,i.TEXTURE0+T)}function Pe(L,T){let J=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&J.__version!==L.version){pt(J,L,T);return}else L.isExternalTexture&&(J.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,J.__webglTexture,i.TEXTURE0+T)}function je(L,T){let J=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&J.__version!==L.version){pt(J,L,T);return}t.bindTexture(i.TEXTURE_3D,J.__webglTexture,i.TEXTURE0+T)}function Ue(L,T){let J=n.get(L);if(L.version>0&&J.__version!==L.version){It(J,L,T);return}t.bindTexture(i.TEXTURE_CUBE_MAP,J.__webglTexture,i.TEXTURE0+T)}let ot={[Or]:i.REPEAT,[oi]:i.CLAMP_TO_EDGE,[xo]:i.MIRRORED_REPEAT},Vt={[cn]:i.NEAREST,[Ad]:i.NEAREST_MIPMAP_NEAREST,[Qs]:i.NEAREST_MIPMAP_LINEAR,[Mn]:i.LINEAR,[$o]:i.LINEAR_MIPMAP_NEAREST,[Ri]:i.LINEAR_MIPMAP_LINEAR},Ke={[Id]:i.NEVER,[ah]:i.ALWAYS,[Dd]:i.LESS,[rh]:i.LEQUAL,[Ld]:i.EQUAL,[sh]:i.GEQUAL,[Fd]:i.GREATER,[Nd]:i.NOTEQUAL};function Et(L,T){if(T.type===Vn&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===Mn||T.magFilter===$o||T.magFilter===Qs||T.magFilter===Ri||T.minFilter===Mn||T.minFilter===$o||T.minFilter===Qs||T.minFilter===Ri)&&Qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,ot[T.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,ot[T.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,ot[T.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,Vt[T.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,Vt[T.minFilter]),T.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Ke[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===cn||T.minFilter!==Qs&&T.minFilter!==Ri||T.type===Vn&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let J=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,r.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function Ct(L,T){let J=!1;L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",Y),X(T));let ve=T.source,de=x.get(ve);de===void 0&&(de={},x.set(ve,de));let pe=ue(T);if(pe!==L.__cacheKey){de[pe]===void 0&&(de[pe]={texture:i.createTexture(),usedTimes:0},l.memory.textures++,J=!0),de[pe].usedTimes++;let Me=de[L.__cacheKey];Me!==void 0&&(de[L.__cacheKey].usedTimes--,Me.usedTimes===0&&ne(T)),L.__cacheKey=pe,L.__webglTexture=de[pe].texture}return J}function mt(L,T,J){return Math.floor(Math.floor(L/J)/T)}function Ht(L,T,J,ve){let pe=L.updateRanges;if(pe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,T.width,T.height,J,ve,T.data);else{pe.sort((B,he)=>B.start-he.start);let Me=0;for(let B=1;B<pe.length;B++){let he=pe[Me],se=pe[B],Re=he.start+he.count,Ee=mt(se.start,T.width,4),Ae=mt(he.start,T.width,4);se.start<=Re+1&&Ee===Ae&&mt(se.start+se.count-1,T.width,4)===Ee?he.count=Math.max(he.count,se.start+se.count-he.start):(++Me,pe[Me]=se)}pe.length=Me+1;let ae=t.getParameter(i.UNPACK_ROW_LENGTH),le=t.getParameter(i.UNPACK_SKIP_PIXELS),Ce=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,T.width);for(let B=0,he=pe.length;B<he;B++){let se=pe[B],Re=Math.floor(se.start/4),Ee=Math.ceil(se.count/4),Ae=Re%T.width,Xe=Math.floor(Re/T.width),ut=Ee,we=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Xe,ut,we,J,ve,T.data)}L.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ae),t.pixelStorei(i.UNPACK_SKIP_PIXELS,le),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ce)}}function pt(L,T,J){let ve=i.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ve=i.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ve=i.TEXTURE_3D);let de=Ct(L,T),pe=T.source;t.bindTexture(ve,L.__webglTexture,i.TEXTURE0+J);let Me=n.get(pe);if(pe.version!==Me.__version||de===!0){if(t.activeTexture(i.TEXTURE0+J),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let we=St.getPrimaries(St.workingColorSpace),$e=T.colorSpace===Ii?null:St.getPrimaries(T.colorSpace),dt=T.colorSpace===Ii||we===$e?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,dt)}t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment);let le=P(T.image,!1,r.maxTextureSize);le=Ze(T,le);let Ce=o.convert(T.format,T.colorSpace),B=o.convert(T.type),he=N(T.internalFormat,Ce,B,T.normalized,T.colorSpace,T.isVideoTexture);Et(ve,T);let se,Re=T.mipmaps,Ee=T.isVideoTexture!==!0,Ae=Me.__version===void 0||de===!0,Xe=pe.dataReady,ut=D(T,le);if(T.isDepthTexture)he=w(T.format===Pi,T.type),Ae&&(Ee?t.texStorage2D(i.TEXTURE_2D,1,he,le.width,le.height):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Ce,B,null));else if(T.isDataTexture)if(Re.length>0){Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Re[0].width,Re[0].height);for(let we=0,$e=Re.length;we<$e;we++)se=Re[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Ce,B,se.data);T.generateMipmaps=!1}else Ee?(Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height),Xe&&Ht(T,le,Ce,B)):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Ce,B,le.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){Ee&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,Re[0].width,Re[0].height,le.depth);for(let we=0,$e=Re.length;we<$e;we++)if(se=Re[we],T.format!==Kn)if(Ce!==null)if(Ee){if(Xe)if(T.layerUpdates.size>0){let dt=gh(se.width,se.height,T.format,T.type);for(let Oe of T.layerUpdates){let Tt=se.data.subarray(Oe*dt/se.data.BYTES_PER_ELEMENT,(Oe+1)*dt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,Oe,se.width,se.height,1,Ce,Tt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Ce,se.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,se.data,0,0);else Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ee?Xe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Ce,B,se.data):t.texImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,Ce,B,se.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Re[0].width,Re[0].height);for(let we=0,$e=Re.length;we<$e;we++)se=Re[we],T.format!==Kn?Ce!==null?Ee?Xe&&t.compressedTexSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,se.data):t.compressedTexImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,se.data):Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Ce,B,se.data)}else if(T.isDataArrayTexture)if(Ee){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,le.width,le.height,le.depth),Xe)if(T.layerUpdates.size>0){let we=gh(le.width,le.height,T.format,T.type);for(let $e of T.layerUpdates){let dt=le.data.subarray($e*we/le.data.BYTES_PER_ELEMENT,($e+1)*we/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,$e,le.width,le.height,1,Ce,B,dt)}T.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,Ce,B,le.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,he,le.width,le.height,le.depth,0,Ce,B,le.data);else if(T.isData3DTexture)Ee?(Ae&&t.texStorage3D(i.TEXTURE_3D,ut,he,le.width,le.height,le.depth),Xe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,Ce,B,le.data)):t.texImage3D(i.TEXTURE_3D,0,he,le.width,le.height,le.depth,0,Ce,B,le.data);else if(T.isFramebufferTexture){if(Ae)if(Ee)t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height);else{let we=le.width,$e=le.height;for(let dt=0;dt<ut;dt++)t.texImage2D(i.TEXTURE_2D,dt,he,we,$e,0,Ce,B,null),we>>=1,$e>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in i){let we=i.canvas;if(we.hasAttribute("layoutsubtree")||we.setAttribute("layoutsubtree","true"),le.parentNode!==we){we.appendChild(le),y.add(T),we.onpaint=$e=>{let dt=$e.changedElements;for(let Oe of y)dt.includes(Oe.image)&&(Oe.needsUpdate=!0)},we.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,le);else{let dt=i.RGBA,Oe=i.RGBA,Tt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,dt,Oe,Tt,le)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(Ee&&Ae){let we=Je(Re[0]);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}for(let we=0,$e=Re.length;we<$e;we++)se=Re[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,Ce,B,se):t.texImage2D(i.TEXTURE_2D,we,he,Ce,B,se);T.generateMipmaps=!1}else if(Ee){if(Ae){let we=Je(le);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}Xe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Ce,B,le)}else t.texImage2D(i.TEXTURE_2D,0,he,Ce,B,le);U(T)&&T.mipmapsAutoUpdate===!0&&I(ve),Me.__version=pe.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function It(L,T,J){if(T.image.length!==6)return;let ve=Ct(L,T),de=T.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+J);let pe=n.get(de);if(de.version!==pe.__version||ve===!0){t.activeTexture(i.TEXTURE0+J);let Me=St.getPrimaries(St.workingColorSpace),ae=T.colorSpace===Ii?null:St.getPrimaries(T.colorSpace),le=T.colorSpace===Ii||Me===ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,le);let Ce=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,he=[];for(let Oe=0;Oe<6;Oe++)!Ce&&!B?he[Oe]=P(T.image[Oe],!0,r.maxCubemapSize):he[Oe]=B?T.image[Oe].image:T.image[Oe],he[Oe]=Ze(T,he[Oe]);let se=he[0],Re=o.convert(T.format,T.colorSpace),Ee=o.convert(T.type),Ae=N(T.internalFormat,Re,Ee,T.normalized,T.colorSpace),Xe=T.isVideoTexture!==!0,ut=pe.__version===void 0||ve===!0,we=de.dataReady,$e=D(T,se);Et(i.TEXTURE_CUBE_MAP,T);let dt;if(T.isDepthTexture){if(Ae=w(T.format===Pi,T.type),ut)if(Xe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,se.width,se.height);else for(let Oe=0;Oe<6;Oe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,se.width,se.height,0,Re,Ee,null)}else if(Ce){Xe&&ut&&t.texStorage2D(i.TEXTURE_CUBE_MAP,$e,Ae,se.width,se.height);for(let Oe=0;Oe<6;Oe++){dt=he[Oe].mipmaps;for(let Tt=0;Tt<dt.length;Tt++){let Ot=dt[Tt];T.format!==Kn?Re!==null?Xe?we&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Ot.width,Ot.height,Re,Ot.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Ot.width,Ot.height,0,Ot.data):Qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Ot.width,Ot.height,Re,Ee,Ot.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Ot.width,Ot.height,0,Re,Ee,Ot.data)}}}else{if(dt=T.mipmaps,Xe&&ut){dt.length>0&&$e++;let Oe=Je(he[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,$e,Ae,Oe.width,Oe.height)}for(let Oe=0;Oe<6;Oe++)if(B){Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,he[Oe].width,he[Oe].height,Re,Ee,he[Oe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,he[Oe].width,he[Oe].height,0,Re,Ee,he[Oe].data);for(let Tt=0;Tt<dt.length;Tt++){let _i=dt[Tt].image[Oe].image;Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,_i.width,_i.height,Re,Ee,_i.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,_i.width,_i.height,0,Re,Ee,_i.data)}}else{Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,Re,Ee,he[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,Re,Ee,he[Oe]);for(let Tt=0;Tt<dt.length;Tt++){let Ot=dt[Tt];Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,Re,Ee,Ot.image[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,Re,Ee,Ot.image[Oe])}}}U(T)&&T.mipmapsAutoUpdate===!0&&I(i.TEXTURE_CUBE_MAP),pe.__version=de.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Mt(L,T,J,ve,de,pe){let Me=o.convert(J.format,J.colorSpace),ae=o.convert(J.type),le=N(J.internalFormat,Me,ae,J.normalized,J.colorSpace),Ce=n.get(T),B=n.get(J);if(B.__renderTarget=T,!Ce.__hasExternalTextures){let he=Math.max(1,T.width>>pe),se=Math.max(1,T.height>>pe);de===i.TEXTURE_3D||de===i.TEXTURE_2D_ARRAY?t.texImage3D(de,pe,le,he,se,T.depth,0,Me,ae,null):t.texImage2D(de,pe,le,he,se,0,Me,ae,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,de,B.__webglTexture,0,Ut(T)):(de===i.TEXTURE_2D||de>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&de<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ve,de,B.__webglTexture,pe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(L,T,J){if(i.bindRenderbuffer(i.RENDERBUFFER,L),T.depthBuffer){let ve=T.depthTexture,de=ve&&ve.isDepthTexture?ve.type:null,pe=w(T.stencilBuffer,de),Me=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Le(T)?h.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):J?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,pe,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Me,i.RENDERBUFFER,L)}else{let ve=T.textures;for(let de=0;de<ve.length;de++){let pe=ve[de],Me=o.convert(pe.format,pe.colorSpace),ae=o.convert(pe.type),le=N(pe.internalFormat,Me,ae,pe.normalized,pe.colorSpace);Le(T)?h.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),le,T.width,T.height):J?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),le,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,le,T.width,T.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function De(L,T,J){let ve=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let de=n.get(T.depthTexture);de.__renderTarget=T;let pe=ve?T.depthTexture.image[0]:T.depthTexture.image;(!de.__webglTexture||pe.width!==T.width||pe.height!==T.height)&&(pe.width=T.width,pe.height=T.height,T.depthTexture.needsUpdate=!0),ve?Ue(T.depthTexture,0):Fe(T.depthTexture,0);let Me=de.__webglTexture,ae=Ut(T),le=ve?i.TEXTURE_CUBE_MAP_POSITIVE_X+J:i.TEXTURE_2D,Ce=T.depthTexture.format===Pi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(T.depthTexture.format===Ei)Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Ce,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Ce,le,Me,0);else if(T.depthTexture.format===Pi)Le(T)?h.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Ce,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Ce,le,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function qe(L){let T=n.get(L),J=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==L.depthTexture){let ve=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ve){let de=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ve.removeEventListener("dispose",de)};ve.addEventListener("dispose",de),T.__depthDisposeCallback=de}T.__boundDepthTexture=ve}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)if(J)for(let ve=0;ve<6;ve++)De(T.__webglFramebuffer[ve],L,ve);else L.texture.mipmaps.length>0?De(T.__webglFramebuffer[0],L,0):De(T.__webglFramebuffer,L,0);else if(J){T.__webglDepthbuffer=[];for(let ve=0;ve<6;ve++)if(t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[ve]),T.__webglDepthbuffer[ve]===void 0)T.__webglDepthbuffer[ve]=i.createRenderbuffer(),rn(T.__webglDepthbuffer[ve],L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer[ve];i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=i.createRenderbuffer(),rn(T.__webglDepthbuffer,L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function hn(L,T,J){let ve=n.get(L);T!==void 0&&Mt(ve.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),J!==void 0&&qe(L)}function sn(L){let T=L.texture,J=n.get(L),ve=n.get(T);L.addEventListener("dispose",Z),X(L);let de=L.textures,pe=L.isWebGLCubeRenderTarget===!0,Me=de.length>1;if(Me||(ve.__webglTexture===void 0&&(ve.__webglTexture=i.createTexture()),ve.__version=T.version,l.memory.textures++),pe){J.__webglFramebuffer=[];for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0){J.__webglFramebuffer[ae]=[];for(let le=0;le<T.mipmaps.length;le++)J.__webglFramebuffer[ae][le]=i.createFramebuffer()}else J.__webglFramebuffer[ae]=i.createFramebuffer()}else{if(T.mipmaps.length>0){J.__webglFramebuffer=[];for(let ae=0;ae<T.mipmaps.length;ae++)J.__webglFramebuffer[ae]=i.createFramebuffer()}else J.__webglFramebuffer=i.createFramebuffer();if(Me)for(let ae=0,le=de.length;ae<le;ae++){let Ce=n.get(de[ae]);Ce.__webglTexture===void 0&&(Ce.__webglTexture=i.createTexture(),l.memory.textures++)}if(L.samples>0&&Le(L)===!1){J.__webglMultisampledFramebuffer=i.createFramebuffer(),J.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let ae=0;ae<de.length;ae++){let le=de[ae];J.__webglColorRenderbuffer[ae]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,J.__webglColorRenderbuffer[ae]);let Ce=o.convert(le.format,le.colorSpace),B=o.convert(le.type),he=N(le.internalFormat,Ce,B,le.normalized,le.colorSpace,L.isXRRenderTarget===!0),se=Ut(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,se,he,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,J.__webglColorRenderbuffer[ae])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(J.__webglDepthRenderbuffer=i.createRenderbuffer(),rn(J.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(pe){t.bindTexture(i.TEXTURE_CUBE_MAP,ve.__webglTexture),Et(i.TEXTURE_CUBE_MAP,T);for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(J.__webglFramebuffer[ae][le],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,le);else Mt(J.__webglFramebuffer[ae],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0);U(T)?I(i.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let ae=0,le=de.length;ae<le;ae++){let Ce=de[ae],B=n.get(Ce),he=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(he=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(he,B.__webglTexture),Et(he,Ce),Mt(J.__webglFramebuffer,L,Ce,i.COLOR_ATTACHMENT0+ae,he,0),U(Ce)&&I(he)}t.unbindTexture()}else{let ae=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ae=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,ve.__webglTexture),Et(ae,T),T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(J.__webglFramebuffer[le],L,T,i.COLOR_ATTACHMENT0,ae,le);else Mt(J.__webglFramebuffer,L,T,i.COLOR_ATTACHMENT0,ae,0);U(T)?I(ae):T.mipmaps.length>0&&i.texParameteri(ae,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&qe(L)}function W(L){let T=L.textures;for(let J=0,ve=T.length;J<ve;J++){let de=T[J];if(U(de)&&de.mipmapsAutoUpdate===!0){let pe=O(L),Me=n.get(de).__webglTexture;t.bindTexture(pe,Me),I(pe),t.unbindTexture()}}}let yn=[];function Rt(L){if(L.samples>0){if(Le(L)===!1){let T=L.textures,J=L.width,ve=L.height,de=i.COLOR_BUFFER_BIT,pe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=n.get(L),ae=T.length>1;if(ae)for(let Ce=0;Ce<T.length;Ce++)t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let Ce=0;Ce<T.length;Ce++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(de|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(de|=i.STENCIL_BUFFER_BIT)),ae){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Ce]);let B=n.get(T[Ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,J,ve,0,0,J,ve,de,i.NEAREST),f===!0&&(yn.length=0,yn.push(i.COLOR_ATTACHMENT0+Ce),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&yn.push(pe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,yn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ae)for(let Ce=0;Ce<T.length;Ce++){t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Ce]);let B=n.get(T[Ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&f){let T=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[T])}}}function Ut(L){return Math.min(r.maxSamples,L.samples)}function Le(L){let T=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function qt(L){let T=l.render.frame;m.get(L)!==T&&(m.set(L,T),L.update())}function Ze(L,T){let J=L.colorSpace,ve=L.format,de=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||J!==ws&&J!==Ii&&(St.getTransfer(J)===Pt?(ve!==Kn||de!==Tn)&&Qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",J)),T}function Je(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(d.width=L.naturalWidth||L.width,d.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(d.width=L.displayWidth,d.height=L.displayHeight):(d.width=L.width,d.height=L.height),d}this.allocateTextureUnit=it,this.resetTextureUnits=H,this.getTextureUnits=ge,this.setTextureUnits=We,this.setTexture2D=Fe,this.setTexture2DArray=Pe,this.setTexture3D=je,this.setTextureCube=Ue,this.rebindTextures=hn,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=Rt,this.setupDepthRenderbuffer=qe,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=Le,this.dispose=ie}function Ib(i,e){function t(n,r=Ii){let o,l=St.getTransfer(r);if(n===Tn)return i.UNSIGNED_BYTE;if(n===jo)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Zo)return i.UNSIGNED_SHORT_5_5_5_1;if(n===eh)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===th)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Kc)return i.BYTE;if(n===Qc)return i.SHORT;if(n===Jr)return i.UNSIGNED_SHORT;if(n===Yo)return i.INT;if(n===Zn)return i.UNSIGNED_INT;if(n===Vn)return i.FLOAT;if(n===Jn)return i.HALF_FLOAT;if(n===nh)return i.ALPHA;if(n===ih)return i.RGB;if(n===Kn)return i.RGBA;if(n===Ei)return i.DEPTH_COMPONENT;if(n===Pi)return i.DEPTH_STENCIL;if(n===Jo)return i.RED;if(n===Ko)return i.RED_INTEGER;if(n===Zi)return i.RG;if(n===Qo)return i.RG_INTEGER;if(n===el)return i.RGBA_INTEGER;if(n===ea||n===ta||n===na||n===ia)if(l===Pt)if(o=e.get("WEBGL_compressed_texture_s3tc_srgb"),o!==null){if(n===ea)return o.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ta)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===na)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ia)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(o=e.get("WEBGL_compressed_texture_s3tc"),o!==null){if(n===ea)return o.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ta)return o.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===na)return o.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ia)return o.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===tl||n===nl||n===il||n===rl)if(o=e.get("WEBGL_compressed_texture_pvrtc"),o!==null){if(n===tl)return o.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===nl)return o.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===il)return o.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===rl)return o.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===sl||n===al||n===ol||n===ll||n===cl||n===ra||n===hl)if(o=e.get("WEBGL_compressed_texture_etc"),o!==null){if(n===sl||n===al)return l===Pt?o.COMPRESSED_SRGB8_ETC2:o.COMPRESSED_RGB8_ETC2;if(n===ol)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:o.COMPRESSED_RGBA8_ETC2_EAC;if(n===ll)return o.COMPRESSED_R11_EAC;if(n===cl)return o.COMPRESSED_SIGNED_R11_EAC;if(n===ra)return o.COMPRESSED_RG11_EAC;if(n===hl)return o.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ul||n===dl||n===fl||n===pl||n===ml||n===gl||n===_l||n===vl||n===yl||n===xl||n===Sl||n===Ml||n===bl||n===wl)if(o=e.get("WEBGL_compressed_texture_astc"),o!==null){if(n===ul)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:o.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===dl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:o.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===fl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:o.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===pl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:o.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ml)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:o.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===gl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:o.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===_l)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:o.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===vl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:o.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===yl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:o.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===xl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:o.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Sl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:o.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Ml)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:o.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===bl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:o.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===wl)return l===Pt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:o.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===El||n===Tl||n===Al)if(o=e.get("EXT_texture_compression_bptc"),o!==null){if(n===El)return l===Pt?o.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:o.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Tl)return o.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Al)return o.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Cl||n===Rl||n===sa||n===Pl)if(o=e.get("EXT_texture_compression_rgtc"),o!==null){if(n===Cl)return o.COMPRESSED_RED_RGTC1_EXT;if(n===Rl)return o.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===sa)return o.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Pl)return o.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===mr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var Db=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Lb=`
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

}`,Eh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ks(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new di({vertexShader:Db,fragmentShader:Lb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new zt(new Hi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Th=class extends jn{constructor(e,t){super();let n=this,r=null,o=1,l=null,h="local-floor",f=1,d=null,m=null,y=null,g=null,x=null,M=null,R=typeof XRWebGLBinding<"u",S=new Eh,_={},P=t.getContextAttributes(),U=null,I=null,O=[],N=[],w=new et,D=null,X=null,k=new _n;k.viewport=new Gt;let Y=new _n;Y.viewport=new Gt;let Z=[k,Y],ee=new Ho,z=null,ie=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Hr,O[ue]=Fe),Fe.getTargetRaySpace()},this.getControllerGrip=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Hr,O[ue]=Fe),Fe.getGripSpace()},this.getHand=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new Hr,O[ue]=Fe),Fe.getHandSpace()};function G(ue){let Fe=N.indexOf(ue.inputSource);if(Fe===-1)return;let Pe=O[Fe];Pe!==void 0&&(Pe.update(ue.inputSource,ue.frame,d||l),Pe.dispatchEvent({type:ue.type,data:ue.inputSource}))}function ne(){r.removeEventListener("select",G),r.removeEventListener("selectstart",G),r.removeEventListener("selectend",G),r.removeEventListener("squeeze",G),r.removeEventListener("squeezestart",G),r.removeEventListener("squeezeend",G),r.removeEventListener("end",ne),r.removeEventListener("inputsourceschange",Se);for(let ue=0;ue<O.length;ue++){let Fe=N[ue];Fe!==null&&(N[ue]=null,O[ue].disconnect(Fe))}z=null,ie=null,S.reset();for(let ue in _)delete _[ue];if(e.setRenderTarget(U),x=null,g=null,y=null,r=null,I=null,it.stop(),n.isPresenting=!1,e.setPixelRatio(D),e.setSize(w.width,w.height,!1),X!==null){let ue=X.camera;ue.fov=X.fov,ue.zoom=X.zoom,ue.updateProjectionMatrix(),X=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ue){o=ue,n.isPresenting===!0&&Qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ue){h=ue,n.isPresenting===!0&&Qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return d||l},this.setReferenceSpace=function(ue){d=ue},this.getBaseLayer=function(){return g!==null?g:x},this.getBinding=function(){return y===null&&R&&(y=new XRWebGLBinding(r,t)),y},this.getFrame=function(){return M},this.getSession=function(){return r},this.setSession=async function(ue){if(r=ue,r!==null){if(U=e.getRenderTarget(),r.addEventListener("select",G),r.addEventListener("selectstart",G),r.addEventListener("selectend",G),r.addEventListener("squeeze",G),r.addEventListener("squeezestart",G),r.addEventListener("squeezeend",G),r.addEventListener("end",ne),r.addEventListener("inputsourceschange",Se),P.xrCompatible!==!0&&await t.makeXRCompatible(),D=e.getPixelRatio(),e.getSize(w),R&&"createProjectionLayer"in XRWebGLBinding.prototype){let Pe=null,je=null,Ue=null;P.depth&&(Ue=P.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Pe=P.stencil?Pi:Ei,je=P.stencil?mr:Zn);let ot={colorFormat:t.RGBA8,depthFormat:Ue,scaleFactor:o};y=this.getBinding(),g=y.createProjectionLayer(ot),r.updateRenderState({layers:[g]}),e.setPixelRatio(1),e.setSize(g.textureWidth,g.textureHeight,!1),I=new Ln(g.textureWidth,g.textureHeight,{format:Kn,type:Tn,depthTexture:new Ai(g.textureWidth,g.textureHeight,je,void 0,void 0,void 0,void 0,void 0,void 0,Pe),stencilBuffer:P.stencil,colorSpace:e.outputColorSpace,samples:P.antialias?4:0,resolveDepthBuffer:g.ignoreDepthValues===!1,resolveStencilBuffer:g.ignoreDepthValues===!1,storeMultisampledDepthBuffer:g.ignoreDepthValues===!1,storeMultisampledStencilBuffer:g.ignoreDepthValues===!1})}else{let Pe={antialias:P.antialias,alpha:!0,depth:P.depth,stencil:P.stencil,framebufferScaleFactor:o};x=new XRWebGLLayer(r,t,Pe),r.updateRenderState({baseLayer:x}),e.setPixelRatio(1),e.setSize(x.framebufferWidth,x.framebufferHeight,!1),I=new Ln(x.framebufferWidth,x.framebufferHeight,{format:Kn,type:Tn,colorSpace:e.outputColorSpace,stencilBuffer:P.stencil,resolveDepthBuffer:x.ignoreDepthValues===!1,resolveStencilBuffer:x.ignoreDepthValues===!1,storeMultisampledDepthBuffer:x.ignoreDepthValues===!1,storeMultisampledStencilBuffer:x.ignoreDepthValues===!1})}I.isXRRenderTarget=!0,this.setFoveation(f),d=null,l=await r.requestReferenceSpace(h),it.setContext(r),it.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return S.getDepthTexture()};function Se(ue){for(let Fe=0;Fe<ue.removed.length;Fe++){let Pe=ue.removed[Fe],je=N.indexOf(Pe);je>=0&&(N[je]=null,O[je].disconnect(Pe))}for(let Fe=0;Fe<ue.added.length;Fe++){let Pe=ue.added[Fe],je=N.indexOf(Pe);if(je===-1){for(let ot=0;ot<O.length;ot++)if(ot>=N.length){N.push(Pe),je=ot;break}else if(N[ot]===null){N[ot]=Pe,je=ot;break}if(je===-1)break}let Ue=O[je];Ue&&Ue.connect(Pe)}}function re(ue,Fe){Fe===null?ue.matrixWorld.copy(ue.matrix):ue.matrixWorld.multiplyMatrices(Fe.matrixWorld,ue.matrix),ue.matrixWorldInverse.copy(ue.matrixWorld).invert()}this.updateCamera=function(ue){if(r===null)return;let Fe=ue.near,Pe=ue.far;S.texture!==null&&(S.depthNear>0&&(Fe=S.depthNear),S.depthFar>0&&(Pe=S.depthFar)),ee.near=Y.near=k.near=Fe,ee.far=Y.far=k.far=Pe,(z!==ee.near||ie!==ee.far)&&(r.updateRenderState({depthNear:ee.near,depthFar:ee.far}),z=ee.near,ie=ee.far),ee.layers.mask=ue.layers.mask|6,k.layers.mask=ee.layers.mask&-5,Y.layers.mask=ee.layers.mask&-3;let je=ue.parent,Ue=ee.cameras;re(ee,je);for(let ot=0;ot<Ue.length;ot++)re(Ue[ot],je);ee.projectionMatrix.copy(k.projectionMatrix),ee.projectionMatrixInverse.copy(k.projectionMatrixInverse),X===null&&ue.isPerspectiveCamera&&(X={camera:ue,fov:ue.fov,zoom:ue.zoom}),H(ue,ee,je)};function H(ue,Fe,Pe){Pe===null?ue.matrix.copy(Fe.matrixWorld):(ue.matrix.copy(Pe.matrixWorld),ue.matrix.invert(),ue.matrix.multiply(Fe.matrixWorld)),ue.matrix.decompose(ue.position,ue.quaternion,ue.scale),ue.updateMatrixWorld(!0),ue.projectionMatrix.copy(Fe.projectionMatrix),ue.projectionMatrixInverse.copy(Fe.projectionMatrixInverse),ue.isPerspectiveCamera&&(ue.fov=zr*2*Math.atan(1/ue.projectionMatrix.elements[5]),ue.zoom=1)}this.getCamera=function(){return ee},this.getFoveation=function(){if(!(g===null&&x===null))return f},this.setFoveation=function(ue){f=ue,g!==null&&(g.fixedFoveation=ue),x!==null&&x.fixedFoveation!==void 0&&(x.fixedFoveation=ue)},this.hasDepthSensing=function(){return S.texture!==null},this.getDepthSensingMesh=function(){return S.getMesh(ee)},this.getCameraTexture=function(ue){return _[ue]};let ge=null;function We(ue,Fe){if(m=Fe.getViewerPose(d||l),M=Fe,m!==null){let Pe=m.views;x!==null&&(e.setRenderTargetFramebuffer(I,x.framebuffer),e.setRenderTarget(I));let je=!1;Pe.length!==ee.cameras.length&&(ee.cameras.length=0,je=!0);for(let Ke=0;Ke<Pe.length;Ke++){let Et=Pe[Ke],Ct=null;if(x!==null)Ct=x.getViewport(Et);else{let Ht=y.getViewSubImage(g,Et);Ct=Ht.viewport,Ke===0&&(e.setRenderTargetTextures(I,Ht.colorTexture,Ht.depthStencilTexture),e.setRenderTarget(I))}let mt=Z[Ke];mt===void 0&&(mt=new _n,mt.layers.enable(Ke),mt.viewport=new Gt,Z[Ke]=mt),mt.matrix.fromArray(Et.transform.matrix),mt.matrix.decompose(mt.position,mt.quaternion,mt.scale),mt.projectionMatrix.fromArray(Et.projectionMatrix),mt.projectionMatrixInverse.copy(mt.projectionMatrix).invert(),mt.viewport.set(Ct.x,Ct.y,Ct.width,Ct.height),Ke===0&&(ee.matrix.copy(mt.matrix),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale)),je===!0&&ee.cameras.push(mt)}let Ue=r.enabledFeatures;if(Ue&&Ue.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&R){y=n.getBinding();let Ke=y.getDepthInformation(Pe[0]);Ke&&Ke.isValid&&Ke.texture&&S.init(Ke,r.renderState)}if(Ue&&Ue.includes("camera-access")&&R){e.state.unbindTexture(),y=n.getBinding();for(let Ke=0;Ke<Pe.length;Ke++){let Et=Pe[Ke].camera;if(Et){let Ct=_[Et];Ct||(Ct=new ks,_[Et]=Ct);let mt=y.getCameraImage(Et);Ct.sourceTexture=mt}}}}for(let Pe=0;Pe<O.length;Pe++){let je=N[Pe],Ue=O[Pe];je!==null&&Ue!==void 0&&Ue.update(je,Fe,d||l)}ge&&ge(ue,Fe),Fe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Fe}),M=null}let it=new mf;it.setAnimationLoop(We),this.setAnimationLoop=function(ue){ge=ue},this.dispose=function(){}}},Fb=new Lt,Ef=new ct;Ef.set(-1,0,0,0,1,0,0,0,1);function Nb(i,e){function t(S,_){S.matrixAutoUpdate===!0&&S.updateMatrix(),_.value.copy(S.matrix)}function n(S,_){_.color.getRGB(S.fogColor.value,fh(i)),_.isFog?(S.fogNear.value=_.near,S.fogFar.value=_.far):_.isFogExp2&&(S.fogDensity.value=_.density)}function r(S,_,P,U,I){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?o(S,_):_.isMeshLambertMaterial?(o(S,_),_.envMap&&(S.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(o(S,_),y(S,_)):_.isMeshPhongMaterial?(o(S,_),m(S,_),_.envMap&&(S.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(o(S,_),g(S,_),_.isMeshPhysicalMaterial&&x(S,_,I)):_.isMeshMatcapMaterial?(o(S,_),M(S,_)):_.isMeshDepthMaterial?o(S,_):_.isMeshDistanceMaterial?(o(S,_),R(S,_)):_.isMeshNormalMaterial?o(S,_):_.isLineBasicMaterial?(l(S,_),_.isLineDashedMaterial&&h(S,_)):_.isPointsMaterial?f(S,_,P,U):_.isSpriteMaterial?d(S,_):_.isShadowMaterial?(S.color.value.copy(_.color),S.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function o(S,_){S.opacity.value=_.opacity,_.color&&S.diffuse.value.copy(_.color),_.emissive&&S.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(S.map.value=_.map,t(_.map,S.mapTransform)),_.alphaMap&&(S.alphaMap.value=_.alphaMap,t(_.alphaMap,S.alphaMapTransform)),_.bumpMap&&(S.bumpMap.value=_.bumpMap,t(_.bumpMap,S.bumpMapTransform),S.bumpScale.value=_.bumpScale,_.side===dn&&(S.bumpScale.value*=-1)),_.normalMap&&(S.normalMap.value=_.normalMap,t(_.normalMap,S.normalMapTransform),S.normalScale.value.copy(_.normalScale),_.side===dn&&S.normalScale.value.negate()),_.displacementMap&&(S.displacementMap.value=_.displacementMap,t(_.displacementMap,S.displacementMapTransform),S.displacementScale.value=_.displacementScale,S.displacementBias.value=_.displacementBias),_.emissiveMap&&(S.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,S.emissiveMapTransform)),_.specularMap&&(S.specularMap.value=_.specularMap,t(_.specularMap,S.specularMapTransform)),_.alphaTest>0&&(S.alphaTest.value=_.alphaTest);let P=e.get(_),U=P.envMap,I=P.envMapRotation;U&&(S.envMap.value=U,S.envMapRotation.value.setFromMatrix4(Fb.makeRotationFromEuler(I)).transpose(),U.isCubeTexture&&U.isRenderTargetTexture===!1&&S.envMapRotation.value.premultiply(Ef),S.reflectivity.value=_.reflectivity,S.ior.value=_.ior,S.refractionRatio.value=_.refractionRatio),_.lightMap&&(S.lightMap.value=_.lightMap,S.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,S.lightMapTransform)),_.aoMap&&(S.aoMap.value=_.aoMap,S.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,S.aoMapTransform))}function l(S,_){S.diffuse.value.copy(_.color),S.opacity.value=_.opacity,_.map&&(S.map.value=_.map,t(_.map,S.mapTransform))}function h(S,_){S.dashSize.value=_.dashSize,S.totalSize.value=_.dashSize+_.gapSize,S.scale.value=_.scale}function f(S,_,P,U){S.diffuse.value.copy(_.color),S.opacity.value=_.opacity,S.size.value=_.size*P,S.scale.value=U*.5,_.map&&(S.map.value=_.map,t(_.map,S.uvTransform)),_.alphaMap&&(S.alphaMap.value=_.alphaMap,t(_.alphaMap,S.alphaMapTransform)),_.alphaTest>0&&(S.alphaTest.value=_.alphaTest)}function d(S,_){S.diffuse.value.copy(_.color),S.opacity.value=_.opacity,S.rotation.value=_.rotation,_.map&&(S.map.value=_.map,t(_.map,S.mapTransform)),_.alphaMap&&(S.alphaMap.value=_.alphaMap,t(_.alphaMap,S.alphaMapTransform)),_.alphaTest>0&&(S.alphaTest.value=_.alphaTest)}function m(S,_){S.specular.value.copy(_.specular),S.shininess.value=Math.max(_.shininess,1e-4)}function y(S,_){_.gradientMap&&(S.gradientMap.value=_.gradientMap)}function g(S,_){S.metalness.value=_.metalness,_.metalnessMap&&(S.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,S.metalnessMapTransform)),S.roughness.value=_.roughness,_.roughnessMap&&(S.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,S.roughnessMapTransform)),_.envMap&&(S.envMapIntensity.value=_.envMapIntensity)}function x(S,_,P){S.ior.value=_.ior,_.diffuseRoughness>0&&(S.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(S.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,S.diffuseRoughnessMapTransform))),_.sheen>0&&(S.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),S.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(S.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,S.sheenColorMapTransform)),_.sheenRoughnessMap&&(S.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,S.sheenRoughnessMapTransform))),_.clearcoat>0&&(S.clearcoat.value=_.clearcoat,S.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(S.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,S.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(S.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,S.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(S.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,S.clearcoatNormalMapTransform),S.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===dn&&S.clearcoatNormalScale.value.negate())),_.dispersion>0&&(S.dispersion.value=_.dispersion),_.retroreflectivity>0&&(S.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(S.iridescence.value=_.iridescence,S.iridescenceIOR.value=_.iridescenceIOR,S.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,S.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(S.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,S.iridescenceMapTransform)),_.iridescenceThicknessMap&&(S.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,S.iridescenceThicknessMapTransform))),_.transmission>0&&(S.transmission.value=_.transmission,S.transmissionSamplerMap.value=P.texture,S.transmissionSamplerSize.value.set(P.width,P.height),_.transmissionMap&&(S.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,S.transmissionMapTransform)),S.thickness.value=_.thickness,_.thicknessMap&&(S.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,S.thicknessMapTransform)),S.attenuationDistance.value=_.attenuationDistance,S.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(S.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(S.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,S.anisotropyMapTransform))),S.specularIntensity.value=_.specularIntensity,S.specularColor.value.copy(_.specularColor),_.specularColorMap&&(S.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,S.specularColorMapTransform)),_.specularIntensityMap&&(S.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,S.specularIntensityMapTransform))}function M(S,_){_.matcap&&(S.matcap.value=_.matcap)}function R(S,_){let P=e.get(_).light;S.referencePosition.value.setFromMatrixPosition(P.matrixWorld),S.nearDistance.value=P.shadow.camera.near,S.farDistance.value=P.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function Ub(i,e,t,n){let r={},o={};function l(P,U){let I=U.program;n.uniformBlockBinding(P,I,r[P.id])}function h(P,U){let I=r[P.id];I===void 0&&(M(P),I=f(P),r[P.id]=I,P.addEventListener("dispose",S));let O=U.program;n.updateUBOMapping(P,O);let N=e.render.frame;o[P.id]!==N&&(d(P),o[P.id]=N)}function f(P){let U=i.createBuffer(),I=P.__size,O=P.usage;return i.bindBuffer(i.UNIFORM_BUFFER,U),i.bufferData(i.UNIFORM_BUFFER,I,O),i.bindBuffer(i.UNIFORM_BUFFER,null),U}function d(P){let U=r[P.id],I=P.uniforms,O=P.__cache;i.bindBuffer(i.UNIFORM_BUFFER,U);for(let N=0,w=I.length;N<w;N++){let D=I[N];if(Array.isArray(D))for(let X=0,k=D.length;X<k;X++)m(D[X],N,X,O);else m(D,N,0,O)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(P,U,I,O){if(g(P,U,I,O)===!0){let N=P.__offset,w=P.value;if(Array.isArray(w)){let D=0;for(let X=0;X<w.length;X++){let k=w[X],Y=R(k,!0);y(k,P.__data,D),D+=Y.storage/Float32Array.BYTES_PER_ELEMENT}}else y(w,P.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,N,P.__data)}}function y(P,U,I){typeof P=="number"||typeof P=="boolean"?U[I]=P:P.isMatrix3?(U[I]=P.elements[0],U[I+1]=P.elements[1],U[I+2]=P.elements[2],U[I+3]=0,U[I+4]=P.elements[3],U[I+5]=P.elements[4],U[I+6]=P.elements[5],U[I+7]=0,U[I+8]=P.elements[6],U[I+9]=P.elements[7],U[I+10]=P.elements[8],U[I+11]=0):ArrayBuffer.isView(P)?U.set(P.subarray(0,U.length-I),I):P.toArray(U,I)}function g(P,U,I,O){let N=P.value,w=U+"_"+I;if(Array.isArray(N)){O[w]===void 0&&(O[w]=[]);let D=O[w],X=!1;for(let k=0;k<N.length;k++)x(N[k],D,k)===!0&&(X=!0);return X}return x(N,O,w)}function x(P,U,I){if(U[I]===void 0)return typeof P=="number"||typeof P=="boolean"?U[I]=P:ArrayBuffer.isView(P)?U[I]=P.slice():U[I]=P.clone(),!0;{let O=U[I];if(typeof P=="number"||typeof P=="boolean"){if(O!==P)return U[I]=P,!0}else{if(ArrayBuffer.isView(P))return!0;if(O.equals(P)===!1)return O.copy(P),!0}}return!1}function M(P){let U=P.uniforms,I=0,O=16;for(let w=0,D=U.length;w<D;w++){let X=Array.isArray(U[w])?U[w]:[U[w]];for(let k=0,Y=X.length;k<Y;k++){let Z=X[k],ee=Array.isArray(Z.value)?Z.value:[Z.value],z=Array.isArray(U[w])||Array.isArray(Z.value),ie=I;for(let ne=0,Se=ee.length;ne<Se;ne++){let re=ee[ne],H=R(re,z),ge=I%O,We=ge%H.boundary,it=ge+We;I+=We,it!==0&&O-it<H.storage&&(I+=O-it),ne===0&&(ie=I),I+=H.storage}let G=Z.type==="int"?Int32Array:Z.type==="uint"?Uint32Array:Float32Array;Z.__data=new G((I-ie)/Float32Array.BYTES_PER_ELEMENT),Z.__offset=ie}}let N=I%O;return N>0&&(I+=O-N),P.__size=I,P.__cache={},this}function R(P,U){let I={boundary:0,storage:0};return typeof P=="number"||typeof P=="boolean"?(I.boundary=4,I.storage=4):P.isVector2?(I.boundary=8,I.storage=8):P.isVector3||P.isColor?(I.boundary=16,I.storage=12):P.isVector4?(I.boundary=16,I.storage=16):P.isMatrix3?(I.boundary=16,I.storage=48):P.isMatrix4?(I.boundary=16,I.storage=64):P.isTexture?Qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(P)?(I.boundary=16,I.storage=P.byteLength):Qe("WebGLRenderer: Unsupported uniform value type.",P),U===!0&&(I.boundary=16,I.storage=Math.ceil(I.storage/16)*16),I}function S(P){let U=P.target;U.removeEventListener("dispose",S),i.deleteBuffer(r[U.id]),delete r[U.id],delete o[U.id]}function _(){for(let P in r)i.deleteBuffer(r[P]);r={},o={}}return{bind:l,update:h,dispose:_}}var Ob=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),mi=null;function Bb(){return mi===null&&(mi=new Ds(Ob,16,16,Zi,Jn),mi.name="DFG_LUT",mi.minFilter=Mn,mi.magFilter=Mn,mi.wrapS=oi,mi.wrapT=oi,mi.generateMipmaps=!1,mi.needsUpdate=!0),mi}var Ll=class{constructor(e={}){let{canvas:t=Od(),context:n=null,depth:r=!0,stencil:o=!1,alpha:l=!1,antialias:h=!1,premultipliedAlpha:f=!0,preserveDrawingBuffer:d=!1,powerPreference:m="default",failIfMajorPerformanceCaveat:y=!1,reversedDepthBuffer:g=!1,outputBufferType:x=Tn}=e;this.isWebGLRenderer=!0;let M;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");M=n.getContextAttributes().alpha}else M=l;let R=x,S=new Set([el,Qo,Ko]),_=new Set([Tn,Zn,Jr,mr,jo,Zo]),P=new Uint32Array(4),U=new Int32Array(4),I={textures:[],min:[],max:[],resolution:[]},O=null,N=null,w=[],D=[],X=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=pi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let k=this,Y=!1,Z=null,ee=null,z=null,ie=null;this._outputColorSpace=gn;let G=0,ne=0,Se=null,re=-1,H=null,ge=new Gt,We=new Gt,it=null,ue=new ht(0),Fe=0,Pe=t.width,je=t.height,Ue=1,ot=null,Vt=null,Ke=new Gt(0,0,Pe,je),Et=new Gt(0,0,Pe,je),Ct=!1,mt=new Vi,Ht=new Eo,pt=!1,It=!1,Mt=new Lt,rn=new j,De=new Gt,qe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},hn=!1;function sn(){return Se===null?Ue:1}let W=n;function yn(C,V){return t.getContext(C,V)}let Rt,Ut,Le,qt,Ze,Je,L,T,J,ve,de,pe,Me,ae,le,Ce,B,he,se,Re,Ee,Ae,Xe;try{let C={alpha:!0,depth:r,stencil:o,antialias:h,premultipliedAlpha:f,preserveDrawingBuffer:d,powerPreference:m,failIfMajorPerformanceCaveat:y};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",$e,!1),t.addEventListener("webglcontextrestored",dt,!1),t.addEventListener("webglcontextcreationerror",Oe,!1),W===null){let V="webgl2";if(W=yn(V,C),W===null)throw yn(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ut()}catch(C){throw t.removeEventListener("webglcontextlost",$e,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),nt("WebGLRenderer: "+C.message),C}function ut(){Rt=new jS(W),Rt.init(),Ee=new Ib(W,Rt),Ut=new BS(W,Rt,e,Ee),Le=new Rb(W,Rt),Ut.reversedDepthBuffer&&g&&Le.buffers.depth.setReversed(!0),ee=W.createFramebuffer(),z=W.createFramebuffer(),ie=W.createFramebuffer(),qt=new KS(W),Ze=new mb,Je=new Pb(W,Rt,Le,Ze,Ut,Ee,qt),L=new YS(k),T=new ey(W),Ae=new US(W,T),J=new ZS(W,T,qt,Ae),ve=new eM(W,J,T,Ae,qt),he=new QS(W,Ut,Je),le=new kS(Ze),de=new pb(k,L,Rt,Ut,Ae,le),pe=new Nb(k,Ze),Me=new _b,ae=new bb(Rt),B=new NS(k,L,Le,ve,M,f),Ce=new Cb(k,ve,Ut),Xe=new Ub(W,qt,Ut,Le),se=new OS(W,Rt,qt),Re=new JS(W,Rt,qt),qt.programs=de.programs,k.capabilities=Ut,k.extensions=Rt,k.properties=Ze,k.renderLists=Me,k.shadowMap=Ce,k.state=Le,k.info=qt}R!==Tn&&(X=new nM(R,t.width,t.height,h,r,o));let we=new Th(k,W);this.xr=we,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let C=Rt.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Rt.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Ue},this.setPixelRatio=function(C){C!==void 0&&(Ue=C,this.setSize(Pe,je,!1))},this.getSize=function(C){return C.set(Pe,je)},this.setSize=function(C,V,te=!0){if(we.isPresenting){Qe("WebGLRenderer: Can't change size while VR device is presenting.");return}Pe=C,je=V,t.width=Math.floor(C*Ue),t.height=Math.floor(V*Ue),te===!0&&(t.style.width=C+"px",t.style.height=V+"px"),X!==null&&X.setSize(t.width,t.height),this.setViewport(0,0,C,V)},this.getDrawingBufferSize=function(C){return C.set(Pe*Ue,je*Ue).floor()},this.setDrawingBufferSize=function(C,V,te){Pe=C,je=V,Ue=te,t.width=Math.floor(C*te),t.height=Math.floor(V*te),this.setViewport(0,0,C,V)},this.setEffects=function(C){if(R===Tn){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let V=0;V<C.length;V++)if(C[V].isOutputPass===!0){Qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}X.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(ge)},this.getViewport=function(C){return C.copy(Ke)},this.setViewport=function(C,V,te,K){C.isVector4?Ke.set(C.x,C.y,C.z,C.w):Ke.set(C,V,te,K),Le.viewport(ge.copy(Ke).multiplyScalar(sn()).round())},this.getScissor=function(C){return C.copy(Et)},this.setScissor=function(C,V,te,K){C.isVector4?Et.set(C.x,C.y,C.z,C.w):Et.set(C,V,te,K),Le.scissor(We.copy(Et).multiplyScalar(sn()).round())},this.getScissorTest=function(){return Ct},this.setScissorTest=function(C){Le.setScissorTest(Ct=C)},this.setOpaqueSort=function(C){ot=C},this.setTransparentSort=function(C){Vt=C},this.getClearColor=function(C){return C.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(C=!0,V=!0,te=!0){let K=0;if(C){let $=!1;if(Se!==null){let Ie=Se.texture.format;$=S.has(Ie)}if($){let Ie=Se.texture.type,ze=_.has(Ie),Te=B.getClearColor(),Ne=B.getClearAlpha(),Ge=Te.r,rt=Te.g,gt=Te.b;ze?(P[0]=Ge,P[1]=rt,P[2]=gt,P[3]=Ne,W.clearBufferuiv(W.COLOR,0,P)):(U[0]=Ge,U[1]=rt,U[2]=gt,U[3]=Ne,W.clearBufferiv(W.COLOR,0,U))}else K|=W.COLOR_BUFFER_BIT}V&&(K|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(K|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&W.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),Z=C},this.dispose=function(){t.removeEventListener("webglcontextlost",$e,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),B.dispose(),Me.dispose(),ae.dispose(),Je.dispose(),Ze.dispose(),L.dispose(),ve.dispose(),J.dispose(),Ae.dispose(),Xe.dispose(),de.dispose(),we.dispose(),we.removeEventListener("sessionstart",is),we.removeEventListener("sessionend",vi),un.stop()};function $e(C){C.preventDefault(),lh("WebGLRenderer: Context Lost."),Y=!0}function dt(){lh("WebGLRenderer: Context Restored."),Y=!1;let C=qt.autoReset,V=Ce.enabled,te=Ce.autoUpdate,K=Ce.needsUpdate,$=Ce.type;ut(),qt.autoReset=C,Ce.enabled=V,Ce.autoUpdate=te,Ce.needsUpdate=K,Ce.type=$}function Oe(C){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function Tt(C){let V=C.target;V.removeEventListener("dispose",Tt),Ot(V)}function Ot(C){_i(C),Ze.remove(C)}function _i(C){let V=Ze.get(C).programs;V!==void 0&&(V.forEach(function(te){de.releaseProgram(te)}),C.isShaderMaterial&&de.releaseShaderCache(C))}this.renderBufferDirect=function(C,V,te,K,$,Ie){V===null&&(V=qe);let ze=$.isMesh&&$.matrixWorld.determinantAffine()<0,Te=Gl(C,V,te,K,$);Le.setMaterial(K,ze);let Ne=te.index,Ge=1;if(K.wireframe===!0){if(Ne=J.getWireframeAttribute(te),Ne===void 0)return;Ge=2}let rt=te.drawRange,gt=te.attributes.position,Ve=rt.start*Ge,lt=(rt.start+rt.count)*Ge;Ie!==null&&(Ve=Math.max(Ve,Ie.start*Ge),lt=Math.min(lt,(Ie.start+Ie.count)*Ge)),Ne!==null?(Ve=Math.max(Ve,0),lt=Math.min(lt,Ne.count)):gt!=null&&(Ve=Math.max(Ve,0),lt=Math.min(lt,gt.count));let Wt=lt-Ve;if(Wt<0||Wt===1/0)return;Ae.setup($,K,Te,te,Ne);let ke,Dt=se;if(Ne!==null&&(ke=T.get(Ne),Dt=Re,Dt.setIndex(ke)),$.isMesh)K.wireframe===!0?(Le.setLineWidth(K.wireframeLinewidth*sn()),Dt.setMode(W.LINES)):Dt.setMode(W.TRIANGLES);else if($.isLine){let jt=K.linewidth;jt===void 0&&(jt=1),Le.setLineWidth(jt*sn()),$.isLineSegments?Dt.setMode(W.LINES):$.isLineLoop?Dt.setMode(W.LINE_LOOP):Dt.setMode(W.LINE_STRIP)}else $.isPoints?Dt.setMode(W.POINTS):$.isSprite&&Dt.setMode(W.TRIANGLES);if($.isBatchedMesh)if(Rt.get("WEBGL_multi_draw"))Dt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let jt=$._multiDrawStarts,He=$._multiDrawCounts,an=$._multiDrawCount,wt=Ne?T.get(Ne).bytesPerElement:1,ei=Ze.get(K).currentProgram.getUniforms();for(let on=0;on<an;on++)ei.setValue(W,"_gl_DrawID",on),Dt.render(jt[on]/wt,He[on])}else if($.isInstancedMesh)Dt.renderInstances(Ve,Wt,$.count);else if(te.isInstancedBufferGeometry){let jt=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,He=Math.min(te.instanceCount,jt);Dt.renderInstances(Ve,Wt,He)}else Dt.render(Ve,Wt)};function ye(C,V,te,K){Z!==null&&C.isNodeMaterial&&Z.setObject(K,C),pt===!0&&le.setState(C,te,!1),C.transparent===!0&&C.side===fi&&C.forceSinglePass===!1?(C.side=dn,C.needsUpdate=!0,Ki(C,V,K),C.side=ji,C.needsUpdate=!0,Ki(C,V,K),C.side=fi):Ki(C,V,K)}this.compile=function(C,V,te=null){te===null&&(te=C),Z!==null&&Z.renderStart(C,V,te),N=ae.get(te),N.init(V),D.push(N),te.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(N.pushLight($),$.castShadow&&N.pushShadow($))}),C!==te&&C.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(N.pushLight($),$.castShadow&&N.pushShadow($))}),N.setupLights(),Z!==null&&Z.updateLights(N.state.lightsArray),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),pt===!0&&le.setGlobalState(this.clippingPlanes,V),Z!==null&&Ce.render(N.state.shadowsArray,te,V);let K=new Set;return C.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Ie=$.material;if(Ie)if(Array.isArray(Ie))for(let ze=0;ze<Ie.length;ze++){let Te=Ie[ze];ye(Te,te,V,$),K.add(Te)}else ye(Ie,te,V,$),K.add(Ie)}),N=D.pop(),Z!==null&&Z.renderEnd(),K},this.compileAsync=function(C,V,te=null){let K=this.compile(C,V,te);return new Promise($=>{function Ie(){if(K.forEach(function(ze){let Ne=Ze.get(ze).currentProgram;(Ne===void 0||Ne.isReady())&&K.delete(ze)}),K.size===0){$(C);return}setTimeout(Ie,10)}Rt.get("KHR_parallel_shader_compile")!==null?Ie():setTimeout(Ie,10)})};let _e=null;function Qn(C){_e&&_e(C)}function is(){un.stop()}function vi(){un.start()}let un=new mf;un.setAnimationLoop(Qn),typeof self<"u"&&un.setContext(self),this.setAnimationLoop=function(C){_e=C,we.setAnimationLoop(C),C===null?un.stop():un.start()},we.addEventListener("sessionstart",is),we.addEventListener("sessionend",vi),this.render=function(C,V){if(V!==void 0&&V.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(Y===!0)return;Z!==null&&Z.renderStart(C,V);let te=we.enabled===!0&&we.isPresenting===!0,K=X!==null&&(Se===null||te)&&X.begin(k,Se);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),we.enabled===!0&&we.isPresenting===!0&&(X===null||X.isCompositing()===!1)&&(we.cameraAutoUpdate===!0&&we.updateCamera(V),V=we.getCamera()),C.isScene===!0&&C.onBeforeRender(k,C,V,Se),N=ae.get(C,D.length),N.init(V),N.state.textureUnits=Je.getTextureUnits(),D.push(N),Mt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Ht.setFromArrayCamera(V):mt.setFromProjectionMatrix(Mt,zn,V.reversedDepth),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),O=Me.get(C,w.length),O.init(),w.push(O),this.info.render.frame++,we.enabled===!0&&we.isPresenting===!0){let ze=k.xr.getDepthSensingMesh();ze!==null&&rs(ze,V,-1/0,k.sortObjects)}rs(C,V,0,k.sortObjects),O.finish(),Z!==null&&Z.updateLights(N.state.lightsArray),k.sortObjects===!0&&O.sort(ot,Vt),hn=we.enabled===!1||we.isPresenting===!1||we.hasDepthSensing()===!1,hn&&B.addToRenderList(O,C),this.info.autoReset===!0&&this.info.reset(),pt===!0&&le.beginShadows();let $=N.state.shadowsArray;if(Ce.render($,C,V),pt===!0&&le.endShadows(),(K&&X.hasRenderPass())===!1){let ze=O.opaque,Te=O.transmissive;if(N.setupLights(),V.isArrayCamera){let Ne=V.cameras;if(Te.length>0)for(let Ge=0,rt=Ne.length;Ge<rt;Ge++){let gt=Ne[Ge];Ji(ze,Te,C,gt)}hn&&B.render(C);for(let Ge=0,rt=Ne.length;Ge<rt;Ge++){let gt=Ne[Ge];Nn(O,C,gt,gt.viewport)}}else Te.length>0&&Ji(ze,Te,C,V),hn&&B.render(C),Nn(O,C,V)}Se!==null&&ne===0&&(Je.updateMultisampleRenderTarget(Se),Je.updateRenderTargetMipmap(Se)),K&&X.end(k),C.isScene===!0&&C.onAfterRender(k,C,V),Ae.resetDefaultState(),re=-1,H=null,D.pop(),D.length>0?(N=D[D.length-1],Je.setTextureUnits(N.state.textureUnits),pt===!0&&le.setGlobalState(k.clippingPlanes,N.state.camera)):N=null,w.pop(),w.length>0?O=w[w.length-1]:O=null,Z!==null&&Z.renderEnd()};function rs(C,V,te,K){if(C.visible===!1)return;if(C.layers.test(V.layers)){if(C.isGroup)te=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(V);else if(C.isLight)N.pushLight(C),C.castShadow&&N.pushShadow(C);else if(C.isSprite){let ze=V.isArrayCamera?Ht:mt;if(!C.frustumCulled||C.intersectsFrustum(ze)){K&&De.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Mt);let Te=ve.update(C),Ne=C.material;Ne.visible&&O.push(C,Te,Ne,te,De.z,null,V)}}else if(C.isMesh||C.isLine||C.isPoints){let ze=V.isArrayCamera?Ht:mt;if(!C.frustumCulled||C.intersectsFrustum(ze)){let Te=ve.update(C),Ne=C.material;if(K&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),De.copy(C.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),De.copy(Te.boundingSphere.center)),De.applyMatrix4(C.matrixWorld).applyMatrix4(Mt)),Array.isArray(Ne)){let Ge=Te.groups;for(let rt=0,gt=Ge.length;rt<gt;rt++){let Ve=Ge[rt],lt=Ne[Ve.materialIndex];lt&&lt.visible&&O.push(C,Te,lt,te,De.z,Ve,V)}}else Ne.visible&&O.push(C,Te,Ne,te,De.z,null,V)}}}let Ie=C.children;for(let ze=0,Te=Ie.length;ze<Te;ze++)rs(Ie[ze],V,te,K)}function Nn(C,V,te,K){let{opaque:$,transmissive:Ie,transparent:ze}=C;N.setupLightsView(te),pt===!0&&le.setGlobalState(k.clippingPlanes,te),K&&Le.viewport(ge.copy(K)),$.length>0&&_r($,V,te),Ie.length>0&&_r(Ie,V,te),ze.length>0&&_r(ze,V,te),Le.buffers.depth.setTest(!0),Le.buffers.depth.setMask(!0),Le.buffers.color.setMask(!0),Le.setPolygonOffset(!1)}function Ji(C,V,te,K){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(N.state.transmissionRenderTarget[K.id]===void 0){let Ve=Rt.has("EXT_color_buffer_half_float")||Rt.has("EXT_color_buffer_float");N.state.transmissionRenderTarget[K.id]=new Ln(1,1,{generateMipmaps:!0,type:Ve?Jn:Tn,minFilter:Ri,samples:Math.max(4,Ut.samples),stencilBuffer:o,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ie=N.state.transmissionRenderTarget[K.id],ze=K.viewport||ge;Ie.setSize(ze.z*k.transmissionResolutionScale,ze.w*k.transmissionResolutionScale);let Te=k.getRenderTarget(),Ne=k.getActiveCubeFace(),Ge=k.getActiveMipmapLevel();k.setRenderTarget(Ie),k.getClearColor(ue),Fe=k.getClearAlpha(),Fe<1&&k.setClearColor(16777215,.5),k.clear(),hn&&B.render(te);let rt=k.toneMapping;k.toneMapping=pi;let gt=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),N.setupLightsView(K),pt===!0&&le.setGlobalState(k.clippingPlanes,K),_r(C,te,K),Je.updateMultisampleRenderTarget(Ie),Je.updateRenderTargetMipmap(Ie),Rt.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let lt=0,Wt=V.length;lt<Wt;lt++){let ke=V[lt],{object:Dt,geometry:jt,material:He,group:an}=ke;if(He.side===fi&&Dt.layers.test(K.layers)){let wt=He.side;He.side=dn,He.needsUpdate=!0,fa(Dt,te,K,jt,He,an),He.side=wt,He.needsUpdate=!0,Ve=!0}}Ve===!0&&(Je.updateMultisampleRenderTarget(Ie),Je.updateRenderTargetMipmap(Ie))}k.setRenderTarget(Te,Ne,Ge),k.setClearColor(ue,Fe),gt!==void 0&&(K.viewport=gt),k.toneMapping=rt}function _r(C,V,te){let K=V.isScene===!0?V.overrideMaterial:null;for(let $=0,Ie=C.length;$<Ie;$++){let ze=C[$],{object:Te,geometry:Ne,group:Ge}=ze,rt=ze.material;rt.allowOverride===!0&&K!==null&&(rt=K),Te.layers.test(te.layers)&&fa(Te,V,te,Ne,rt,Ge)}}function fa(C,V,te,K,$,Ie){Z!==null&&$.isNodeMaterial&&Z.setObject(C,$),C.onBeforeRender(k,V,te,K,$,Ie),C.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),$.onBeforeRender(k,V,te,K,C,Ie),$.transparent===!0&&$.side===fi&&$.forceSinglePass===!1?($.side=dn,$.needsUpdate=!0,k.renderBufferDirect(te,V,K,$,C,Ie),$.side=ji,$.needsUpdate=!0,k.renderBufferDirect(te,V,K,$,C,Ie),$.side=fi):k.renderBufferDirect(te,V,K,$,C,Ie),C.onAfterRender(k,V,te,K,$,Ie)}function Un(C){let V=0;for(let te of C)te.texture!==null&&V++;return V}function Ki(C,V,te){V.isScene!==!0&&(V=qe);let K=Ze.get(C),$=N.state.lights,Ie=N.state.shadowsArray,ze=$.state.version,Te=de.getParameters(C,$.state,Ie,V,te,N.state.lightProbeGridArray),Ne=de.getProgramCacheKey(Te),Ge=K.programs;K.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?V.environment:null,K.fog=V.fog;let rt=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;K.envMap=L.get(C.envMap||K.environment,rt),K.envMapRotation=K.environment!==null&&C.envMap===null?V.environmentRotation:C.envMapRotation,Ge===void 0&&(C.addEventListener("dispose",Tt),Ge=new Map,K.programs=Ge,K.programVariants=new Map);let gt=Ge.get(Ne);if(gt!==void 0){if(K.currentProgram===gt&&K.lightsStateVersion===ze)return yr(C,Te),gt}else Te.uniforms=de.getUniforms(C),Z!==null&&C.isNodeMaterial&&Z.build(C,te,Te),C.onBeforeCompile(Te,k),gt=de.acquireProgram(Te,Ne),Ge.set(Ne,gt),K.uniforms=Te.uniforms;let Ve=K.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Ve.clippingPlanes=le.uniform),yr(C,Te),K.needsLights=Hl(C),K.lightsStateVersion=ze,K.needsLights&&(Ve.ambientLightColor.value=$.state.ambient,Ve.lightProbe.value=$.state.probe,Ve.sunLights.value=$.state.sun,Ve.sunLightShadows.value=$.state.sunShadow,Ve.directionalLights.value=$.state.directional,Ve.directionalLightShadows.value=$.state.directionalShadow,Ve.spotLights.value=$.state.spot,Ve.spotLightShadows.value=$.state.spotShadow,Ve.rectAreaLights.value=$.state.rectArea,Ve.ltc_1.value=$.state.rectAreaLTC1,Ve.ltc_2.value=$.state.rectAreaLTC2,Ve.pointLights.value=$.state.point,Ve.pointLightShadows.value=$.state.pointShadow,Ve.hemisphereLights.value=$.state.hemi,Ve.sunShadowMatrix.value=$.state.sunShadowMatrix,Ve.sunShadowCascade.value=$.state.sunShadowCascade,Ve.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Ve.spotLightMatrix.value=$.state.spotLightMatrix,Ve.spotLightMap.value=$.state.spotLightMap,Ve.pointShadowMatrix.value=$.state.pointShadowMatrix),K.numLightProbeGrids=Un(N.state.lightProbeGridArray),K.currentProgram=gt,K.uniformsList=null,gt}function vr(C,V,te,K,$){let Ie=Ze.get(C),ze=Ie.currentProgram.id+","+K+","+$,Te=Ie.programVariants.get(ze);return Te===void 0?(Te=Ki(C,V,te),Ie.programVariants.set(ze,Te)):(Ie.currentProgram=Te,Ie.uniformsList=null,Ie.outputColorSpace=K,Ie.toneMapping=$),Te}function Qi(C){if(C.uniformsList===null){let V=C.currentProgram.getUniforms();C.uniformsList=Qr.seqWithValue(V.seq,C.uniforms)}return C.uniformsList}function yr(C,V){let te=Ze.get(C);te.outputColorSpace=V.outputColorSpace,te.batching=V.batching,te.batchingColor=V.batchingColor,te.instancing=V.instancing,te.instancingColor=V.instancingColor,te.instancingMorph=V.instancingMorph,te.skinning=V.skinning,te.morphTargets=V.morphTargets,te.morphNormals=V.morphNormals,te.morphColors=V.morphColors,te.morphTargetsCount=V.morphTargetsCount,te.numClippingPlanes=V.numClippingPlanes,te.numIntersection=V.numClipIntersection,te.vertexAlphas=V.vertexAlphas,te.vertexTangents=V.vertexTangents,te.toneMapping=V.toneMapping}function Gl(C,V,te,K,$){V.isScene!==!0&&(V=qe),Je.resetTextureUnits();let Ie=V.fog,ze=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?V.environment:null,Te=Se===null?k.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:St.workingColorSpace,Ne=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ge=L.get(K.envMap||ze,Ne),rt=K.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,gt=!!te.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),Ve=!!te.morphAttributes.position,lt=!!te.morphAttributes.normal,Wt=!!te.morphAttributes.color,ke=pi;K.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ke=k.toneMapping);let Dt=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,jt=Dt!==void 0?Dt.length:0,He=Ze.get(K),an=N.state.lights;if(pt===!0&&(It===!0||C!==H)){let Ft=C===H&&K.id===re;le.setState(K,C,Ft)}let wt=!1,ei=!1;K.version===He.__version?He.needsLights&&He.lightsStateVersion!==an.state.version||$.isBatchedMesh&&He.batching===!1||!$.isBatchedMesh&&He.batching===!0||$.isBatchedMesh&&He.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&He.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&He.instancing===!1||!$.isInstancedMesh&&He.instancing===!0||$.isSkinnedMesh&&He.skinning===!1||!$.isSkinnedMesh&&He.skinning===!0||$.isInstancedMesh&&He.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&He.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&He.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&He.instancingMorph===!1&&$.morphTexture!==null||He.envMap!==Ge||K.fog===!0&&He.fog!==Ie||He.numClippingPlanes!==void 0&&(He.numClippingPlanes!==le.numPlanes||He.numIntersection!==le.numIntersection)||He.vertexAlphas!==rt||He.vertexTangents!==gt||He.morphTargets!==Ve||He.morphNormals!==lt||He.morphColors!==Wt||He.morphTargetsCount!==jt||He.numLightProbeGrids!==Un(N.state.lightProbeGridArray)?wt=!0:(He.outputColorSpace!==Te||He.toneMapping!==ke)&&(ei=!0):(wt=!0,He.__version=K.version);let on=He.currentProgram;(wt===!0||ei===!0)&&(on=ei===!0?vr(K,V,$,Te,ke):Ki(K,V,$),Z&&K.isNodeMaterial&&Z.onUpdateProgram(K,on,He));let Di=!1,ti=!1,ni=!1,b=on.getUniforms(),ft=He.uniforms;if(Le.useProgram(on.program)&&(Di=!0,ti=!0,ni=!0),K.id!==re&&(re=K.id,ti=!0),Di||H!==C){Le.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),b.setValue(W,"projectionMatrix",C.projectionMatrix),b.setValue(W,"viewMatrix",C.matrixWorldInverse);let Bt=b.map.cameraPosition;Bt!==void 0&&Bt.setValue(W,rn.setFromMatrixPosition(C.matrixWorld)),Ut.logarithmicDepthBuffer&&b.setValue(W,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&b.setValue(W,"isOrthographic",C.isOrthographicCamera===!0),H!==C&&(H=C,ti=!0,ni=!0)}if(He.needsLights&&(an.state.sunShadowMap.length>0&&b.setValue(W,"sunShadowMap",an.state.sunShadowMap,Je),an.state.directionalShadowMap.length>0&&b.setValue(W,"directionalShadowMap",an.state.directionalShadowMap,Je),an.state.spotShadowMap.length>0&&b.setValue(W,"spotShadowMap",an.state.spotShadowMap,Je),an.state.pointShadowMap.length>0&&b.setValue(W,"pointShadowMap",an.state.pointShadowMap,Je)),$.isSkinnedMesh){b.setOptional(W,$,"bindMatrix"),b.setOptional(W,$,"bindMatrixInverse");let Ft=$.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),b.setValue(W,"boneTexture",Ft.boneTexture,Je))}$.isBatchedMesh&&(b.setOptional(W,$,"batchingTexture"),b.setValue(W,"batchingTexture",$._matricesTexture,Je),b.setOptional(W,$,"batchingIdTexture"),b.setValue(W,"batchingIdTexture",$._indirectTexture,Je),b.setOptional(W,$,"batchingColorTexture"),$._colorsTexture!==null&&b.setValue(W,"batchingColorTexture",$._colorsTexture,Je));let Cn=te.morphAttributes;if((Cn.position!==void 0||Cn.normal!==void 0||Cn.color!==void 0)&&he.update($,te,on),(ti||He.receiveShadow!==$.receiveShadow)&&(He.receiveShadow=$.receiveShadow,b.setValue(W,"receiveShadow",$.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&V.environment!==null&&(ft.envMapIntensity.value=V.environmentIntensity),ft.dfgLUT!==void 0&&(ft.dfgLUT.value=Bb()),ti){if(b.setValue(W,"toneMappingExposure",k.toneMappingExposure),He.needsLights&&Vl(ft,ni),Ie&&K.fog===!0&&pe.refreshFogUniforms(ft,Ie),pe.refreshMaterialUniforms(ft,K,Ue,je,N.state.transmissionRenderTarget[C.id]),He.needsLights&&He.numLightProbeGrids>0){let Ft=I,Bt=0;for(let Hn of N.state.lightProbeGridArray)Hn.texture!==null&&(Ft.textures[Bt]=Hn.texture,Ft.min[Bt]=Hn.boundingBox.min,Ft.max[Bt]=Hn.boundingBox.max,Ft.resolution[Bt]=Hn.resolution,Bt++);for(let Hn in Ft)Ft[Hn].length=Bt;ft.probesSH.value=Ft.textures,ft.probesMin.value=Ft.min,ft.probesMax.value=Ft.max,ft.probesResolution.value=Ft.resolution}Qr.upload(W,Qi(He),ft,Je)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Qr.upload(W,Qi(He),ft,Je),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&b.setValue(W,"center",$.center),b.setValue(W,"modelViewMatrix",$.modelViewMatrix),b.setValue(W,"normalMatrix",$.normalMatrix),b.setValue(W,"modelMatrix",$.matrixWorld),K.uniformsGroups!==void 0){let Ft=K.uniformsGroups;for(let Bt=0,Hn=Ft.length;Bt<Hn;Bt++){let pa=Ft[Bt];Xe.update(pa,on),Xe.bind(pa,on)}}return on}function Vl(C,V){C.ambientLightColor.needsUpdate=V,C.lightProbe.needsUpdate=V,C.sunLights.needsUpdate=V,C.sunLightShadows.needsUpdate=V,C.directionalLights.needsUpdate=V,C.directionalLightShadows.needsUpdate=V,C.pointLights.needsUpdate=V,C.pointLightShadows.needsUpdate=V,C.spotLights.needsUpdate=V,C.spotLightShadows.needsUpdate=V,C.rectAreaLights.needsUpdate=V,C.hemisphereLights.needsUpdate=V}function Hl(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return ne},this.getRenderTarget=function(){return Se},this.setRenderTargetTextures=function(C,V,te){let K=Ze.get(C);K.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Ze.get(C.texture).__webglTexture=V,Ze.get(C.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:te,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,V){let te=Ze.get(C);te.__webglFramebuffer=V,te.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(C,V=0,te=0){Se=C,G=V,ne=te;let K=null,$=!1,Ie=!1;if(C){let Te=Ze.get(C);if(Te.__useDefaultFramebuffer!==void 0){Le.bindFramebuffer(W.FRAMEBUFFER,Te.__webglFramebuffer),ge.copy(C.viewport),We.copy(C.scissor),it=C.scissorTest,Le.viewport(ge),Le.scissor(We),Le.setScissorTest(it),re=-1;return}else if(Te.__webglFramebuffer===void 0)Je.setupRenderTarget(C);else if(Te.__hasExternalTextures)Je.rebindTextures(C,Ze.get(C.texture).__webglTexture,Ze.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let rt=C.depthTexture;if(Te.__boundDepthTexture!==rt){if(rt!==null&&Ze.has(rt)&&(C.width!==rt.image.width||C.height!==rt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Je.setupDepthRenderbuffer(C)}}let Ne=C.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ie=!0);let Ge=Ze.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Ge[V])?K=Ge[V][te]:K=Ge[V],$=!0):C.samples>0&&Je.useMultisampledRTT(C)===!1?K=Ze.get(C).__webglMultisampledFramebuffer:Array.isArray(Ge)?K=Ge[te]:K=Ge,ge.copy(C.viewport),We.copy(C.scissor),it=C.scissorTest}else ge.copy(Ke).multiplyScalar(Ue).floor(),We.copy(Et).multiplyScalar(Ue).floor(),it=Ct;if(te!==0&&(K=ee),Le.bindFramebuffer(W.FRAMEBUFFER,K)&&Le.drawBuffers(C,K),Le.viewport(ge),Le.scissor(We),Le.setScissorTest(it),$){let Te=Ze.get(C.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+V,Te.__webglTexture,te)}else if(Ie){let Te=V;for(let Ne=0;Ne<C.textures.length;Ne++){let Ge=Ze.get(C.textures[Ne]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,te,Te)}}else if(C!==null&&te!==0){let Te=Ze.get(C.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Te.__webglTexture,te)}re=-1};function ss(C){let V=Ze.get(C);return(V.__readFormat!==C.format||V.__readType!==C.type)&&(V.__readFormat=C.format,V.__readType=C.type,V.__formatReadable=Ut.textureFormatReadable(C.format),V.__typeReadable=Ut.textureTypeReadable(C.type)),V}this.readRenderTargetPixels=function(C,V,te,K,$,Ie,ze,Te=0){if(!(C&&C.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ze.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);try{let Ge=C.textures[Te],rt=Ge.format,gt=Ge.type;C.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=ss(Ge);if(Ve.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=C.width-K&&te>=0&&te<=C.height-$&&W.readPixels(V,te,K,$,Ee.convert(rt),Ee.convert(gt),Ie)}finally{let Ge=Se!==null?Ze.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(C,V,te,K,$,Ie,ze,Te=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ze.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(V>=0&&V<=C.width-K&&te>=0&&te<=C.height-$){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);let Ge=C.textures[Te],rt=Ge.format,gt=Ge.type;C.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=ss(Ge);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let lt=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.bufferData(W.PIXEL_PACK_BUFFER,Ie.byteLength,W.STREAM_READ),W.readPixels(V,te,K,$,Ee.convert(rt),Ee.convert(gt),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let Wt=Se!==null?Ze.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Wt);let ke=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await kd(W,ke,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,Ie),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(lt),W.deleteSync(ke),Ie}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,V=null,te=0){let K=Math.pow(2,-te),$=Math.floor(C.image.width*K),Ie=Math.floor(C.image.height*K),ze=V!==null?V.x:0,Te=V!==null?V.y:0;Je.setTexture2D(C,0),W.copyTexSubImage2D(W.TEXTURE_2D,te,0,0,ze,Te,$,Ie),Le.unbindTexture()},this.copyTextureToTexture=function(C,V,te=null,K=null,$=0,Ie=0){let ze,Te,Ne,Ge,rt,gt,Ve,lt,Wt,ke=C.isCompressedTexture?C.mipmaps[Ie]:C.image;if(te!==null)ze=te.max.x-te.min.x,Te=te.max.y-te.min.y,Ne=te.isBox3?te.max.z-te.min.z:1,Ge=te.min.x,rt=te.min.y,gt=te.isBox3?te.min.z:0;else{let b=Math.pow(2,-$);ze=Math.floor(ke.width*b),Te=Math.floor(ke.height*b),C.isDataArrayTexture?Ne=ke.depth:C.isData3DTexture?Ne=Math.floor(ke.depth*b):Ne=1,Ge=0,rt=0,gt=0}K!==null?(Ve=K.x,lt=K.y,Wt=K.z):(Ve=0,lt=0,Wt=0);let Dt=Ee.convert(V.format),jt=Ee.convert(V.type),He;V.isData3DTexture?(Je.setTexture3D(V,0),He=W.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Je.setTexture2DArray(V,0),He=W.TEXTURE_2D_ARRAY):(Je.setTexture2D(V,0),He=W.TEXTURE_2D),Le.activeTexture(W.TEXTURE0),Le.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,V.flipY),Le.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Le.pixelStorei(W.UNPACK_ALIGNMENT,V.unpackAlignment);let an=Le.getParameter(W.UNPACK_ROW_LENGTH),wt=Le.getParameter(W.UNPACK_IMAGE_HEIGHT),ei=Le.getParameter(W.UNPACK_SKIP_PIXELS),on=Le.getParameter(W.UNPACK_SKIP_ROWS),Di=Le.getParameter(W.UNPACK_SKIP_IMAGES);Le.pixelStorei(W.UNPACK_ROW_LENGTH,ke.width),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,ke.height),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,Ge),Le.pixelStorei(W.UNPACK_SKIP_ROWS,rt),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,gt);let ti=C.isDataArrayTexture||C.isData3DTexture,ni=V.isDataArrayTexture||V.isData3DTexture;if(C.isDepthTexture){let b=Ze.get(C),ft=Ze.get(V),Cn=Ze.get(b.__renderTarget),Ft=Ze.get(ft.__renderTarget);Le.bindFramebuffer(W.READ_FRAMEBUFFER,Cn.__webglFramebuffer),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let Bt=0;Bt<Ne;Bt++)ti&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Ze.get(C).__webglTexture,$,gt+Bt),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Ze.get(V).__webglTexture,Ie,Wt+Bt)),W.blitFramebuffer(Ge,rt,Ge+ze,rt+Te,Ve,lt,Ve+ze,lt+Te,W.DEPTH_BUFFER_BIT,W.NEAREST);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if($!==0||C.isRenderTargetTexture||Ze.has(C)){let b=Ze.get(C),ft=Ze.get(V);Le.bindFramebuffer(W.READ_FRAMEBUFFER,z),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,ie);for(let Cn=0;Cn<Ne;Cn++)ti?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,b.__webglTexture,$,gt+Cn):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,b.__webglTexture,$),ni?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,ft.__webglTexture,Ie,Wt+Cn):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,ft.__webglTexture,Ie),$!==0?W.blitFramebuffer(Ge,rt,Ge+ze,rt+Te,Ve,lt,Ve+ze,lt+Te,W.COLOR_BUFFER_BIT,W.NEAREST):ni?W.copyTexSubImage3D(He,Ie,Ve,lt,Wt+Cn,Ge,rt,ze,Te):W.copyTexSubImage2D(He,Ie,Ve,lt,Ge,rt,ze,Te);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else ni?C.isDataTexture||C.isData3DTexture?W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke.data):V.isCompressedArrayTexture?W.compressedTexSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,ke.data):W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke):C.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke.data):C.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ke.width,ke.height,Dt,ke.data):W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke);Le.pixelStorei(W.UNPACK_ROW_LENGTH,an),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,wt),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,ei),Le.pixelStorei(W.UNPACK_SKIP_ROWS,on),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,Di),Ie===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&W.generateMipmap(He),Le.unbindTexture()},this.initRenderTarget=function(C){Ze.get(C).__webglFramebuffer===void 0&&Je.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Je.setTextureCube(C,0):C.isData3DTexture?Je.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Je.setTexture2DArray(C,0):Je.setTexture2D(C,0),Le.unbindTexture()},this.resetState=function(){G=0,ne=0,Se=null,Le.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return zn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var Tf={type:"change"},Ch={type:"start"},Cf={type:"end"},Ul=new Gi,Af=new In,zb=Math.cos(70*dh.DEG2RAD),nn=new j,An=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Ah=1e-6,Ol=class extends Js{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new j,this.cursor=new j,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:$i.ROTATE,MIDDLE:$i.DOLLY,RIGHT:$i.PAN},this.touches={ONE:Yi.ROTATE,TWO:Yi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new j,this._lastQuaternion=new bn,this._lastTargetPosition=new j,this._quat=new bn().setFromUnitVectors(e.up,new j(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new $r,this._sphericalDelta=new $r,this._scale=1,this._panOffset=new j,this._rotateStart=new et,this._rotateEnd=new et,this._rotateDelta=new et,this._panStart=new et,this._panEnd=new et,this._panDelta=new et,this._dollyStart=new et,this._dollyEnd=new et,this._dollyDelta=new et,this._dollyDirection=new j,this._mouse=new et,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Vb.bind(this),this._onPointerDown=Gb.bind(this),this._onPointerUp=Hb.bind(this),this._onContextMenu=Zb.bind(this),this._onMouseWheel=qb.bind(this),this._onKeyDown=$b.bind(this),this._onTouchStart=Yb.bind(this),this._onTouchMove=jb.bind(this),this._onMouseDown=Wb.bind(this),this._onMouseMove=Xb.bind(this),this._interceptControlDown=Jb.bind(this),this._interceptControlUp=Kb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Tf),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;nn.copy(t).sub(this.target),nn.applyQuaternion(this._quat),this._spherical.setFromVector3(nn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=An:n>Math.PI&&(n-=An),r<-Math.PI?r+=An:r>Math.PI&&(r-=An),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let o=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let l=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),o=l!=this._spherical.radius}if(nn.setFromSpherical(this._spherical),nn.applyQuaternion(this._quatInverse),t.copy(this.target).add(nn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let l=null;if(this.object.isPerspectiveCamera){let h=nn.length();l=this._clampDistance(h*this._scale);let f=h-l;this.object.position.addScaledVector(this._dollyDirection,f),this.object.updateMatrixWorld(),o=!!f}else if(this.object.isOrthographicCamera){let h=new j(this._mouse.x,this._mouse.y,0);h.unproject(this.object);let f=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),o=f!==this.object.zoom;let d=new j(this._mouse.x,this._mouse.y,0);d.unproject(this.object),this.object.position.sub(d).add(h),this.object.updateMatrixWorld(),l=nn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;l!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(l).add(this.object.position):(Ul.origin.copy(this.object.position),Ul.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ul.direction))<zb?this.object.lookAt(this.target):(Af.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ul.intersectPlane(Af,this.target))))}else if(this.object.isOrthographicCamera){let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),l!==this.object.zoom&&(this.object.updateProjectionMatrix(),o=!0)}return this._scale=1,this._performCursorZoom=!1,o||this._lastPosition.distanceToSquared(this.object.position)>Ah||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Ah||this._lastTargetPosition.distanceToSquared(this.target)>Ah?(this.dispatchEvent(Tf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?An/60*this.autoRotateSpeed*e:An/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){nn.setFromMatrixColumn(t,0),nn.multiplyScalar(-e),this._panOffset.add(nn)}_panUp(e,t){this.screenSpacePanning===!0?nn.setFromMatrixColumn(t,1):(nn.setFromMatrixColumn(t,0),nn.crossVectors(this.object.up,nn)),nn.multiplyScalar(e),this._panOffset.add(nn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;nn.copy(r).sub(this.target);let o=nn.length();o*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*o/n.clientHeight,this.object.matrix),this._panUp(2*t*o/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=e-n.left,o=t-n.top,l=n.width,h=n.height;this._mouse.x=r/l*2-1,this._mouse.y=-(o/h)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(An*this._rotateDelta.x/t.clientHeight),this._rotateUp(An*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-An*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(n,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,o=Math.sqrt(n*n+r*r);this._dollyStart.set(0,o)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),r=.5*(e.pageX+n.x),o=.5*(e.pageY+n.y);this._rotateEnd.set(r,o)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(An*this._rotateDelta.x/t.clientHeight),this._rotateUp(An*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,o=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,o),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let l=(e.pageX+t.x)*.5,h=(e.pageY+t.y)*.5;this._updateZoomParameters(l,h)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new et,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Gb(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Vb(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function Hb(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Cf),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Wb(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case $i.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=At.DOLLY;break;case $i.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}break;case $i.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Ch)}function Xb(i){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function qb(i){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(i.preventDefault(),this.dispatchEvent(Ch),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Cf))}function $b(i){this.enabled!==!1&&this._handleKeyDown(i)}function Yb(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Yi.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(i),this.state=At.TOUCH_ROTATE;break;case Yi.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(i),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case Yi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=At.TOUCH_DOLLY_PAN;break;case Yi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Ch)}function jb(i){switch(this._trackPointer(i),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=At.NONE}}function Zb(i){this.enabled!==!1&&i.preventDefault()}function Jb(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Kb(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Bl=class extends hr{constructor(){super(),this.name="RoomEnvironment",this.position.y=-3.5;let e=new ui;e.deleteAttribute("uv");let t=new Ci({side:dn}),n=new Ci,r=new qs(16777215,900,28,2);r.position.set(.418,16.199,.3),this.add(r);let o=new zt(e,t);o.position.set(-.757,13.219,.717),o.scale.set(31.713,28.305,28.591),this.add(o);let l=new Fs(e,n,6),h=new Qt;h.position.set(-10.906,2.009,1.846),h.rotation.set(0,-.195,0),h.scale.set(2.328,7.905,4.651),h.updateMatrix(),l.setMatrixAt(0,h.matrix),h.position.set(-5.607,-.754,-.758),h.rotation.set(0,.994,0),h.scale.set(1.97,1.534,3.955),h.updateMatrix(),l.setMatrixAt(1,h.matrix),h.position.set(6.167,.857,7.803),h.rotation.set(0,.561,0),h.scale.set(3.927,6.285,3.687),h.updateMatrix(),l.setMatrixAt(2,h.matrix),h.position.set(-2.017,.018,6.124),h.rotation.set(0,.333,0),h.scale.set(2.002,4.566,2.064),h.updateMatrix(),l.setMatrixAt(3,h.matrix),h.position.set(2.291,-.756,-2.621),h.rotation.set(0,-.286,0),h.scale.set(1.546,1.552,1.496),h.updateMatrix(),l.setMatrixAt(4,h.matrix),h.position.set(-2.193,-.369,-5.547),h.rotation.set(0,.516,0),h.scale.set(3.875,3.487,2.986),h.updateMatrix(),l.setMatrixAt(5,h.matrix),this.add(l);let f=new zt(e,ns(50));f.position.set(-16.116,14.37,8.208),f.scale.set(.1,2.428,2.739),this.add(f);let d=new zt(e,ns(50));d.position.set(-16.109,18.021,-8.207),d.scale.set(.1,2.425,2.751),this.add(d);let m=new zt(e,ns(17));m.position.set(14.904,12.198,-1.832),m.scale.set(.15,4.265,6.331),this.add(m);let y=new zt(e,ns(43));y.position.set(-.462,8.89,14.52),y.scale.set(4.38,5.441,.088),this.add(y);let g=new zt(e,ns(20));g.position.set(3.235,11.486,-12.541),g.scale.set(2.5,2,.1),this.add(g);let x=new zt(e,ns(100));x.position.set(0,20,0),x.scale.set(1,.1,1),this.add(x)}dispose(){let e=new Set;this.traverse(t=>{t.isMesh&&(e.add(t.geometry),e.add(t.material))});for(let t of e)t.dispose()}};function ns(i){return new Gs({color:0,emissive:16777215,emissiveIntensity:i})}var Rf=14477040,Qb=["#edf1f6","#cfd7e1"],ew=15113984,If=.5,[tw,nw,iw,rw,sw,aw]=[2,3,4,5,6,7],ow=3,kl=class{constructor(e,t){Object.assign(this,{canvas:e,scale:t,follow:!0,robots:[],target:new j}),this.renderer=new Ll({canvas:e,antialias:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=ur,this.renderer.toneMapping=Ks,this.scene=new hr,this.scene.background=new ht(Rf),this.scene.fog=new Cs(Rf,4*t,16*t),this.scene.environment=new es(this.renderer).fromScene(new Bl,.04).texture,this.scene.environmentIntensity=.55,this.world=this.scene.add(new Gn).children.at(-1),this.camera=new _n(38,1,.01*t,60*t),this.camera.up.set(0,0,1),this.orbit=new Ol(this.camera,e),Object.assign(this.orbit,{enableDamping:!0,enablePan:!1,minDistance:.3*t,maxDistance:6*t,maxPolarAngle:1.52}),this.resetCamera(),this.light=new Ys(16777215,2.2),this.light.castShadow=!0,this.light.shadow.mapSize.set(1024,1024),Object.assign(this.light.shadow.camera,{left:-t,right:t,top:t,bottom:-t,near:.1,far:6*t}),Object.assign(this.light.shadow,{radius:4,bias:-5e-4,normalBias:.01*t}),this.scene.add(this.light,this.light.target);let n=new Os(uw());n.colorSpace=gn,n.wrapS=n.wrapT=Or,n.anisotropy=this.renderer.capabilities.getMaxAnisotropy(),this.floor=new Ci({map:n,roughness:.95,envMapIntensity:.6}),this.arrow=new Zs(new j(1,0,0),new j,.3*t,ew,.12*t,.09*t),this.arrow.visible=!1,this.world.add(this.arrow),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;!e||!t||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.fov=38*Math.min(1.5,Math.max(1,1/this.camera.aspect)),this.camera.updateProjectionMatrix())}resetCamera(){this.camera.position.copy(this.target).add(new j(.62,-1,.42).multiplyScalar(this.scale))}setTerrain(e){this.ground?.traverse(r=>r.geometry?.dispose()),this.ground?.removeFromParent(),this.ground=new Gn;let t=80*this.scale,n=new Hi(t,t);if(Pf(n,this.scale),this.plane=new zt(n,this.floor),this.plane.receiveShadow=!0,this.ground.add(this.plane),e.grid){let{shape:[r,o],extent:l,lowest:h,span:f}=e.grid,d=new Hi(...l,o-1,r-1),m=d.attributes.position;for(let y=0;y<m.count;y++){let g=r-1-Math.floor(y/o);m.setZ(y,h+f*e.heights[g*o+y%o])}Pf(d,this.scale),d.computeVertexNormals(),this.ground.add(Object.assign(new zt(d,this.floor),{receiveShadow:!0,castShadow:!1})),this.plane.position.z=h-.01*this.scale}this.world.add(this.ground)}setSlope(e){this.world.rotation.y=-e}setRobots(e,t){for(let n of this.robots)n.group.removeFromParent();this.robots=e.map((n,r)=>new Ph(n,t[r]));for(let n of this.robots)this.world.add(n.group)}record(){for(let e of this.robots)e.record()}draw(e,t){for(let f of this.robots)f.place(e);let[n,r,o]=this.robots[0].position(e),l=this.world.localToWorld(new j(n,r,o));if(this.follow){let f=l.clone().sub(this.target);f.z*=Math.min(1,4*t),this.target.add(f),this.camera.position.add(f)}this.orbit.target.copy(this.target),this.orbit.update(),this.light.target.position.copy(l),this.light.position.copy(l).add(new j(.5,.9,2.2).multiplyScalar(this.scale));let h=2*If*this.scale;this.plane.position.setX(h*Math.round(n/h)).setY(h*Math.round(r/h)),this.arrow.visible&&(this.arrow.left-=t)<0&&(this.arrow.visible=!1),this.renderer.render(this.scene,this.camera)}showPush(e,t){let{scale:n}=this,[r,o,l]=this.robots[e].position(1),h=new j(...t).normalize();this.arrow.position.set(r,o,l).addScaledVector(h,-.5*n),this.arrow.setDirection(h),Object.assign(this.arrow,{visible:!0,left:.5})}pick(e,t){let n=new js,{width:r,height:o}=this.canvas.getBoundingClientRect();n.setFromCamera(new et(2*e/r-1,1-2*t/o),this.camera);let[l]=n.intersectObjects(this.robots.map(d=>d.group));if(!l)return null;let h=this.robots.findIndex(d=>d.meshes.includes(l.object)),f=n.ray.direction.clone().applyQuaternion(this.world.quaternion.clone().invert()).setZ(0).normalize();return{index:h,direction:f.toArray()}}},Ph=class{constructor(e,t){this.simulation=e,this.group=new Gn,this.meshes=[];let{model:n}=e;this.bodies=Array.from({length:n.nbody},()=>this.group.add(new Gn).children.at(-1));for(let r=0;r<n.ngeom;r++){let o=n.geom_bodyid[r],l=o&&n.geom_group[r]<ow?lw(n,r):null;if(!l)continue;let h=new zt(l,hw(n,r,t));h.position.fromArray(n.geom_pos,3*r),h.quaternion.copy(Rh(n.geom_quat,r)),h.castShadow=h.receiveShadow=!0,this.bodies[o].add(h),this.meshes.push(h)}this.record(),this.record()}record(){let{xpos:e,xquat:t}=this.simulation.data;this.before=this.now??{xpos:e.slice(),xquat:t.slice()},this.now={xpos:e.slice(),xquat:t.slice()}}place(e){this.bodies.forEach((t,n)=>{t.position.fromArray(this.before.xpos,3*n).lerp(new j().fromArray(this.now.xpos,3*n),e),t.quaternion.copy(Rh(this.before.xquat,n)).slerp(Rh(this.now.xquat,n),e)})}position(e){let t=3*this.simulation.base;return[0,1,2].map(n=>(1-e)*this.before.xpos[t+n]+e*this.now.xpos[t+n])}},Rh=(i,e)=>new bn(i[4*e+1],i[4*e+2],i[4*e+3],i[4*e]);function lw(i,e){let[t,n,r]=i.geom_size.slice(3*e,3*e+3);switch(i.geom_type[e]){case tw:return new Xr(t,32,16);case nw:return new zs(t,2*n,8,24).rotateX(Math.PI/2);case iw:return new Xr(1,32,16).scale(t,n,r);case rw:return new Wr(t,t,2*n,32).rotateX(Math.PI/2);case sw:return new ui(2*t,2*n,2*r);case aw:return cw(i,i.geom_dataid[e]);default:return null}}function cw(i,e){let{mesh_vert:t,mesh_vertadr:n,mesh_vertnum:r,mesh_face:o,mesh_faceadr:l,mesh_facenum:h}=i,f=new En,d=n[e],m=l[e];return f.setAttribute("position",new Dn(t.slice(3*d,3*(d+r[e])),3)),f.setIndex(Array.from(o.slice(3*m,3*(m+h[e])))),f.computeVertexNormals(),f}function hw(i,e,t){let n=i.geom_matid[e],[r,o,l]=n>=0?i.mat_rgba.slice(4*n,4*n+3):i.geom_rgba.slice(4*e,4*e+3),h=new ht().setRGB(r,o,l,gn);return t&&h.lerp(new ht(t.colour),t.share),new Ci({color:h,roughness:.45,metalness:.1})}function Pf(i,e){let{position:t,uv:n}=i.attributes,r=2*If*e;for(let o=0;o<t.count;o++)n.setXY(o,t.getX(o)/r,t.getY(o)/r)}function uw(){let i=document.createElement("canvas"),e=256,t=e/2;i.width=i.height=e;let n=i.getContext("2d");for(let[r,o]of Qb.entries())n.fillStyle=o,n.fillRect(0,r*t,t,t),n.fillRect(t,(1-r)*t,t,t);return i}var ua=class{constructor({name:e,xml:t,heights:n}){if(Object.assign(this,{name:e,xml:t,grid:n??null,heights:null}),n){let r=new Uint16Array(Uint8Array.from(atob(n.data),o=>o.charCodeAt(0)).buffer);this.heights=Float32Array.from(r,o=>o/65535)}}highest(e,t,n){if(!this.grid)return 0;let{shape:[r,o],extent:l,lowest:h,span:f}=this.grid,d=g=>(g+l[0]/2)/l[0]*(o-1),m=g=>(g+l[1]/2)/l[1]*(r-1),y=-1/0;for(let g=Math.max(0,Math.floor(m(t-n)));g<=Math.min(r-1,Math.ceil(m(t+n)));g++)for(let x=Math.max(0,Math.floor(d(e-n)));x<=Math.min(o-1,Math.ceil(d(e+n)));x++)y=Math.max(y,this.heights[g*o+x]);return y===-1/0?0:h+f*y}};var Ih=2*Math.PI,dw="gait_swing",da=class{constructor(e,t,n){Object.assign(this,{simulation:e,graph:t,control:n}),this.amplitude=this.frequency=1,this.reset()}reset(e,t=[0,0]){this.simulation.reset(e),this.command=Float64Array.from(t),this.requested=[...t],this.memory={last_action:new Float32Array(this.simulation.play.length),gait_phase:Float32Array.of(0),observation_history:new Float32Array(this.graph.inputs.observation_history?.length??0).fill(NaN)},this.time=0}inputs(){let{simulation:e}=this;return{projected_gravity:e.projectedGravity(),angular_velocity:e.reading("angular_velocity_b"),joint_position:e.reading("joint_position"),joint_velocity:e.reading("joint_velocity"),command:this.command,...this.memory}}step(){let{simulation:e,graph:t,memory:n,frequency:r}=this,o=t.run(this.inputs(),{[dw]:this.amplitude});if(o.action&&n.last_action.set(o.action),o.next_observation_history&&n.observation_history.set(o.next_observation_history),o.next_gait_phase){let l=(o.next_gait_phase[0]-n.gait_phase[0]+Ih)%Ih;n.gait_phase[0]=r===1?o.next_gait_phase[0]:(n.gait_phase[0]+r*l)%Ih}e.step(o.joint_target),this.control.command_rate.forEach((l,h)=>{let f=this.requested[h]-this.command[h],d=l*this.control.timestep;this.command[h]=Math.abs(f)<=d?this.requested[h]:this.command[h]+Math.sign(f)*d}),this.time+=this.control.timestep}};var fw=.56,pw=1.5,mw=.3,zl=class{constructor(e,t){Object.assign(this,{mujoco:e,content:t,scale:t.robot.scale,walkers:[]}),this.terrains=t.terrains.map(n=>new ua(n)),this.settings=this.standard(),this.compare=!1,this.learned=null,this.request=[0,0],this.rebuild()}standard(){return{terrain:this.content.terrain,slope:0,friction:null,payload:0,amplitude:1,frequency:1}}get terrain(){return this.terrains.find(({name:e})=>e===this.settings.terrain)}rebuild(){for(let{simulation:o}of this.walkers)o.delete();let{mujoco:e,content:t,terrain:n}=this,r=[this.learned??new Fi(t.policy)];this.compare&&t.gait&&r.push(new Fi(t.gait)),this.walkers=r.map(o=>new da(new ds(e,n,t.robot),o,t.control)),this.reset()}reset(){this.apply();let{height:e}=this.content.robot;this.walkers.forEach((t,n)=>{let r=this.walkers.length>1?(.5-n)*fw*this.scale:0,o=[...this.content.robot.start];o[1]=r,o[2]=e+this.terrain.highest(0,r,.2*this.scale),t.reset(o),Object.assign(t,{downFor:0,travelled:0,speed:0,rate:0})}),this.time=0}apply(){let{slope:e,friction:t,payload:n,amplitude:r,frequency:o}=this.settings;for(let l of this.walkers)Object.assign(l,{amplitude:r,frequency:o}),l.simulation.setSlope(e),l.simulation.setPayload(n),t!==null&&l.simulation.setFriction(t)}step(){let{timestep:e}=this.content.control;this.time+=e;for(let t of this.walkers){let{simulation:n}=t,[r,o]=n.position();t.requested=[...this.request],t.step();let[l]=n.reading("linear_velocity_b"),h=n.position(),[,,f]=n.reading("angular_velocity_b"),d=e/mw;t.speed+=d*(l-t.speed),t.rate+=d*(f-t.rate),t.travelled+=Math.hypot(h[0]-r,h[1]-o),t.downFor=n.fallen()?t.downFor+e:0,t.downFor>pw&&this.standUp(t)}}standUp(e){let{simulation:t,travelled:n}=e,r=[...this.content.robot.start],[o,l]=t.position(),h=t.yaw();Number.isFinite(o+l+h)&&([r[0],r[1],r[3],r[6]]=[o,l,Math.cos(h/2),Math.sin(h/2)],r[2]=this.content.robot.height+this.terrain.highest(o,l,.2*this.scale)),e.reset(r),Object.assign(e,{downFor:0,travelled:n,speed:0,rate:0})}contacts(e=0){return Array.from(this.walkers[e].simulation.reading("foot_force"),t=>t>this.content.robot.contact)}};function Df(i,e){let{start:t,command:n,steps:r,end:o}=e.reference,l=new ua(e.terrains.find(({heights:m})=>!m)),h=new ds(i,l,e.robot),f=new da(h,new Fi(e.policy),e.control);f.reset(t,n);let d=r;return m=>{for(;m>0&&d>0;m--,d--)f.step();if(d)return null;let[y,g]=[h.position(),o].map(([M,R])=>Math.hypot(M,R)),x={seconds:r*e.control.timestep,speed:n[0],here:y,there:g,qpos:[...h.data.qpos]};return h.delete(),{...x,percent:100*Math.abs(y-g)/g}}}var gw=.8,_w=.25,vw=.1,yw=4,xw={colour:13983232,share:.72},Lh=class{constructor(e,t,n,r){this.walk=new zl(e,t),Object.assign(this,{language:La(),paused:!1,slow:!1,throttle:0,turn:0,checked:null}),this.view=new kl(document.getElementById("view"),this.walk.scale),this.feet=new Na(document.getElementById("feet"),t.robot.legs,t.control.timestep),this.controls=new Fa(this),this.learning=new ka(this,n,r),this.check=Df(e,t),this.due=0,this.redraw(),this.controls.translate(),this.controls.steer(gw,0)}redraw(){let{walk:e,view:t,feet:n}=this;t.setTerrain(e.terrain),t.setSlope(e.settings.slope),t.setRobots(e.walkers.map(({simulation:r})=>r),[null,xw]),n.clear()}setPaused(e){this.paused=e,this.controls.showPaused(e)}setSlow(e){this.slow=e,this.controls.showSlow(e)}setLanguage(e){this.language=e,this.controls.translate()}set(e){Object.assign(this.walk.settings,e),this.walk.apply(),this.view.setSlope(this.walk.settings.slope)}setTerrain(e){this.walk.settings.terrain=e,this.walk.rebuild(),this.redraw()}setCompare(e){this.walk.compare=e,this.walk.rebuild(),this.redraw()}learned(e,{command:[t],turns:n}={}){let{walk:r,controls:o}=this;o.limitTo(e&&[t,n??0]),e!==r.learned&&(r.learned=e,r.rebuild(),this.redraw())}reset(){this.walk.reset(),this.redraw(),this.view.resetCamera()}push(e,t){for(let n of t)this.walk.walkers[n].simulation.push(e.map(r=>r*this.strength));this.view.showPush(t[0],e)}pushSomewhere(){let e=2*Math.PI*Math.random();this.push([Math.cos(e),Math.sin(e),0],[...this.walk.walkers.keys()])}step(e=1){for(let t=0;t<e;t++)this.walk.step(),this.view.record(),this.feet.record(this.walk.contacts()),this.learning.watch(this.walk.walkers[0],this.walk.content.control.timestep)}frame(e){let{timestep:t}=this.walk.content.control;if(this.controls.pollGamepad(),!this.paused){this.due+=Math.min(e,vw)*(this.slow?_w:1);let n=Math.floor(this.due/t);this.step(n),this.due-=n*t}!this.checked&&(this.checked=this.check(yw))&&this.controls.showCheck(),this.view.draw(this.due/t,e),this.feet.draw(),this.controls.show()}run(){let e=performance.now(),t=n=>{this.frame(Math.max(0,n-e)/1e3),e=n,requestAnimationFrame(t)};requestAnimationFrame(t)}};async function Dh(i){let e=Uint8Array.from(atob(document.getElementById(i).textContent.trim()),t=>t.charCodeAt(0));return new Uint8Array(await new Response(new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer())}var Lf=document.getElementById("message");try{Object.assign(Lf,{hidden:!1,textContent:Bn(La(),"loading")});let i=JSON.parse(new TextDecoder().decode(await Dh("document"))),e=await Dh("wasm"),t=new TextDecoder().decode(await Dh("worker")),n=new Lh(await Tu(e),i,t,e);window.quadruped={page:n,Graph:Fi,walk:n.walk},n.run()}catch(i){throw Object.assign(Lf,{hidden:!1,textContent:Bn(La(),"failed",i.message??i)}),i}
