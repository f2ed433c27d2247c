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
var lc={en:"English",zh:"中文"},cc={en:{title:"MiniQuadruped: a robot that learned to walk",tagline:"It learned to walk by trial and error. Drive it, push it, change its world: everything runs in this file.",other_language:"中文",loading:"Loading the physics …",failed:"The page cannot run here: {}",no_webgl:"This browser draws no 3D graphics: WebGL 2 is switched off. Chrome, Edge: Settings, System, switch on “Use graphics acceleration when available”, and restart the browser. Firefox: set webgl.disabled to false in about:config. Remote desktops and old graphics drivers often have no WebGL: open this file on another machine or phone.",steer:"Steer",steer_hint:"Arrow keys, the stick below, or a gamepad. Forward speed stays, turning springs back.",sideways_hint:"Sideways: Q to the left, E to the right, or the stick. The slider above it turns, and the right stick of a gamepad.",speed_limit:"Speed limit",stop:"Stop",disturb:"Push",disturb_hint:"Click on the robot: it is pushed away from you.",push_strength:"Strength",push:"Random push",ground:"Ground",terrain:"Terrain",slope:"Slope",friction:"Friction",robot:"Robot",payload:"Payload",amplitude:"Gait amplitude",frequency:"Gait frequency",gait_hint:"They change the scripted gait to which the policy adds.",compare:"Scripted gait next to it",compare_hint:"The orange robot repeats a fixed motion and feels nothing.",follow:"Camera follows",standard:"Reset all settings",pause:"Pause",resume:"Resume",reset:"Reset",slow:"Slow motion",settings:"Settings",speed:"Speed",commanded:"commanded",sideways:"To the left",turning:"Turning",distance:"Distance",feet:"Feet on the ground",fell:"It fell. It stands up again in a moment.",stuck:"It does not get on: this ground is too hard for its policy. Turn it, or choose another ground.",keys:"↑ ↓ speed · ← → turn · 0 stop · space pause · P push · R reset · C scripted gait · M slow motion",engine:"MuJoCo {} (WebAssembly)",checking:"comparing with Python …",check:"{} s at {} m/s: {} m here, {} m in Python with MuJoCo {}. They differ by {} cm.",about:"Policy “{}”, MiniQuadruped {}. Physics: MuJoCo (Google DeepMind, Apache-2.0). Drawing: three.js (MIT).",other:"Scripted gait: {} m/s, {} m; falls {}, policy {}; put back {} times",learn:"Learn in this tab",learn_hint:"A new robot that only marches on the spot learns here to walk: PPO in JavaScript, with the physics in parallel workers. The robot on the page walks with the newest policy. Push it, and change the reward while it learns.",learn_start:"Learn from zero",learn_pause:"Pause learning",learn_continue:"Go on",learn_again:"Forget it",learn_workers:"64 robots, parallel workers: {}.",learn_starting:"Starting, parallel workers: {} …",learn_running:"Learning, parallel workers: {}.",learn_reached:"After {} s of learning it keeps {} m/s.",learn_numbers:"{} s · {} steps · {} steps/s · noise {}",learn_curve_speed:"mean speed, m/s",learn_curve_reward:"mean reward per second",learn_zero:"- - marching only",learn_speed:"Speed to learn",learn_lift:"Weight of lifting the feet",learn_smooth:"Weight of changes of the action",learn_turn:"Learn slower speeds and turns, too",terrains:{flat:"flat",rough:"rough",hills:"hills",slope:"slopes",steps:"blocks",stairs:"stairs",gaps:"trenches",wave:"waves"}},zh:{title:"MiniQuadruped：学会走路的机器人",tagline:"它通过反复试错学会了走路。驾驶它，推它，改变它的世界：一切都在这个文件里运行。",other_language:"English",loading:"正在加载物理引擎……",failed:"页面无法在此运行：{}",no_webgl:"浏览器无法显示三维图形：WebGL 2 没有开启。Chrome、Edge：在“设置 → 系统”中开启“使用图形加速功能（如果可用）”，然后重启浏览器。Firefox：在 about:config 中把 webgl.disabled 设为 false。远程桌面和旧的显卡驱动往往没有 WebGL：请换一台电脑或用手机打开这个文件。",steer:"驾驶",steer_hint:"方向键、下面的摇杆或手柄。前进速度保持不变，松手后停止转向。",sideways_hint:"横向：Q 向左，E 向右，或用摇杆；摇杆上方的滑块或手柄的右摇杆用来转向。",speed_limit:"限速",stop:"停止",disturb:"推",disturb_hint:"点击机器人，把它朝远离你的方向推。",push_strength:"力度",push:"随机推一下",ground:"地面",terrain:"地形",slope:"坡度",friction:"摩擦系数",robot:"机器人",payload:"负载",amplitude:"步态幅度",frequency:"步态频率",gait_hint:"它们改变脚本步态，策略在此基础上修正。",compare:"旁边显示脚本步态",compare_hint:"橙色机器人只重复固定的动作，没有任何感知。",follow:"镜头跟随",standard:"恢复全部设置",pause:"暂停",resume:"继续",reset:"重置",slow:"慢动作",settings:"设置",speed:"速度",commanded:"指令",sideways:"向左",turning:"转向",distance:"距离",feet:"着地的脚",fell:"它摔倒了，马上会重新站起来。",stuck:"它走不动了：这种地面超出了策略所学。请转向，或换一种地面。",keys:"↑ ↓ 速度 · ← → 转向 · 0 停止 · 空格 暂停 · P 推 · R 重置 · C 脚本步态 · M 慢动作",engine:"MuJoCo {}（WebAssembly）",checking:"正在与 Python 比较……",check:"以 {1} m/s 走 {0} 秒：这里 {2} m，Python（MuJoCo {4}）{3} m，相差 {5} cm。",about:"策略“{}”，MiniQuadruped {}。物理：MuJoCo（Google DeepMind，Apache-2.0）。绘图：three.js（MIT）。",other:"脚本步态：{} m/s，{} m；摔倒 {} 次，策略 {} 次；放回 {} 次",learn:"在本页学习",learn_hint:"一个只会原地踏步的新机器人在这里学走路：PPO 用 JavaScript 写成，物理在多个并行线程中运行。页面上的机器人始终用最新的策略行走。学习时可以推它，也可以改变奖励。",learn_start:"从零开始学习",learn_pause:"暂停学习",learn_continue:"继续学习",learn_again:"全部忘掉",learn_workers:"64 个机器人，并行线程：{}。",learn_starting:"正在启动，并行线程：{}……",learn_running:"正在学习，并行线程：{}。",learn_reached:"学习 {} 秒后，它能保持 {} m/s。",learn_numbers:"{} 秒 · {} 步 · {} 步/秒 · 噪声 {}",learn_curve_speed:"平均速度，m/s",learn_curve_reward:"平均每秒奖励",learn_zero:"- - 原地踏步",learn_speed:"要学的速度",learn_lift:"抬脚的权重",learn_smooth:"动作变化的权重",learn_turn:"也学较慢的速度和转弯",terrains:{flat:"平地",rough:"崎岖",hills:"丘陵",slope:"斜坡",steps:"方块",stairs:"台阶",gaps:"沟壑",wave:"波浪"}}};function hc(i=navigator.languages){return i.map(e=>e.slice(0,2)).find(e=>e in lc)??"en"}function Pn(i,e,...t){let n=0;return cc[i][e].replace(/\{(\d?)\}/g,(r,a)=>t[a===""?n++:Number(a)])}var je=i=>document.getElementById(i),J0=Math.PI/180,uc=.15,Oa=class{constructor(e){Object.assign(this,{page:e,held:new Set,stick:null,gamepad:!1});let{control:t,robot:n,gait:r,policy:a}=e.walk.content,[l,c]=t.forward,{walk:f}=e;this.sliders={limit:[t.key_steps[0],c,c,u=>`${u.toFixed(2)} m/s`,u=>{e.limit=u,this.steer()}],strength:[.1,1.5,.6,u=>`${(u*Math.sqrt(f.scale)).toFixed(2)} m/s`,u=>{e.strength=u*Math.sqrt(f.scale)}],slope:[-12,12,0,u=>`${u.toFixed(0)}°`,u=>e.set({slope:u*J0})],friction:[.1,1.5,n.friction,u=>u.toFixed(2),u=>e.set({friction:u})],payload:[0,n.mass/2,0,u=>`${u.toFixed(n.mass<2?2:1)} kg`,u=>e.set({payload:u})],amplitude:[0,2,1,u=>`${u.toFixed(2)}×`,u=>e.set({amplitude:u})],frequency:[.5,1.5,1,u=>`${u.toFixed(2)}×`,u=>e.set({frequency:u})]};for(let[u,[m,v,g,y,M]]of Object.entries(this.sliders)){let A=je(u),S=A.closest("label").querySelector("output");Object.assign(A,{min:m,max:v,step:{slope:1,limit:"any"}[u]??.01,value:g}),A.addEventListener("input",()=>{S.textContent=y(A.valueAsNumber),M(A.valueAsNumber)}),S.textContent=y(g)}e.limit=c,this.limits={lowest:l,highest:c,turn:t.turn[1],lateral:t.lateral},document.body.classList.toggle("sideways",!!t.lateral),e.strength=this.sliders.strength[2]*Math.sqrt(f.scale),je("frequency").closest("label").hidden=!("gait_phase"in a.inputs),je("amplitude").closest("label").hidden=!a.nodes.some(([,,u])=>u==="gait_swing"),je("gait_hint").hidden=je("amplitude").closest("label").hidden,je("gait").hidden=je("frequency").closest("label").hidden&&je("amplitude").closest("label").hidden,je("beside").hidden=je("beside_hint").hidden=!r;for(let{name:u}of f.terrains)je("terrain").append(new Option(u,u,!1,u===f.settings.terrain));je("terrain").addEventListener("change",()=>e.setTerrain(je("terrain").value));for(let[u,m]of Object.entries({pause:()=>e.setPaused(!e.paused),slow:()=>e.setSlow(!e.slow),reset:()=>e.reset(),stop:()=>this.stop(),push:()=>e.pushSomewhere(),language:()=>e.setLanguage(e.language==="en"?"zh":"en"),standard:()=>this.standard(),open:()=>this.toggle()}))je(u).addEventListener("click",m);je("compare").addEventListener("change",()=>e.setCompare(je("compare").checked)),je("follow").addEventListener("change",()=>{e.view.follow=je("follow").checked}),this.addKeys(),this.addStick(),this.addClicks()}addKeys(){let e={ArrowUp:.2,ArrowDown:-.2},t={ArrowLeft:[1,0],ArrowRight:[-1,0],...this.limits.lateral&&{q:[0,1],e:[0,-1]}},n=l=>l.length===1?l.toLowerCase():l,r=()=>this.steer(void 0,...[0,1].map(l=>[...this.held].reduce((c,f)=>c+t[f][l],0))),a={" ":()=>this.page.setPaused(!this.page.paused),r:()=>this.page.reset(),p:()=>this.page.pushSomewhere(),m:()=>this.page.setSlow(!this.page.slow),0:()=>this.stop(),c:()=>{je("beside").hidden||(je("compare").checked=!je("compare").checked,this.page.setCompare(je("compare").checked))}};addEventListener("keydown",l=>{let{target:c}=l,f=n(l.key);if(!(l.ctrlKey||l.metaKey||l.altKey||c.matches("select, input[type=range]"))&&!(f===" "&&c.matches("button, input"))){if(f in e)this.steer(Math.round(5*(this.page.throttle+e[f]))/5);else if(f in t)this.held.add(f),r();else if(f in a)a[f]();else return;l.preventDefault()}}),addEventListener("keyup",({key:l})=>{this.held.delete(n(l))&&r()}),addEventListener("blur",()=>{this.held.size&&(this.held.clear(),r())})}steerByStick(e,t,n){this.limits.lateral?this.steer(t,n,-e):this.steer(t,-e)}addStick(){let e=je("stick"),t=r=>{let{left:a,top:l,width:c,height:f}=e.getBoundingClientRect(),u=.36,m=((r.clientX-a)/c-.5)/u,v=(.5-(r.clientY-l)/f)/u;this.steerByStick(Math.abs(m)<uc?0:m,Math.abs(v)<uc?0:v)};e.addEventListener("pointerdown",r=>{e.setPointerCapture(r.pointerId),t(r)}),e.addEventListener("pointermove",r=>{e.hasPointerCapture(r.pointerId)&&t(r)});for(let r of["pointerup","pointercancel"])e.addEventListener(r,()=>this.steer(void 0,0,0));let n=je("turn");n.addEventListener("input",()=>this.steer(void 0,-n.valueAsNumber)),n.addEventListener("change",()=>{n.blur(),this.steer(void 0,0)})}pollGamepad(){let e=navigator.getGamepads?.().find(c=>c?.connected);if(!e)return;let[t,n,r=0]=e.axes.map(c=>Math.abs(c)<uc?0:c),a=!!(t||n||this.limits.lateral&&r);(a||this.gamepad)&&this.steerByStick(t,-n,-r),this.gamepad=a;let l=e.buttons[0]?.pressed;l&&!this.pressed&&this.page.pushSomewhere(),this.pressed=l}steer(e=this.page.throttle,t=this.page.turn,n=this.page.left){let{page:r}=this,a=g=>Math.min(1,Math.max(-1,g));Object.assign(r,{throttle:a(e),turn:a(t),left:a(n)});let{lowest:l,highest:c,turn:f,lateral:u}=this.limits,m=r.throttle*r.limit;r.walk.request=[Math.min(c,Math.max(l,m)),r.turn*f],u&&r.walk.request.push(Math.abs(r.left)*u[r.left>0?1:0]);let v=u?r.left:r.turn;je("knob").style.transform=`translate(${-36*v}%, ${-36*r.throttle}%) translate(${-v*30}px, ${-r.throttle*30}px)`,je("turn").value=-r.turn}limitTo(e){let{forward:[t,n],turn:[,r],lateral:a}=this.page.walk.content.control;this.limits=e?{lowest:e[1]?0:e[0],highest:e[0],turn:e[1]}:{lowest:t,highest:n,turn:r,lateral:a},this.steer(e?1:void 0,0,0)}stop(){this.steer(0,0,0)}addClicks(){let e=je("view"),t=r=>{let{left:a,top:l}=e.getBoundingClientRect();return[r.clientX-a,r.clientY-l]},n=null;e.addEventListener("pointerdown",r=>{n=t(r)}),e.addEventListener("pointerup",r=>{let[a,l]=t(r);if(n&&Math.hypot(a-n[0],l-n[1])<6){let c=this.page.view.pick(a,l);c&&this.page.push(c.direction,[c.index])}n=null}),e.addEventListener("pointermove",r=>{r.buttons||e.classList.toggle("aim",this.page.view.pick(...t(r))!==null)})}standard(){for(let[e,[,,t,n,r]]of Object.entries(this.sliders))je(e).value=t,je(e).closest("label").querySelector("output").textContent=n(t),r(t);this.page.set({friction:null}),je("terrain").value=this.page.walk.content.terrain,this.page.setTerrain(je("terrain").value)}toggle(e=!je("panel").classList.contains("open")){je("panel").classList.toggle("open",e),document.body.classList.toggle("sheet",e),je("open").setAttribute("aria-expanded",e),je("open").textContent=e?"✕":"⚙",this.page.view.resize()}translate(){let{language:e,walk:t,paused:n}=this.page,r=(c,...f)=>Pn(e,c,...f);document.documentElement.lang=e==="zh"?"zh-CN":"en",document.title=r("title");for(let c of document.querySelectorAll("[data-text]"))c.textContent=r(c.dataset.text);for(let c of document.querySelectorAll("[data-label]"))c.ariaLabel=c.title=r(c.dataset.label);for(let c of je("terrain").options)c.textContent=cc[e].terrains[c.value]??c.value;let{name:a,versions:l}=t.content;je("engine").textContent=r("engine",t.mujoco.mj_versionString()),je("about").textContent=r("about",a,l.mini_quadruped),this.showPaused(n),this.showCheck(),this.page.learning.translate()}showPaused(e){je("pause").textContent=e?"▶":"❚❚",je("pause").title=je("pause").ariaLabel=Pn(this.page.language,e?"resume":"pause")}showSlow(e){je("slow").setAttribute("aria-pressed",e)}showCheck(){let{page:e}=this,{language:t,checked:n}=e;je("check").textContent=n?Pn(t,"check",n.seconds,n.speed,n.here.toFixed(2),n.there.toFixed(2),e.walk.content.versions.mujoco,(100*Math.abs(n.here-n.there)).toFixed(1)):Pn(t,"checking")}tell(e,...t){je("message").hidden=!e,e&&(je("message").textContent=Pn(this.page.language,e,...t))}show(){let{walk:e,language:t}=this.page,[n]=e.walkers,r=c=>c.toFixed(2).replace(/^-(?=0\.00$)/,""),a=c=>`${Pn(t,"commanded")} ${r(c)}`;je("speed").textContent=`${r(n.speed)} m/s`,je("wanted").textContent=a(n.command[0]),je("rate").textContent=`${r(n.rate)} rad/s`,je("wanted_rate").textContent=a(n.command[1]),je("left").textContent=`${r(n.left)} m/s`,je("wanted_left").textContent=a(n.command[2]??0),je("distance").textContent=`${n.travelled.toFixed(1)} m`,je("time").textContent=`${e.time.toFixed(1)} s`;let[,l]=e.walkers;je("other").hidden=!l,l&&(je("other").textContent=Pn(t,"other",r(l.speed),l.travelled.toFixed(1),l.falls,n.falls,l.returned)),this.tell(n.downFor>.1?"fell":n.stuck&&!e.learned?"stuck":null)}};var K0="#57616d",Q0="#e3e8ee",Ba=class{constructor(e,t,n){Object.assign(this,{canvas:e,legs:t,length:Math.round(2.5/n),history:[]})}clear(){this.history=[]}record(e){this.history.push(e),this.history.length>this.length&&this.history.shift()}draw(){let{canvas:e,legs:t,history:n,length:r}=this,a=devicePixelRatio||1,l=e.clientWidth,c=e.clientHeight;if(!l)return;let f=[l*a,c*a].map(Math.round);(e.width!==f[0]||e.height!==f[1])&&([e.width,e.height]=f);let u=e.getContext("2d"),m=26,v=c/t.length,g=(l-m)/r;u.setTransform(a,0,0,a,0,0),u.clearRect(0,0,l,c),u.font="11px system-ui, sans-serif",u.textBaseline="middle",t.forEach(({name:y,colour:M},A)=>{let S=A*v+.18*v,_=.64*v,P=r-n.length;u.fillStyle=K0,u.fillText(y.slice(0,3),0,A*v+v/2),u.fillStyle=Q0,u.fillRect(m,S,l-m,_),u.fillStyle=M;for(let U=0;U<n.length;U++){if(!n[U][A])continue;let I=U;for(;I+1<n.length&&n[I+1][A];)I++;u.fillRect(m+(P+U)*g,S,(I-U+1)*g,_),U=I}})}};var us=class{constructor(e){this.sizes=e,this.layers=e.slice(1).map((t,n)=>({inputs:e[n],outputs:t})),this.length=0;for(let t of this.layers)t.start=this.length,this.length+=(t.inputs+1)*t.outputs;this.values=e.map(t=>new Float64Array(t)),this.slopes=e.map(t=>new Float64Array(t))}initialize(e,t,n){for(let{start:r,inputs:a,outputs:l}of this.layers){let c=(l===this.sizes.at(-1)?n:1)/Math.sqrt(a);for(let f=0;f<a*l;f++)e[r+f]=c*t.normal();e.fill(0,r+a*l,r+(a+1)*l)}}forward(e,t,n=0){let r=this.values[0];for(let a=0;a<r.length;a++)r[a]=t[n+a];for(let a=0;a<this.layers.length;a++){let{start:l,inputs:c,outputs:f}=this.layers[a],u=this.values[a],m=this.values[a+1],v=a+1<this.layers.length,g=l+c*f;for(let y=0,M=l;y<f;y++,M+=c){let A=e[g+y];for(let S=0;S<c;S++)A+=e[M+S]*u[S];m[y]=v&&A<0?Math.exp(A)-1:A}}return this.values.at(-1)}backward(e,t,n){this.slopes.at(-1).set(n);for(let r=this.layers.length-1;r>=0;r--){let{start:a,inputs:l,outputs:c}=this.layers[r],f=this.values[r],u=this.slopes[r],m=this.values[r+1],v=this.slopes[r+1],g=a+l*c,y=r+1<this.layers.length;r>0&&u.fill(0);for(let M=0,A=a;M<c;M++,A+=l){let S=y&&m[M]<0?v[M]*(m[M]+1):v[M];if(t[g+M]+=S,r>0)for(let _=0;_<l;_++)t[A+_]+=S*f[_],u[_]+=S*e[A+_];else for(let _=0;_<l;_++)t[A+_]+=S*f[_]}}}};var Cu=.2;var Ru=[-1,-2.5,3e5];var ka=class i{constructor(e,t,n=[64,64]){Object.assign(this,{observations:e,actions:t,logStd:Ru[0]}),this.actor=new us([e,...n,t]),this.critic=new us([e,...n,1]),this.length=this.actor.length+this.critic.length,this.parameters=new Float32Array(this.length),this.actorParameters=this.parameters.subarray(0,this.actor.length),this.criticParameters=this.parameters.subarray(this.actor.length)}static of(e){return new i(e.observation.length,e.out.action.length)}initialize(e){this.actor.initialize(this.actorParameters,e,.01),this.critic.initialize(this.criticParameters,e,1)}setNoise(e){let[t,n,r]=Ru;this.logStd=t+(n-t)*Math.min(1,e/r)}mean(e,t){return this.actor.forward(this.actorParameters,e,t)}value(e,t){return this.critic.forward(this.criticParameters,e,t)[0]}logDensity(e,t,n){let r=Math.exp(-2*this.logStd),a=0;for(let l=0;l<this.actions;l++)a-=.5*r*(t[n+l]-e[l])**2;return a-this.actions*this.logStd}addGradient(e,t,n){let{actor:r,critic:a,actions:l,observations:c,length:f}=this,u=Math.exp(-2*this.logStd),m=e.subarray(0,r.length),v=e.subarray(r.length,f),g=new Float64Array(l),y=new Float64Array(1);for(let M of n){let A=t.advantages[M],S=this.mean(t.observations,M*c),_=this.logDensity(S,t.actions,M*l)-t.logDensities[M],P=Math.exp(_);if(A>0?P<1+Cu:P>1-Cu){for(let U=0;U<l;U++)g[U]=-P*A*u*(t.actions[M*l+U]-S[U]);r.backward(this.actorParameters,m,g)}y[0]=this.value(t.observations,M*c)-t.returns[M],a.backward(this.criticParameters,v,y),e[f]+=P-1-_}e[f+1]+=n.length}};var ev=2*Math.PI,za=class{constructor(e){Object.assign(this,{learning:e,inputs:{}}),this.act=null,this.observation=new Float32Array(e.observations.reduce((t,{width:n})=>t+n,0)),this.out={action:new Float32Array(e.stance.length),joint_target:new Float32Array(e.stance.length),next_gait_phase:new Float32Array(1)}}observe(e){let{observations:t,stance:n}=this.learning,r=e.gait_phase[0],a=0;for(let{name:l,width:c,scale:f,low:u,high:m}of t){let v=l==="gait_clock"?[Math.sin(r),Math.cos(r)]:e[l];for(let g=0;g<c;g++){let y=(l==="joint_position"?v[g]-n[g]:v[g])*(f[g]??f);this.observation[a++]=Math.min(m,Math.max(u,y))}}return this.observation}run(e){let{phases:t,sine:n,cosine:r,offset:a,low:l,high:c,scale:f,phase_step:u}=this.learning,{action:m,joint_target:v,next_gait_phase:g}=this.out,y=this.act(this.observe(e));g[0]=(e.gait_phase[0]+u)%ev;for(let M=0;M<v.length;M++){m[M]=Math.min(1,Math.max(-1,y[M]));let A=g[0]+t[M],S=a[M]+n[M]*Math.sin(A)+r[M]*Math.cos(A)+f*m[M];v[M]=Math.min(c[M],Math.max(l[M],S))}return this.out}};var ds=(i=navigator.hardwareConcurrency??2)=>Math.max(1,Math.min(8,i-1)),Ga=class{constructor(e,t,{terrains:n,robot:r,control:a,learning:l},c,f,u=ds()){Object.assign(this,{settings:c,paused:!1});let m=URL.createObjectURL(new Blob([e],{type:"text/javascript"}));this.workers=Array.from({length:u},()=>new Worker(m));let v=this.workers.map(()=>Array(u).fill(null));for(let y=0;y<u;y++)for(let M=0;M<y;M++){let{port1:A,port2:S}=new MessageChannel;[v[y][M],v[M][y]]=[A,S]}let g=n.filter(({heights:y})=>!y).slice(0,1);this.workers.forEach((y,M)=>{y.onmessage=({data:S})=>f(S),y.onerror=({message:S})=>f({error:S??"a worker does not start"});let A={terrains:g,robot:r,control:a,learning:l};y.postMessage({wasm:t,content:A,settings:c,ports:v[M]},v[M].filter(Boolean))})}set(e){Object.assign(this.settings,e),this.send()}setPaused(e){this.paused=e,this.send()}send(){for(let e of this.workers)e.postMessage({settings:this.settings,paused:this.paused})}stop(){for(let e of this.workers)e.terminate()}};var fn=i=>document.getElementById(i),dc={seconds:4,tolerance:.05},tv=.6,fs={speed:"#0072b2",reward:"#009e73",zero:"#8a94a0",text:"#57616d"},Va=class{constructor(e,t,n){let{learning:r}=e.walk.content;if(Object.assign(this,{page:e,source:t,wasm:n,school:null,policy:null}),fn("learn").hidden=!r,!r)return;this.policy=new za(r),this.agent=ka.of(this.policy),this.policy.act=u=>this.agent.mean(u),this.clear();let{unit:a,command:l,weights:c}=r,[,f]=e.walk.content.control.forward;this.sliders={learn_speed:[f/6,f,f/12,l[0],u=>`${u.toFixed(2)} m/s`],learn_lift:[0,2,.1,1,u=>`${(u*c.gait_clock).toFixed(0)}`],learn_smooth:[0,10,.5,1,u=>`${(u*c.action_rate).toFixed(1)}`]};for(let[u,[m,v,g,y,M]]of Object.entries(this.sliders)){let A=fn(u),S=A.closest("label").querySelector("output");Object.assign(A,{min:m,max:v,step:g,value:y}),S.textContent=M(A.valueAsNumber),A.addEventListener("input",()=>{S.textContent=M(A.valueAsNumber),this.change()})}fn("learn_turn").addEventListener("change",()=>this.change()),fn("learn_go").addEventListener("click",()=>this.go()),fn("learn_again").addEventListener("click",()=>this.stop()),this.tolerance=dc.tolerance*a[0]}clear(){Object.assign(this,{results:[],seconds:0,since:null,reached:null,average:0,error:null})}settings(){let{weights:e}=this.policy.learning,{control:t}=this.page.walk.content;return{command:[fn("learn_speed").valueAsNumber,0],turns:fn("learn_turn").checked?tv*t.turn[1]:null,weights:{...e,gait_clock:e.gait_clock*fn("learn_lift").valueAsNumber,action_rate:e.action_rate*fn("learn_smooth").valueAsNumber}}}change(){let e=this.settings();this.school?.set(e),this.school&&this.page.learned(this.policy,e)}go(){this.school?(this.tick(),this.school.setPaused(!this.school.paused)):(this.clear(),this.agent.parameters.fill(0),this.school=new Ga(this.source,this.wasm,this.page.walk.content,{seed:0,...this.settings()},e=>this.take(e)),this.page.learned(this.policy,this.settings())),this.since=this.school.paused||!this.results.length?null:performance.now(),this.translate()}stop(){this.school?.stop(),this.school=null,this.clear(),this.page.learned(null),this.translate()}take(e){if(e.error)return this.error=e.error,this.school.stop(),this.translate();this.results.length?this.tick():this.since=performance.now(),this.results.push({...e,actor:null,seconds:this.seconds}),this.agent.actorParameters.set(e.actor),this.translate()}tick(){let e=performance.now();this.since!==null&&(this.seconds+=(e-this.since)/1e3),this.since=this.school?.paused?null:e}watch(e,t){if(!this.school||this.reached!==null)return;let n=t/(dc.seconds/4),r=e.command[0];this.average+=n*(e.speed-this.average);let a=Math.abs(this.average-r)<this.tolerance&&Math.abs(e.rate)<2*this.tolerance;this.kept=a&&!e.downFor?(this.kept??0)+t:0,this.kept>dc.seconds&&(this.reached=this.seconds,this.translate())}translate(){if(!this.policy)return;let{page:{language:e},school:t,results:n}=this,r=(c,...f)=>Pn(e,c,...f);fn("learn_go").textContent=r(t?t.paused?"learn_continue":"learn_pause":"learn_start"),fn("learn_again").hidden=!t,fn("learn_curve").hidden=fn("learn_numbers").hidden=!n.length;let a=n.at(-1),l=n[0];fn("learn_state").textContent=this.error?r("failed",this.error):!t||t.paused?r("learn_workers",ds()):a?this.reached!==null?r("learn_reached",this.reached.toFixed(0),t.settings.command[0].toFixed(2)):r("learn_running",ds()):r("learn_starting",ds()),a&&(fn("learn_numbers").textContent=r("learn_numbers",this.seconds.toFixed(0),a.steps.toLocaleString(e),(a.steps/Math.max(1,this.seconds)).toFixed(0),a.noise.toFixed(2)),this.draw([{name:r("learn_curve_speed"),values:n.map(({speed:c})=>c),zero:l.speed,goal:t.settings.command[0],colour:fs.speed},{name:r("learn_curve_reward"),values:n.map(({reward:c})=>c),zero:l.reward,colour:fs.reward}],r("learn_zero")))}draw(e,t){let n=fn("learn_curve"),r=devicePixelRatio||1,a=n.clientWidth,l=n.clientHeight;[n.width,n.height]=[a*r,l*r].map(Math.round);let c=n.getContext("2d"),f=l/e.length,u=34,m=Math.max(60,this.seconds);c.setTransform(r,0,0,r,0,0),c.font="11px system-ui, sans-serif",e.forEach(({name:v,values:g,zero:y,goal:M,colour:A},S)=>{let _=[...g,y,M??y],P=Math.min(0,..._),U=Math.max(..._)*1.1,I=S*f+16,O=(S+1)*f-14,N=X=>u+(a-u-4)*X/m,w=X=>O-(O-I)*(X-P)/(U-P),D=(X,k,Y,Z)=>{c.strokeStyle=c.fillStyle=Z,c.setLineDash(Y),c.beginPath(),c.moveTo(u,w(X)),c.lineTo(a-4,w(X)),c.stroke(),c.fillText(k,0,w(X)+4)};c.lineWidth=1,D(y,y.toFixed(y<1?2:0),[4,3],fs.zero),M!==void 0&&D(M,M.toFixed(2),[1,2],A),c.fillStyle=fs.zero,c.textAlign="right",S===0&&c.fillText(t,a-4,11),c.textAlign="left",c.setLineDash([]),c.strokeStyle=c.fillStyle=A,c.lineWidth=2,c.beginPath(),g.forEach((X,k)=>c.lineTo(N(this.results[k].seconds),w(X))),c.stroke(),c.fillText(v,u,S*f+11)}),c.fillStyle=fs.text,c.fillText("0 s",u,l-2),c.textAlign="right",c.fillText(`${m.toFixed(0)} s`,a-4,l-2)}};var Ni=i=>(e,t)=>{let n=new Float32Array(Math.max(e.length,t.length)),[r,a]=[e.length>1?1:0,t.length>1?1:0];return[n,()=>{for(let l=0;l<n.length;l++)n[l]=i(e[r*l],t[a*l])}]},Sn=i=>e=>{let t=new Float32Array(e.length);return[t,()=>{for(let n=0;n<t.length;n++)t[n]=i(e[n])}]},Pu=(i,e,t)=>{let n=i.length,r=e.length/n,a=new Float32Array(r),l=new Float64Array(r);return[a,()=>{t?l.set(t):l.fill(0);for(let c=0,f=0;c<n;c++){let u=i[c];for(let m=0;m<r;m++,f++)l[m]+=u*e[f]}a.set(l)}]},nv=i=>1/(1+Math.exp(-i)),iv=i=>Math.max(i,0)+Math.log1p(Math.exp(-Math.abs(i))),rv=i=>{let e=1/(1+.3275911*Math.abs(i)),t=e*(.254829592+e*(-.284496736+e*(1.421413741+e*(-1.453152027+e*1.061405429))));return Math.sign(i)*(1-t*Math.exp(-i*i))},Iu={Add:Ni((i,e)=>i+e),Sub:Ni((i,e)=>i-e),Mul:Ni((i,e)=>i*e),Div:Ni((i,e)=>i/e),Max:Ni(Math.max),Min:Ni(Math.min),Mod:Ni((i,e)=>i%e),Greater:Ni((i,e)=>+(i>e)),Abs:Sn(Math.abs),Sign:Sn(Math.sign),Sqrt:Sn(Math.sqrt),Sin:Sn(Math.sin),Cos:Sn(Math.cos),Tanh:Sn(Math.tanh),Erf:Sn(rv),Sigmoid:Sn(nv),Softplus:Sn(iv),Relu:Sn(i=>Math.max(i,0)),LeakyRelu:Sn(i=>i<0?.01*i:i),Elu:Sn(i=>i<0?Math.expm1(i):i),Selu:Sn(i=>1.0507009873554805*(i<0?1.6732632423543772*Math.expm1(i):i)),Cast:Sn(i=>i),IsNaN:Sn(i=>Number(Number.isNaN(i))),MatMul:Pu,Gemm:Pu,Concat:(...i)=>{let e=new Float32Array(i.reduce((t,n)=>t+n.length,0));return[e,()=>{let t=0;for(let n of i)e.set(n,t),t+=n.length}]},Where:(i,e,t)=>{let n=new Float32Array(i.length);return[n,()=>{for(let r=0;r<n.length;r++)n[r]=i[r]?e[r]:t[r]}]},Slice:(i,[e],[t])=>{let n=new Float32Array(t-e);return[n,()=>n.set(i.subarray(e,t))]}},Jw=Object.keys(Iu);function sv(i){return new Float32Array(Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer)}var Ui=class{constructor({nodes:e,constants:t,inputs:n,outputs:r}){this.inputs=Object.fromEntries(Object.entries(n).map(([a,l])=>[a,new Float32Array(l)])),this.outputs=r,this.values={...this.inputs};for(let[a,l]of Object.entries(t))this.values[a]=sv(l);this.steps=e.map(([a,l,c])=>{let[f,u]=Iu[a](...l.map(m=>this.values[m]));return this.values[c]=f,[u,c,f]})}run(e,t={}){for(let[n,r]of Object.entries(this.inputs))r.set(e[n]);for(let[n,r,a]of this.steps)if(n(),t[r]!==void 0)for(let l=0;l<a.length;l++)a[l]*=t[r];return Object.fromEntries(this.outputs.map(n=>[n,this.values[n]]))}};var av=(async function(i={}){var e,t=i,n=typeof window=="object",r=typeof WorkerGlobalScope<"u",a=typeof process=="object"&&process.versions?.node&&process.type!="renderer",l=!n&&!a&&!r;if(a){let{createRequire:s}=await import("module");var c=s(import.meta.url)}var f=[],u="./this.program",m=(s,o)=>{throw o},v=import.meta.url,g="";function y(s){return t.locateFile?t.locateFile(s,g):g+s}var M,A;if(a){if(!(typeof process=="object"&&process.versions?.node&&process.type!="renderer"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");var S=process.versions.node,_=S.split(".").slice(0,3);if(_=_[0]*1e4+_[1]*100+_[2].split("-")[0]*1,_<16e4)throw new Error("This emscripten-generated code requires node v16.0.0 (detected v"+S+")");var P=c("fs");v.startsWith("file:")&&(g=c("path").dirname(c("url").fileURLToPath(v))+"/"),A=o=>{o=ne(o)?new URL(o):o;var h=P.readFileSync(o);return G(Buffer.isBuffer(h)),h},M=async(o,h=!0)=>{o=ne(o)?new URL(o):o;var d=P.readFileSync(o,h?void 0:"utf8");return G(h?Buffer.isBuffer(d):typeof d=="string"),d},process.argv.length>1&&(u=process.argv[1].replace(/\\/g,"/")),f=process.argv.slice(2),m=(o,h)=>{throw process.exitCode=o,h}}else if(l){if(typeof process=="object"&&process.versions?.node&&process.type!="renderer"||typeof window=="object"||typeof WorkerGlobalScope<"u")throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)")}else if(n||r){try{g=new URL(".",v).href}catch{}if(!(typeof window=="object"||typeof WorkerGlobalScope<"u"))throw new Error("not compiled for this environment (did you build to HTML and try to run it not on the web, or set ENVIRONMENT to something - like node - and run it someplace else - like on the web?)");r&&(A=s=>{var o=new XMLHttpRequest;return o.open("GET",s,!1),o.responseType="arraybuffer",o.send(null),new Uint8Array(o.response)}),M=async s=>{if(ne(s))return new Promise((h,d)=>{var p=new XMLHttpRequest;p.open("GET",s,!0),p.responseType="arraybuffer",p.onload=()=>{if(p.status==200||p.status==0&&p.response){h(p.response);return}d(p.status)},p.onerror=d,p.send(null)});var o=await fetch(s,{credentials:"same-origin"});if(o.ok)return o.arrayBuffer();throw new Error(o.status+" : "+o.url)}}else throw new Error("environment detection error");var U=console.log.bind(console),I=console.error.bind(console),O="IDBFS is no longer included by default; build with -lidbfs.js",N="PROXYFS is no longer included by default; build with -lproxyfs.js",w="WORKERFS is no longer included by default; build with -lworkerfs.js",D="FETCHFS is no longer included by default; build with -lfetchfs.js",X="ICASEFS is no longer included by default; build with -licasefs.js",k="JSFILEFS is no longer included by default; build with -ljsfilefs.js",Y="OPFS is no longer included by default; build with -lopfs.js",Z="NODEFS is no longer included by default; build with -lnodefs.js";G(!l,"shell environment detected but not enabled at build time.  Add `shell` to `-sENVIRONMENT` to enable.");var ee;typeof WebAssembly!="object"&&I("no native wasm support detected");var z=!1,ie;function G(s,o){s||pe("Assertion failed"+(o?": "+o:""))}var ne=s=>s.startsWith("file://");function Se(){var s=sc();G((s&3)==0),s==0&&(s+=4),$e[s>>2]=34821223,$e[s+4>>2]=2310721022,$e[0]=1668509029}function re(){if(!z){var s=sc();s==0&&(s+=4);var o=$e[s>>2],h=$e[s+4>>2];(o!=34821223||h!=2310721022)&&pe(`Stack overflow! Stack cookie has been overwritten at ${Bt(s)}, expected hex dwords 0x89BACDFE and 0x2135467, but received ${Bt(h)} ${Bt(o)}`),$e[0]!=1668509029&&pe("Runtime error: The application has corrupted its heap memory area (address zero)!")}}class H extends Error{}class ge extends H{}class We extends H{constructor(o){super(o),this.excPtr=o;let h=fu(o);this.name=h[0],this.message=h[1]}}var rt=!0;function ue(...s){!rt&&typeof rt<"u"||console.warn(...s)}(()=>{var s=new Int16Array(1),o=new Int8Array(s.buffer);if(s[0]=25459,o[0]!==115||o[1]!==99)throw"Runtime error: expected the system to be little-endian! (Run with -sSUPPORT_BIG_ENDIAN to bypass)"})();function Fe(s){Object.getOwnPropertyDescriptor(t,s)||Object.defineProperty(t,s,{configurable:!0,set(){pe(`Attempt to set \`Module.${s}\` after it has already been processed.  This can happen, for example, when code is injected via '--post-js' rather than '--pre-js'`)}})}function Pe(s){return()=>G(!1,`call to '${s}' via reference taken before Wasm module initialization`)}function Ze(s){Object.getOwnPropertyDescriptor(t,s)&&pe(`\`Module.${s}\` was supplied but \`${s}\` not included in INCOMING_MODULE_JS_API`)}function Ue(s){return s==="FS_createPath"||s==="FS_createDataFile"||s==="FS_createPreloadedFile"||s==="FS_unlink"||s==="addRunDependency"||s==="FS_createLazyFile"||s==="FS_createDevice"||s==="removeRunDependency"}function ot(s,o){typeof globalThis<"u"&&!Object.getOwnPropertyDescriptor(globalThis,s)&&Object.defineProperty(globalThis,s,{configurable:!0,get(){o()}})}function Vt(s,o){ot(s,()=>{ei(`\`${s}\` is not longer defined by emscripten. ${o}`)})}Vt("buffer","Please use HEAP8.buffer or wasmMemory.buffer"),Vt("asm","Please use wasmExports instead");function Qe(s){ot(s,()=>{var o=`\`${s}\` is a library symbol and not included by default; add it to your library.js __deps or to DEFAULT_LIBRARY_FUNCS_TO_INCLUDE on the command line`,h=s;h.startsWith("_")||(h="$"+s),o+=` (e.g. -sDEFAULT_LIBRARY_FUNCS_TO_INCLUDE='${h}')`,Ue(s)&&(o+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),ei(o)}),Et(s)}function Et(s){Object.getOwnPropertyDescriptor(t,s)||Object.defineProperty(t,s,{configurable:!0,get(){var o=`'${s}' was not exported. add it to EXPORTED_RUNTIME_METHODS (see the Emscripten FAQ)`;Ue(s)&&(o+=". Alternatively, forcing filesystem support (-sFORCE_FILESYSTEM) can export this for you"),pe(o)}})}var Ct,mt,Ht,pt,It,Mt,rn,De,$e,hn,sn,W,yn,Rt=!1;function Ut(){var s=Ht.buffer;pt=new Int8Array(s),Mt=new Int16Array(s),It=new Uint8Array(s),rn=new Uint16Array(s),De=new Int32Array(s),$e=new Uint32Array(s),hn=new Float32Array(s),sn=new Float64Array(s),W=new BigInt64Array(s),yn=new BigUint64Array(s)}G(typeof Int32Array<"u"&&typeof Float64Array<"u"&&Int32Array.prototype.subarray!=null&&Int32Array.prototype.set!=null,"JS engine does not provide full typed array support");function Le(){if(t.preRun)for(typeof t.preRun=="function"&&(t.preRun=[t.preRun]);t.preRun.length;)dt(t.preRun.shift());Fe("preRun"),Xe(qe)}function $t(){G(!Rt),Rt=!0,re(),!t.noFSInit&&!b.initialized&&b.init(),lt.init(),ar.__wasm_call_ctors(),b.ignorePermissions=!1}function Je(){if(re(),t.postRun)for(typeof t.postRun=="function"&&(t.postRun=[t.postRun]);t.postRun.length;)we(t.postRun.shift());Fe("postRun"),Xe(ut)}var Ke=0,L=null,T={},J=null;function ve(s){Ke++,t.monitorRunDependencies?.(Ke),s?(G(!T[s]),T[s]=1,J===null&&typeof setInterval<"u"&&(J=setInterval(()=>{if(z){clearInterval(J),J=null;return}var o=!1;for(var h in T)o||(o=!0,I("still waiting on run dependencies:")),I(`dependency: ${h}`);o&&I("(end of list)")},1e4))):I("warning: run dependency added without ID")}function de(s){if(Ke--,t.monitorRunDependencies?.(Ke),s?(G(T[s]),delete T[s]):I("warning: run dependency removed without ID"),Ke==0&&(J!==null&&(clearInterval(J),J=null),L)){var o=L;L=null,o()}}function pe(s){t.onAbort?.(s),s="Aborted("+s+")",I(s),z=!0;var o=new WebAssembly.RuntimeError(s);throw mt?.(o),o}function Me(s,o){return(...h)=>{G(Rt,`native function \`${s}\` called before runtime initialization`);var d=ar[s];return G(d,`exported native function \`${s}\` not found`),G(h.length<=o,`native function \`${s}\` called with ${h.length} args but expects ${o}`),d(...h)}}var ae;function le(){return t.locateFile?y("mujoco.wasm"):new URL("mujoco.wasm",import.meta.url).href}function Ce(s){if(s==ae&&ee)return new Uint8Array(ee);if(A)return A(s);throw"both async and sync fetching of the wasm failed"}async function B(s){if(!ee)try{var o=await M(s);return new Uint8Array(o)}catch{}return Ce(s)}async function he(s,o){try{var h=await B(s),d=await WebAssembly.instantiate(h,o);return d}catch(p){I(`failed to asynchronously prepare wasm: ${p}`),ne(ae)&&I(`warning: Loading from a file URI (${ae}) is not supported in most browsers. See https://emscripten.org/docs/getting_started/FAQ.html#how-do-i-run-a-local-webserver-for-testing-why-does-my-program-stall-in-downloading-or-preparing`),pe(p)}}async function se(s,o,h){if(!s&&typeof WebAssembly.instantiateStreaming=="function"&&!ne(o)&&!a)try{var d=fetch(o,{credentials:"same-origin"}),p=await WebAssembly.instantiateStreaming(d,h);return p}catch(x){I(`wasm streaming compile failed: ${x}`),I("falling back to ArrayBuffer instantiation")}return he(o,h)}function Re(){return{env:Eu,wasi_snapshot_preview1:Eu}}async function Ee(){function s(E,C){return ar=E.exports,Ht=ar.memory,G(Ht,"memory not found in wasm exports"),Ut(),Ca=ar.__indirect_function_table,G(Ca,"table not found in wasm exports"),Qm(ar),de("wasm-instantiate"),ar}ve("wasm-instantiate");var o=t;function h(E){return G(t===o,"the Module object should not be replaced during async compilation - perhaps the order of HTML elements is wrong?"),o=null,s(E.instance)}var d=Re();if(t.instantiateWasm)return new Promise((E,C)=>{try{t.instantiateWasm(d,(F,$)=>{E(s(F,$))})}catch(F){I(`Module.instantiateWasm callback failed with error: ${F}`),C(F)}});ae??=le();var p=await se(ee,ae,d),x=h(p);return x}class Ae{name="ExitStatus";constructor(o){this.message=`Program terminated with exit(${o})`,this.status=o}}var Xe=s=>{for(;s.length>0;)s.shift()(t)},ut=[],we=s=>ut.push(s),qe=[],dt=s=>qe.push(s);function Oe(s,o="i8"){switch(o.endsWith("*")&&(o="*"),o){case"i1":return pt[s];case"i8":return pt[s];case"i16":return Mt[s>>1];case"i32":return De[s>>2];case"i64":return W[s>>3];case"float":return hn[s>>2];case"double":return sn[s>>3];case"*":return $e[s>>2];default:pe(`invalid type for getValue: ${o}`)}}var Tt=!0,Bt=s=>(G(typeof s=="number"),s>>>=0,"0x"+s.toString(16).padStart(8,"0"));function vi(s,o,h="i8"){switch(h.endsWith("*")&&(h="*"),h){case"i1":pt[s]=o;break;case"i8":pt[s]=o;break;case"i16":Mt[s>>1]=o;break;case"i32":De[s>>2]=o;break;case"i64":W[s>>3]=BigInt(o);break;case"float":hn[s>>2]=o;break;case"double":sn[s>>3]=o;break;case"*":$e[s>>2]=o;break;default:pe(`invalid type for setValue: ${h}`)}}var ye=s=>yu(s),_e=()=>Su(),ei=s=>{ei.shown||={},ei.shown[s]||(ei.shown[s]=1,a&&(s="warning: "+s),I(s))},ss=typeof TextDecoder<"u"?new TextDecoder:void 0,yi=(s,o=0,h=NaN)=>{for(var d=o+h,p=o;s[p]&&!(p>=d);)++p;if(p-o>16&&s.buffer&&ss)return ss.decode(s.subarray(o,p));for(var x="";o<p;){var E=s[o++];if(!(E&128)){x+=String.fromCharCode(E);continue}var C=s[o++]&63;if((E&224)==192){x+=String.fromCharCode((E&31)<<6|C);continue}var F=s[o++]&63;if((E&240)==224?E=(E&15)<<12|C<<6|F:((E&248)!=240&&ei("Invalid UTF-8 leading byte "+Bt(E)+" encountered when deserializing a UTF-8 string in wasm memory to a JS string!"),E=(E&7)<<18|C<<12|F<<6|s[o++]&63),E<65536)x+=String.fromCharCode(E);else{var $=E-65536;x+=String.fromCharCode(55296|$>>10,56320|$&1023)}}return x},un=(s,o)=>(G(typeof s=="number",`UTF8ToString expects a number (got ${typeof s})`),s?yi(It,s,o):""),as=(s,o,h,d)=>pe(`Assertion failed: ${un(s)}, at: `+[o?un(o):"unknown filename",h,d?un(d):"unknown function"]),Un=[],Qi=0,xr=s=>{var o=new Sr(s);return o.get_caught()||(o.set_caught(!0),Qi--),o.set_rethrown(!1),Un.push(o),Ua(s),wu(s)},_a=()=>{if(!Un.length)return 0;var s=Un[Un.length-1];return Ua(s.excPtr),s.excPtr},On=0,er=()=>{xe(0,0),G(Un.length>0);var s=Un.pop();ac(s.excPtr),On=0};class Sr{constructor(o){this.excPtr=o,this.ptr=o-24}set_type(o){$e[this.ptr+4>>2]=o}get_type(){return $e[this.ptr+4>>2]}set_destructor(o){$e[this.ptr+8>>2]=o}get_destructor(){return $e[this.ptr+8>>2]}set_caught(o){o=o?1:0,pt[this.ptr+12]=o}get_caught(){return pt[this.ptr+12]!=0}set_rethrown(o){o=o?1:0,pt[this.ptr+13]=o}get_rethrown(){return pt[this.ptr+13]!=0}init(o,h){this.set_adjusted_ptr(0),this.set_type(o),this.set_destructor(h)}set_adjusted_ptr(o){$e[this.ptr+16>>2]=o}get_adjusted_ptr(){return $e[this.ptr+16>>2]}}var tr=s=>_u(s),Mr=s=>{var o=On?.excPtr;if(!o)return tr(0),0;var h=new Sr(o);h.set_adjusted_ptr(o);var d=h.get_type();if(!d)return tr(0),o;for(var p of s){if(p===0||p===d)break;var x=h.ptr+16;if(bu(p,d,x))return tr(p),o}return tr(d),o},Wl=()=>Mr([]),Xl=s=>Mr([s]),$l=(s,o)=>Mr([s,o]),os=()=>{var s=Un.pop();s||pe("no exception to throw");var o=s.excPtr;throw s.get_rethrown()||(Un.push(s),s.set_rethrown(!0),s.set_caught(!1),Qi++),On=new We(o),On},R=s=>{if(s){var o=new Sr(s);Un.push(o),o.set_rethrown(!0),os()}},V=(s,o,h)=>{var d=new Sr(s);throw d.init(o,h),On=new We(s),Qi++,On},te=()=>Qi,K=s=>{throw On||(On=new We(s)),On},q={isAbs:s=>s.charAt(0)==="/",splitPath:s=>{var o=/^(\/?|)([\s\S]*?)((?:\.{1,2}|[^\/]+?|)(\.[^.\/]*|))(?:[\/]*)$/;return o.exec(s).slice(1)},normalizeArray:(s,o)=>{for(var h=0,d=s.length-1;d>=0;d--){var p=s[d];p==="."?s.splice(d,1):p===".."?(s.splice(d,1),h++):h&&(s.splice(d,1),h--)}if(o)for(;h;h--)s.unshift("..");return s},normalize:s=>{var o=q.isAbs(s),h=s.slice(-1)==="/";return s=q.normalizeArray(s.split("/").filter(d=>!!d),!o).join("/"),!s&&!o&&(s="."),s&&h&&(s+="/"),(o?"/":"")+s},dirname:s=>{var o=q.splitPath(s),h=o[0],d=o[1];return!h&&!d?".":(d&&(d=d.slice(0,-1)),h+d)},basename:s=>s&&s.match(/([^\/]+|\/)\/*$/)[1],join:(...s)=>q.normalize(s.join("/")),join2:(s,o)=>q.normalize(s+"/"+o)},Ie=()=>{if(a){var s=c("crypto");return o=>s.randomFillSync(o)}return o=>crypto.getRandomValues(o)},ze=s=>{(ze=Ie())(s)},Te={resolve:(...s)=>{for(var o="",h=!1,d=s.length-1;d>=-1&&!h;d--){var p=d>=0?s[d]:b.cwd();if(typeof p!="string")throw new TypeError("Arguments to path.resolve must be strings");if(!p)return"";o=p+"/"+o,h=q.isAbs(p)}return o=q.normalizeArray(o.split("/").filter(x=>!!x),!h).join("/"),(h?"/":"")+o||"."},relative:(s,o)=>{s=Te.resolve(s).slice(1),o=Te.resolve(o).slice(1);function h($){for(var Q=0;Q<$.length&&$[Q]==="";Q++);for(var oe=$.length-1;oe>=0&&$[oe]==="";oe--);return Q>oe?[]:$.slice(Q,oe-Q+1)}for(var d=h(s.split("/")),p=h(o.split("/")),x=Math.min(d.length,p.length),E=x,C=0;C<x;C++)if(d[C]!==p[C]){E=C;break}for(var F=[],C=E;C<d.length;C++)F.push("..");return F=F.concat(p.slice(E)),F.join("/")}},Ne=[],Ge=s=>{for(var o=0,h=0;h<s.length;++h){var d=s.charCodeAt(h);d<=127?o++:d<=2047?o+=2:d>=55296&&d<=57343?(o+=4,++h):o+=3}return o},st=(s,o,h,d)=>{if(G(typeof s=="string",`stringToUTF8Array expects a string (got ${typeof s})`),!(d>0))return 0;for(var p=h,x=h+d-1,E=0;E<s.length;++E){var C=s.codePointAt(E);if(C<=127){if(h>=x)break;o[h++]=C}else if(C<=2047){if(h+1>=x)break;o[h++]=192|C>>6,o[h++]=128|C&63}else if(C<=65535){if(h+2>=x)break;o[h++]=224|C>>12,o[h++]=128|C>>6&63,o[h++]=128|C&63}else{if(h+3>=x)break;C>1114111&&ei("Invalid Unicode code point "+Bt(C)+" encountered when serializing a JS string to a UTF-8 string in wasm memory! (Valid unicode code points should be in range 0-0x10FFFF)."),o[h++]=240|C>>18,o[h++]=128|C>>12&63,o[h++]=128|C>>6&63,o[h++]=128|C&63,E++}}return o[h]=0,h-p},gt=(s,o,h)=>{var d=h>0?h:Ge(s)+1,p=new Array(d),x=st(s,p,0,p.length);return o&&(p.length=x),p},Ve=()=>{if(!Ne.length){var s=null;if(a){var o=256,h=Buffer.alloc(o),d=0,p=process.stdin.fd;try{d=P.readSync(p,h,0,o)}catch(x){if(x.toString().includes("EOF"))d=0;else throw x}d>0&&(s=h.slice(0,d).toString("utf-8"))}else typeof window<"u"&&typeof window.prompt=="function"&&(s=window.prompt("Input: "),s!==null&&(s+=`
`));if(!s)return null;Ne=gt(s,!0)}return Ne.shift()},lt={ttys:[],init(){},shutdown(){},register(s,o){lt.ttys[s]={input:[],output:[],ops:o},b.registerDevice(s,lt.stream_ops)},stream_ops:{open(s){var o=lt.ttys[s.node.rdev];if(!o)throw new b.ErrnoError(43);s.tty=o,s.seekable=!1},close(s){s.tty.ops.fsync(s.tty)},fsync(s){s.tty.ops.fsync(s.tty)},read(s,o,h,d,p){if(!s.tty||!s.tty.ops.get_char)throw new b.ErrnoError(60);for(var x=0,E=0;E<d;E++){var C;try{C=s.tty.ops.get_char(s.tty)}catch{throw new b.ErrnoError(29)}if(C===void 0&&x===0)throw new b.ErrnoError(6);if(C==null)break;x++,o[h+E]=C}return x&&(s.node.atime=Date.now()),x},write(s,o,h,d,p){if(!s.tty||!s.tty.ops.put_char)throw new b.ErrnoError(60);try{for(var x=0;x<d;x++)s.tty.ops.put_char(s.tty,o[h+x])}catch{throw new b.ErrnoError(29)}return d&&(s.node.mtime=s.node.ctime=Date.now()),x}},default_tty_ops:{get_char(s){return Ve()},put_char(s,o){o===null||o===10?(U(yi(s.output)),s.output=[]):o!=0&&s.output.push(o)},fsync(s){s.output?.length>0&&(U(yi(s.output)),s.output=[])},ioctl_tcgets(s){return{c_iflag:25856,c_oflag:5,c_cflag:191,c_lflag:35387,c_cc:[3,28,127,21,4,0,1,0,17,19,26,0,18,15,23,22,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}},ioctl_tcsets(s,o,h){return 0},ioctl_tiocgwinsz(s){return[24,80]}},default_tty1_ops:{put_char(s,o){o===null||o===10?(I(yi(s.output)),s.output=[]):o!=0&&s.output.push(o)},fsync(s){s.output?.length>0&&(I(yi(s.output)),s.output=[])}}},Wt=s=>{pe("internal error: mmapAlloc called but `emscripten_builtin_memalign` native symbol not exported")},ke={ops_table:null,mount(s){return ke.createNode(null,"/",16895,0)},createNode(s,o,h,d){if(b.isBlkdev(h)||b.isFIFO(h))throw new b.ErrnoError(63);ke.ops_table||={dir:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,lookup:ke.node_ops.lookup,mknod:ke.node_ops.mknod,rename:ke.node_ops.rename,unlink:ke.node_ops.unlink,rmdir:ke.node_ops.rmdir,readdir:ke.node_ops.readdir,symlink:ke.node_ops.symlink},stream:{llseek:ke.stream_ops.llseek}},file:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:{llseek:ke.stream_ops.llseek,read:ke.stream_ops.read,write:ke.stream_ops.write,mmap:ke.stream_ops.mmap,msync:ke.stream_ops.msync}},link:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr,readlink:ke.node_ops.readlink},stream:{}},chrdev:{node:{getattr:ke.node_ops.getattr,setattr:ke.node_ops.setattr},stream:b.chrdev_stream_ops}};var p=b.createNode(s,o,h,d);return b.isDir(p.mode)?(p.node_ops=ke.ops_table.dir.node,p.stream_ops=ke.ops_table.dir.stream,p.contents={}):b.isFile(p.mode)?(p.node_ops=ke.ops_table.file.node,p.stream_ops=ke.ops_table.file.stream,p.usedBytes=0,p.contents=null):b.isLink(p.mode)?(p.node_ops=ke.ops_table.link.node,p.stream_ops=ke.ops_table.link.stream):b.isChrdev(p.mode)&&(p.node_ops=ke.ops_table.chrdev.node,p.stream_ops=ke.ops_table.chrdev.stream),p.atime=p.mtime=p.ctime=Date.now(),s&&(s.contents[o]=p,s.atime=s.mtime=s.ctime=p.atime),p},getFileDataAsTypedArray(s){return s.contents?s.contents.subarray?s.contents.subarray(0,s.usedBytes):new Uint8Array(s.contents):new Uint8Array(0)},expandFileStorage(s,o){var h=s.contents?s.contents.length:0;if(!(h>=o)){var d=1024*1024;o=Math.max(o,h*(h<d?2:1.125)>>>0),h!=0&&(o=Math.max(o,256));var p=s.contents;s.contents=new Uint8Array(o),s.usedBytes>0&&s.contents.set(p.subarray(0,s.usedBytes),0)}},resizeFileStorage(s,o){if(s.usedBytes!=o)if(o==0)s.contents=null,s.usedBytes=0;else{var h=s.contents;s.contents=new Uint8Array(o),h&&s.contents.set(h.subarray(0,Math.min(o,s.usedBytes))),s.usedBytes=o}},node_ops:{getattr(s){var o={};return o.dev=b.isChrdev(s.mode)?s.id:1,o.ino=s.id,o.mode=s.mode,o.nlink=1,o.uid=0,o.gid=0,o.rdev=s.rdev,b.isDir(s.mode)?o.size=4096:b.isFile(s.mode)?o.size=s.usedBytes:b.isLink(s.mode)?o.size=s.link.length:o.size=0,o.atime=new Date(s.atime),o.mtime=new Date(s.mtime),o.ctime=new Date(s.ctime),o.blksize=4096,o.blocks=Math.ceil(o.size/o.blksize),o},setattr(s,o){for(let h of["mode","atime","mtime","ctime"])o[h]!=null&&(s[h]=o[h]);o.size!==void 0&&ke.resizeFileStorage(s,o.size)},lookup(s,o){throw new b.ErrnoError(44)},mknod(s,o,h,d){return ke.createNode(s,o,h,d)},rename(s,o,h){var d;try{d=b.lookupNode(o,h)}catch{}if(d){if(b.isDir(s.mode))for(var p in d.contents)throw new b.ErrnoError(55);b.hashRemoveNode(d)}delete s.parent.contents[s.name],o.contents[h]=s,s.name=h,o.ctime=o.mtime=s.parent.ctime=s.parent.mtime=Date.now()},unlink(s,o){delete s.contents[o],s.ctime=s.mtime=Date.now()},rmdir(s,o){var h=b.lookupNode(s,o);for(var d in h.contents)throw new b.ErrnoError(55);delete s.contents[o],s.ctime=s.mtime=Date.now()},readdir(s){return[".","..",...Object.keys(s.contents)]},symlink(s,o,h){var d=ke.createNode(s,o,41471,0);return d.link=h,d},readlink(s){if(!b.isLink(s.mode))throw new b.ErrnoError(28);return s.link}},stream_ops:{read(s,o,h,d,p){var x=s.node.contents;if(p>=s.node.usedBytes)return 0;var E=Math.min(s.node.usedBytes-p,d);if(G(E>=0),E>8&&x.subarray)o.set(x.subarray(p,p+E),h);else for(var C=0;C<E;C++)o[h+C]=x[p+C];return E},write(s,o,h,d,p,x){if(G(!(o instanceof ArrayBuffer)),o.buffer===pt.buffer&&(x=!1),!d)return 0;var E=s.node;if(E.mtime=E.ctime=Date.now(),o.subarray&&(!E.contents||E.contents.subarray)){if(x)return G(p===0,"canOwn must imply no weird position inside the file"),E.contents=o.subarray(h,h+d),E.usedBytes=d,d;if(E.usedBytes===0&&p===0)return E.contents=o.slice(h,h+d),E.usedBytes=d,d;if(p+d<=E.usedBytes)return E.contents.set(o.subarray(h,h+d),p),d}if(ke.expandFileStorage(E,p+d),E.contents.subarray&&o.subarray)E.contents.set(o.subarray(h,h+d),p);else for(var C=0;C<d;C++)E.contents[p+C]=o[h+C];return E.usedBytes=Math.max(E.usedBytes,p+d),d},llseek(s,o,h){var d=o;if(h===1?d+=s.position:h===2&&b.isFile(s.node.mode)&&(d+=s.node.usedBytes),d<0)throw new b.ErrnoError(28);return d},mmap(s,o,h,d,p){if(!b.isFile(s.node.mode))throw new b.ErrnoError(43);var x,E,C=s.node.contents;if(!(p&2)&&C&&C.buffer===pt.buffer)E=!1,x=C.byteOffset;else{if(E=!0,x=Wt(o),!x)throw new b.ErrnoError(48);C&&((h>0||h+o<C.length)&&(C.subarray?C=C.subarray(h,h+o):C=Array.prototype.slice.call(C,h,h+o)),pt.set(C,x))}return{ptr:x,allocated:E}},msync(s,o,h,d,p){return ke.stream_ops.write(s,o,0,d,h,!1),0}}},Dt=async s=>{var o=await M(s);return G(o,`Loading data file "${s}" failed (no arrayBuffer).`),new Uint8Array(o)},jt=(...s)=>b.createDataFile(...s),He=s=>{for(var o=s;;){if(!T[s])return s;s=o+Math.random()}},an=[],wt=(s,o,h,d)=>{typeof Browser<"u"&&Browser.init();var p=!1;return an.forEach(x=>{p||x.canHandle(o)&&(x.handle(s,o,h,d),p=!0)}),p},ti=(s,o,h,d,p,x,E,C,F,$)=>{var Q=o?Te.resolve(q.join2(s,o)):s,oe=He(`cp ${Q}`);function fe(ce){function me(Ye){$?.(),C||jt(s,o,Ye,d,p,F),x?.(),de(oe)}wt(ce,Q,me,()=>{E?.(),de(oe)})||me(ce)}ve(oe),typeof h=="string"?Dt(h).then(fe,E):fe(h)},on=s=>{var o={r:0,"r+":2,w:577,"w+":578,a:1089,"a+":1090},h=o[s];if(typeof h>"u")throw new Error(`Unknown file open mode: ${s}`);return h},Fi=(s,o)=>{var h=0;return s&&(h|=365),o&&(h|=146),h},ni=s=>un(gu(s)),ii={EPERM:63,ENOENT:44,ESRCH:71,EINTR:27,EIO:29,ENXIO:60,E2BIG:1,ENOEXEC:45,EBADF:8,ECHILD:12,EAGAIN:6,EWOULDBLOCK:6,ENOMEM:48,EACCES:2,EFAULT:21,ENOTBLK:105,EBUSY:10,EEXIST:20,EXDEV:75,ENODEV:43,ENOTDIR:54,EISDIR:31,EINVAL:28,ENFILE:41,EMFILE:33,ENOTTY:59,ETXTBSY:74,EFBIG:22,ENOSPC:51,ESPIPE:70,EROFS:69,EMLINK:34,EPIPE:64,EDOM:18,ERANGE:68,ENOMSG:49,EIDRM:24,ECHRNG:106,EL2NSYNC:156,EL3HLT:107,EL3RST:108,ELNRNG:109,EUNATCH:110,ENOCSI:111,EL2HLT:112,EDEADLK:16,ENOLCK:46,EBADE:113,EBADR:114,EXFULL:115,ENOANO:104,EBADRQC:103,EBADSLT:102,EDEADLOCK:16,EBFONT:101,ENOSTR:100,ENODATA:116,ETIME:117,ENOSR:118,ENONET:119,ENOPKG:120,EREMOTE:121,ENOLINK:47,EADV:122,ESRMNT:123,ECOMM:124,EPROTO:65,EMULTIHOP:36,EDOTDOT:125,EBADMSG:9,ENOTUNIQ:126,EBADFD:127,EREMCHG:128,ELIBACC:129,ELIBBAD:130,ELIBSCN:131,ELIBMAX:132,ELIBEXEC:133,ENOSYS:52,ENOTEMPTY:55,ENAMETOOLONG:37,ELOOP:32,EOPNOTSUPP:138,EPFNOSUPPORT:139,ECONNRESET:15,ENOBUFS:42,EAFNOSUPPORT:5,EPROTOTYPE:67,ENOTSOCK:57,ENOPROTOOPT:50,ESHUTDOWN:140,ECONNREFUSED:14,EADDRINUSE:3,ECONNABORTED:13,ENETUNREACH:40,ENETDOWN:38,ETIMEDOUT:73,EHOSTDOWN:142,EHOSTUNREACH:23,EINPROGRESS:26,EALREADY:7,EDESTADDRREQ:17,EMSGSIZE:35,EPROTONOSUPPORT:66,ESOCKTNOSUPPORT:137,EADDRNOTAVAIL:4,ENETRESET:39,EISCONN:30,ENOTCONN:53,ETOOMANYREFS:141,EUSERS:136,EDQUOT:19,ESTALE:72,ENOTSUP:138,ENOMEDIUM:148,EILSEQ:25,EOVERFLOW:61,ECANCELED:11,ENOTRECOVERABLE:56,EOWNERDEAD:62,ESTRPIPE:135},b={root:null,mounts:[],devices:{},streams:[],nextInode:1,nameTable:null,currentPath:"/",initialized:!1,ignorePermissions:!0,filesystems:null,syncFSRequests:0,readFiles:{},ErrnoError:class extends Error{name="ErrnoError";constructor(s){super(Rt?ni(s):""),this.errno=s;for(var o in ii)if(ii[o]===s){this.code=o;break}}},FSStream:class{shared={};get object(){return this.node}set object(s){this.node=s}get isRead(){return(this.flags&2097155)!==1}get isWrite(){return(this.flags&2097155)!==0}get isAppend(){return this.flags&1024}get flags(){return this.shared.flags}set flags(s){this.shared.flags=s}get position(){return this.shared.position}set position(s){this.shared.position=s}},FSNode:class{node_ops={};stream_ops={};readMode=365;writeMode=146;mounted=null;constructor(s,o,h,d){s||(s=this),this.parent=s,this.mount=s.mount,this.id=b.nextInode++,this.name=o,this.mode=h,this.rdev=d,this.atime=this.mtime=this.ctime=Date.now()}get read(){return(this.mode&this.readMode)===this.readMode}set read(s){s?this.mode|=this.readMode:this.mode&=~this.readMode}get write(){return(this.mode&this.writeMode)===this.writeMode}set write(s){s?this.mode|=this.writeMode:this.mode&=~this.writeMode}get isFolder(){return b.isDir(this.mode)}get isDevice(){return b.isChrdev(this.mode)}},lookupPath(s,o={}){if(!s)throw new b.ErrnoError(44);o.follow_mount??=!0,q.isAbs(s)||(s=b.cwd()+"/"+s);e:for(var h=0;h<40;h++){for(var d=s.split("/").filter($=>!!$),p=b.root,x="/",E=0;E<d.length;E++){var C=E===d.length-1;if(C&&o.parent)break;if(d[E]!=="."){if(d[E]===".."){if(x=q.dirname(x),b.isRoot(p)){s=x+"/"+d.slice(E+1).join("/");continue e}else p=p.parent;continue}x=q.join2(x,d[E]);try{p=b.lookupNode(p,d[E])}catch($){if($?.errno===44&&C&&o.noent_okay)return{path:x};throw $}if(b.isMountpoint(p)&&(!C||o.follow_mount)&&(p=p.mounted.root),b.isLink(p.mode)&&(!C||o.follow)){if(!p.node_ops.readlink)throw new b.ErrnoError(52);var F=p.node_ops.readlink(p);q.isAbs(F)||(F=q.dirname(x)+"/"+F),s=F+"/"+d.slice(E+1).join("/");continue e}}}return{path:x,node:p}}throw new b.ErrnoError(32)},getPath(s){for(var o;;){if(b.isRoot(s)){var h=s.mount.mountpoint;return o?h[h.length-1]!=="/"?`${h}/${o}`:h+o:h}o=o?`${s.name}/${o}`:s.name,s=s.parent}},hashName(s,o){for(var h=0,d=0;d<o.length;d++)h=(h<<5)-h+o.charCodeAt(d)|0;return(s+h>>>0)%b.nameTable.length},hashAddNode(s){var o=b.hashName(s.parent.id,s.name);s.name_next=b.nameTable[o],b.nameTable[o]=s},hashRemoveNode(s){var o=b.hashName(s.parent.id,s.name);if(b.nameTable[o]===s)b.nameTable[o]=s.name_next;else for(var h=b.nameTable[o];h;){if(h.name_next===s){h.name_next=s.name_next;break}h=h.name_next}},lookupNode(s,o){var h=b.mayLookup(s);if(h)throw new b.ErrnoError(h);for(var d=b.hashName(s.id,o),p=b.nameTable[d];p;p=p.name_next){var x=p.name;if(p.parent.id===s.id&&x===o)return p}return b.lookup(s,o)},createNode(s,o,h,d){G(typeof s=="object");var p=new b.FSNode(s,o,h,d);return b.hashAddNode(p),p},destroyNode(s){b.hashRemoveNode(s)},isRoot(s){return s===s.parent},isMountpoint(s){return!!s.mounted},isFile(s){return(s&61440)===32768},isDir(s){return(s&61440)===16384},isLink(s){return(s&61440)===40960},isChrdev(s){return(s&61440)===8192},isBlkdev(s){return(s&61440)===24576},isFIFO(s){return(s&61440)===4096},isSocket(s){return(s&49152)===49152},flagsToPermissionString(s){var o=["r","w","rw"][s&3];return s&512&&(o+="w"),o},nodePermissions(s,o){return b.ignorePermissions?0:o.includes("r")&&!(s.mode&292)||o.includes("w")&&!(s.mode&146)||o.includes("x")&&!(s.mode&73)?2:0},mayLookup(s){if(!b.isDir(s.mode))return 54;var o=b.nodePermissions(s,"x");return o||(s.node_ops.lookup?0:2)},mayCreate(s,o){if(!b.isDir(s.mode))return 54;try{var h=b.lookupNode(s,o);return 20}catch{}return b.nodePermissions(s,"wx")},mayDelete(s,o,h){var d;try{d=b.lookupNode(s,o)}catch(x){return x.errno}var p=b.nodePermissions(s,"wx");if(p)return p;if(h){if(!b.isDir(d.mode))return 54;if(b.isRoot(d)||b.getPath(d)===b.cwd())return 10}else if(b.isDir(d.mode))return 31;return 0},mayOpen(s,o){return s?b.isLink(s.mode)?32:b.isDir(s.mode)&&(b.flagsToPermissionString(o)!=="r"||o&576)?31:b.nodePermissions(s,b.flagsToPermissionString(o)):44},checkOpExists(s,o){if(!s)throw new b.ErrnoError(o);return s},MAX_OPEN_FDS:4096,nextfd(){for(var s=0;s<=b.MAX_OPEN_FDS;s++)if(!b.streams[s])return s;throw new b.ErrnoError(33)},getStreamChecked(s){var o=b.getStream(s);if(!o)throw new b.ErrnoError(8);return o},getStream:s=>b.streams[s],createStream(s,o=-1){return G(o>=-1),s=Object.assign(new b.FSStream,s),o==-1&&(o=b.nextfd()),s.fd=o,b.streams[o]=s,s},closeStream(s){b.streams[s]=null},dupStream(s,o=-1){var h=b.createStream(s,o);return h.stream_ops?.dup?.(h),h},doSetAttr(s,o,h){var d=s?.stream_ops.setattr,p=d?s:o;d??=o.node_ops.setattr,b.checkOpExists(d,63),d(p,h)},chrdev_stream_ops:{open(s){var o=b.getDevice(s.node.rdev);s.stream_ops=o.stream_ops,s.stream_ops.open?.(s)},llseek(){throw new b.ErrnoError(70)}},major:s=>s>>8,minor:s=>s&255,makedev:(s,o)=>s<<8|o,registerDevice(s,o){b.devices[s]={stream_ops:o}},getDevice:s=>b.devices[s],getMounts(s){for(var o=[],h=[s];h.length;){var d=h.pop();o.push(d),h.push(...d.mounts)}return o},syncfs(s,o){typeof s=="function"&&(o=s,s=!1),b.syncFSRequests++,b.syncFSRequests>1&&I(`warning: ${b.syncFSRequests} FS.syncfs operations in flight at once, probably just doing extra work`);var h=b.getMounts(b.root.mount),d=0;function p(E){return G(b.syncFSRequests>0),b.syncFSRequests--,o(E)}function x(E){if(E)return x.errored?void 0:(x.errored=!0,p(E));++d>=h.length&&p(null)}h.forEach(E=>{if(!E.type.syncfs)return x(null);E.type.syncfs(E,s,x)})},mount(s,o,h){if(typeof s=="string")throw s;var d=h==="/",p=!h,x;if(d&&b.root)throw new b.ErrnoError(10);if(!d&&!p){var E=b.lookupPath(h,{follow_mount:!1});if(h=E.path,x=E.node,b.isMountpoint(x))throw new b.ErrnoError(10);if(!b.isDir(x.mode))throw new b.ErrnoError(54)}var C={type:s,opts:o,mountpoint:h,mounts:[]},F=s.mount(C);return F.mount=C,C.root=F,d?b.root=F:x&&(x.mounted=C,x.mount&&x.mount.mounts.push(C)),F},unmount(s){var o=b.lookupPath(s,{follow_mount:!1});if(!b.isMountpoint(o.node))throw new b.ErrnoError(28);var h=o.node,d=h.mounted,p=b.getMounts(d);Object.keys(b.nameTable).forEach(E=>{for(var C=b.nameTable[E];C;){var F=C.name_next;p.includes(C.mount)&&b.destroyNode(C),C=F}}),h.mounted=null;var x=h.mount.mounts.indexOf(d);G(x!==-1),h.mount.mounts.splice(x,1)},lookup(s,o){return s.node_ops.lookup(s,o)},mknod(s,o,h){var d=b.lookupPath(s,{parent:!0}),p=d.node,x=q.basename(s);if(!x)throw new b.ErrnoError(28);if(x==="."||x==="..")throw new b.ErrnoError(20);var E=b.mayCreate(p,x);if(E)throw new b.ErrnoError(E);if(!p.node_ops.mknod)throw new b.ErrnoError(63);return p.node_ops.mknod(p,x,o,h)},statfs(s){return b.statfsNode(b.lookupPath(s,{follow:!0}).node)},statfsStream(s){return b.statfsNode(s.node)},statfsNode(s){var o={bsize:4096,frsize:4096,blocks:1e6,bfree:5e5,bavail:5e5,files:b.nextInode,ffree:b.nextInode-1,fsid:42,flags:2,namelen:255};return s.node_ops.statfs&&Object.assign(o,s.node_ops.statfs(s.mount.opts.root)),o},create(s,o=438){return o&=4095,o|=32768,b.mknod(s,o,0)},mkdir(s,o=511){return o&=1023,o|=16384,b.mknod(s,o,0)},mkdirTree(s,o){var h=s.split("/"),d="";for(var p of h)if(p){(d||q.isAbs(s))&&(d+="/"),d+=p;try{b.mkdir(d,o)}catch(x){if(x.errno!=20)throw x}}},mkdev(s,o,h){return typeof h>"u"&&(h=o,o=438),o|=8192,b.mknod(s,o,h)},symlink(s,o){if(!Te.resolve(s))throw new b.ErrnoError(44);var h=b.lookupPath(o,{parent:!0}),d=h.node;if(!d)throw new b.ErrnoError(44);var p=q.basename(o),x=b.mayCreate(d,p);if(x)throw new b.ErrnoError(x);if(!d.node_ops.symlink)throw new b.ErrnoError(63);return d.node_ops.symlink(d,p,s)},rename(s,o){var h=q.dirname(s),d=q.dirname(o),p=q.basename(s),x=q.basename(o),E,C,F;if(E=b.lookupPath(s,{parent:!0}),C=E.node,E=b.lookupPath(o,{parent:!0}),F=E.node,!C||!F)throw new b.ErrnoError(44);if(C.mount!==F.mount)throw new b.ErrnoError(75);var $=b.lookupNode(C,p),Q=Te.relative(s,d);if(Q.charAt(0)!==".")throw new b.ErrnoError(28);if(Q=Te.relative(o,h),Q.charAt(0)!==".")throw new b.ErrnoError(55);var oe;try{oe=b.lookupNode(F,x)}catch{}if($!==oe){var fe=b.isDir($.mode),ce=b.mayDelete(C,p,fe);if(ce)throw new b.ErrnoError(ce);if(ce=oe?b.mayDelete(F,x,fe):b.mayCreate(F,x),ce)throw new b.ErrnoError(ce);if(!C.node_ops.rename)throw new b.ErrnoError(63);if(b.isMountpoint($)||oe&&b.isMountpoint(oe))throw new b.ErrnoError(10);if(F!==C&&(ce=b.nodePermissions(C,"w"),ce))throw new b.ErrnoError(ce);b.hashRemoveNode($);try{C.node_ops.rename($,F,x),$.parent=F}catch(me){throw me}finally{b.hashAddNode($)}}},rmdir(s){var o=b.lookupPath(s,{parent:!0}),h=o.node,d=q.basename(s),p=b.lookupNode(h,d),x=b.mayDelete(h,d,!0);if(x)throw new b.ErrnoError(x);if(!h.node_ops.rmdir)throw new b.ErrnoError(63);if(b.isMountpoint(p))throw new b.ErrnoError(10);h.node_ops.rmdir(h,d),b.destroyNode(p)},readdir(s){var o=b.lookupPath(s,{follow:!0}),h=o.node,d=b.checkOpExists(h.node_ops.readdir,54);return d(h)},unlink(s){var o=b.lookupPath(s,{parent:!0}),h=o.node;if(!h)throw new b.ErrnoError(44);var d=q.basename(s),p=b.lookupNode(h,d),x=b.mayDelete(h,d,!1);if(x)throw new b.ErrnoError(x);if(!h.node_ops.unlink)throw new b.ErrnoError(63);if(b.isMountpoint(p))throw new b.ErrnoError(10);h.node_ops.unlink(h,d),b.destroyNode(p)},readlink(s){var o=b.lookupPath(s),h=o.node;if(!h)throw new b.ErrnoError(44);if(!h.node_ops.readlink)throw new b.ErrnoError(28);return h.node_ops.readlink(h)},stat(s,o){var h=b.lookupPath(s,{follow:!o}),d=h.node,p=b.checkOpExists(d.node_ops.getattr,63);return p(d)},fstat(s){var o=b.getStreamChecked(s),h=o.node,d=o.stream_ops.getattr,p=d?o:h;return d??=h.node_ops.getattr,b.checkOpExists(d,63),d(p)},lstat(s){return b.stat(s,!0)},doChmod(s,o,h,d){b.doSetAttr(s,o,{mode:h&4095|o.mode&-4096,ctime:Date.now(),dontFollow:d})},chmod(s,o,h){var d;if(typeof s=="string"){var p=b.lookupPath(s,{follow:!h});d=p.node}else d=s;b.doChmod(null,d,o,h)},lchmod(s,o){b.chmod(s,o,!0)},fchmod(s,o){var h=b.getStreamChecked(s);b.doChmod(h,h.node,o,!1)},doChown(s,o,h){b.doSetAttr(s,o,{timestamp:Date.now(),dontFollow:h})},chown(s,o,h,d){var p;if(typeof s=="string"){var x=b.lookupPath(s,{follow:!d});p=x.node}else p=s;b.doChown(null,p,d)},lchown(s,o,h){b.chown(s,o,h,!0)},fchown(s,o,h){var d=b.getStreamChecked(s);b.doChown(d,d.node,!1)},doTruncate(s,o,h){if(b.isDir(o.mode))throw new b.ErrnoError(31);if(!b.isFile(o.mode))throw new b.ErrnoError(28);var d=b.nodePermissions(o,"w");if(d)throw new b.ErrnoError(d);b.doSetAttr(s,o,{size:h,timestamp:Date.now()})},truncate(s,o){if(o<0)throw new b.ErrnoError(28);var h;if(typeof s=="string"){var d=b.lookupPath(s,{follow:!0});h=d.node}else h=s;b.doTruncate(null,h,o)},ftruncate(s,o){var h=b.getStreamChecked(s);if(o<0||(h.flags&2097155)===0)throw new b.ErrnoError(28);b.doTruncate(h,h.node,o)},utime(s,o,h){var d=b.lookupPath(s,{follow:!0}),p=d.node,x=b.checkOpExists(p.node_ops.setattr,63);x(p,{atime:o,mtime:h})},open(s,o,h=438){if(s==="")throw new b.ErrnoError(44);o=typeof o=="string"?on(o):o,o&64?h=h&4095|32768:h=0;var d,p;if(typeof s=="object")d=s;else{p=s.endsWith("/");var x=b.lookupPath(s,{follow:!(o&131072),noent_okay:!0});d=x.node,s=x.path}var E=!1;if(o&64)if(d){if(o&128)throw new b.ErrnoError(20)}else{if(p)throw new b.ErrnoError(31);d=b.mknod(s,h|511,0),E=!0}if(!d)throw new b.ErrnoError(44);if(b.isChrdev(d.mode)&&(o&=-513),o&65536&&!b.isDir(d.mode))throw new b.ErrnoError(54);if(!E){var C=b.mayOpen(d,o);if(C)throw new b.ErrnoError(C)}o&512&&!E&&b.truncate(d,0),o&=-131713;var F=b.createStream({node:d,path:b.getPath(d),flags:o,seekable:!0,position:0,stream_ops:d.stream_ops,ungotten:[],error:!1});return F.stream_ops.open&&F.stream_ops.open(F),E&&b.chmod(d,h&511),t.logReadFiles&&!(o&1)&&(s in b.readFiles||(b.readFiles[s]=1)),F},close(s){if(b.isClosed(s))throw new b.ErrnoError(8);s.getdents&&(s.getdents=null);try{s.stream_ops.close&&s.stream_ops.close(s)}catch(o){throw o}finally{b.closeStream(s.fd)}s.fd=null},isClosed(s){return s.fd===null},llseek(s,o,h){if(b.isClosed(s))throw new b.ErrnoError(8);if(!s.seekable||!s.stream_ops.llseek)throw new b.ErrnoError(70);if(h!=0&&h!=1&&h!=2)throw new b.ErrnoError(28);return s.position=s.stream_ops.llseek(s,o,h),s.ungotten=[],s.position},read(s,o,h,d,p){if(G(h>=0),d<0||p<0)throw new b.ErrnoError(28);if(b.isClosed(s))throw new b.ErrnoError(8);if((s.flags&2097155)===1)throw new b.ErrnoError(8);if(b.isDir(s.node.mode))throw new b.ErrnoError(31);if(!s.stream_ops.read)throw new b.ErrnoError(28);var x=typeof p<"u";if(!x)p=s.position;else if(!s.seekable)throw new b.ErrnoError(70);var E=s.stream_ops.read(s,o,h,d,p);return x||(s.position+=E),E},write(s,o,h,d,p,x){if(G(h>=0),d<0||p<0)throw new b.ErrnoError(28);if(b.isClosed(s))throw new b.ErrnoError(8);if((s.flags&2097155)===0)throw new b.ErrnoError(8);if(b.isDir(s.node.mode))throw new b.ErrnoError(31);if(!s.stream_ops.write)throw new b.ErrnoError(28);s.seekable&&s.flags&1024&&b.llseek(s,0,2);var E=typeof p<"u";if(!E)p=s.position;else if(!s.seekable)throw new b.ErrnoError(70);var C=s.stream_ops.write(s,o,h,d,p,x);return E||(s.position+=C),C},mmap(s,o,h,d,p){if((d&2)!==0&&(p&2)===0&&(s.flags&2097155)!==2)throw new b.ErrnoError(2);if((s.flags&2097155)===1)throw new b.ErrnoError(2);if(!s.stream_ops.mmap)throw new b.ErrnoError(43);if(!o)throw new b.ErrnoError(28);return s.stream_ops.mmap(s,o,h,d,p)},msync(s,o,h,d,p){return G(h>=0),s.stream_ops.msync?s.stream_ops.msync(s,o,h,d,p):0},ioctl(s,o,h){if(!s.stream_ops.ioctl)throw new b.ErrnoError(59);return s.stream_ops.ioctl(s,o,h)},readFile(s,o={}){if(o.flags=o.flags||0,o.encoding=o.encoding||"binary",o.encoding!=="utf8"&&o.encoding!=="binary")throw new Error(`Invalid encoding type "${o.encoding}"`);var h=b.open(s,o.flags),d=b.stat(s),p=d.size,x=new Uint8Array(p);return b.read(h,x,0,p,0),o.encoding==="utf8"&&(x=yi(x)),b.close(h),x},writeFile(s,o,h={}){h.flags=h.flags||577;var d=b.open(s,h.flags,h.mode);if(typeof o=="string"&&(o=new Uint8Array(gt(o,!0))),ArrayBuffer.isView(o))b.write(d,o,0,o.byteLength,void 0,h.canOwn);else throw new Error("Unsupported data type");b.close(d)},cwd:()=>b.currentPath,chdir(s){var o=b.lookupPath(s,{follow:!0});if(o.node===null)throw new b.ErrnoError(44);if(!b.isDir(o.node.mode))throw new b.ErrnoError(54);var h=b.nodePermissions(o.node,"x");if(h)throw new b.ErrnoError(h);b.currentPath=o.path},createDefaultDirectories(){b.mkdir("/tmp"),b.mkdir("/home"),b.mkdir("/home/web_user")},createDefaultDevices(){b.mkdir("/dev"),b.registerDevice(b.makedev(1,3),{read:()=>0,write:(d,p,x,E,C)=>E,llseek:()=>0}),b.mkdev("/dev/null",b.makedev(1,3)),lt.register(b.makedev(5,0),lt.default_tty_ops),lt.register(b.makedev(6,0),lt.default_tty1_ops),b.mkdev("/dev/tty",b.makedev(5,0)),b.mkdev("/dev/tty1",b.makedev(6,0));var s=new Uint8Array(1024),o=0,h=()=>(o===0&&(ze(s),o=s.byteLength),s[--o]);b.createDevice("/dev","random",h),b.createDevice("/dev","urandom",h),b.mkdir("/dev/shm"),b.mkdir("/dev/shm/tmp")},createSpecialDirectories(){b.mkdir("/proc");var s=b.mkdir("/proc/self");b.mkdir("/proc/self/fd"),b.mount({mount(){var o=b.createNode(s,"fd",16895,73);return o.stream_ops={llseek:ke.stream_ops.llseek},o.node_ops={lookup(h,d){var p=+d,x=b.getStreamChecked(p),E={parent:null,mount:{mountpoint:"fake"},node_ops:{readlink:()=>x.path},id:p+1};return E.parent=E,E},readdir(){return Array.from(b.streams.entries()).filter(([h,d])=>d).map(([h,d])=>h.toString())}},o}},{},"/proc/self/fd")},createStandardStreams(s,o,h){s?b.createDevice("/dev","stdin",s):b.symlink("/dev/tty","/dev/stdin"),o?b.createDevice("/dev","stdout",null,o):b.symlink("/dev/tty","/dev/stdout"),h?b.createDevice("/dev","stderr",null,h):b.symlink("/dev/tty1","/dev/stderr");var d=b.open("/dev/stdin",0),p=b.open("/dev/stdout",1),x=b.open("/dev/stderr",1);G(d.fd===0,`invalid handle for stdin (${d.fd})`),G(p.fd===1,`invalid handle for stdout (${p.fd})`),G(x.fd===2,`invalid handle for stderr (${x.fd})`)},staticInit(){b.nameTable=new Array(4096),b.mount(ke,{},"/"),b.createDefaultDirectories(),b.createDefaultDevices(),b.createSpecialDirectories(),b.filesystems={MEMFS:ke}},init(s,o,h){G(!b.initialized,"FS.init was previously called. If you want to initialize later with custom parameters, remove any earlier calls (note that one is automatically added to the generated code)"),b.initialized=!0,s??=t.stdin,o??=t.stdout,h??=t.stderr,b.createStandardStreams(s,o,h)},quit(){b.initialized=!1,rc(0);for(var s of b.streams)s&&b.close(s)},findObject(s,o){var h=b.analyzePath(s,o);return h.exists?h.object:null},analyzePath(s,o){try{var h=b.lookupPath(s,{follow:!o});s=h.path}catch{}var d={isRoot:!1,exists:!1,error:0,name:null,path:null,object:null,parentExists:!1,parentPath:null,parentObject:null};try{var h=b.lookupPath(s,{parent:!0});d.parentExists=!0,d.parentPath=h.path,d.parentObject=h.node,d.name=q.basename(s),h=b.lookupPath(s,{follow:!o}),d.exists=!0,d.path=h.path,d.object=h.node,d.name=h.node.name,d.isRoot=h.path==="/"}catch(p){d.error=p.errno}return d},createPath(s,o,h,d){s=typeof s=="string"?s:b.getPath(s);for(var p=o.split("/").reverse();p.length;){var x=p.pop();if(x){var E=q.join2(s,x);try{b.mkdir(E)}catch(C){if(C.errno!=20)throw C}s=E}}return E},createFile(s,o,h,d,p){var x=q.join2(typeof s=="string"?s:b.getPath(s),o),E=Fi(d,p);return b.create(x,E)},createDataFile(s,o,h,d,p,x){var E=o;s&&(s=typeof s=="string"?s:b.getPath(s),E=o?q.join2(s,o):s);var C=Fi(d,p),F=b.create(E,C);if(h){if(typeof h=="string"){for(var $=new Array(h.length),Q=0,oe=h.length;Q<oe;++Q)$[Q]=h.charCodeAt(Q);h=$}b.chmod(F,C|146);var fe=b.open(F,577);b.write(fe,h,0,h.length,0,x),b.close(fe),b.chmod(F,C)}},createDevice(s,o,h,d){var p=q.join2(typeof s=="string"?s:b.getPath(s),o),x=Fi(!!h,!!d);b.createDevice.major??=64;var E=b.makedev(b.createDevice.major++,0);return b.registerDevice(E,{open(C){C.seekable=!1},close(C){d?.buffer?.length&&d(10)},read(C,F,$,Q,oe){for(var fe=0,ce=0;ce<Q;ce++){var me;try{me=h()}catch{throw new b.ErrnoError(29)}if(me===void 0&&fe===0)throw new b.ErrnoError(6);if(me==null)break;fe++,F[$+ce]=me}return fe&&(C.node.atime=Date.now()),fe},write(C,F,$,Q,oe){for(var fe=0;fe<Q;fe++)try{d(F[$+fe])}catch{throw new b.ErrnoError(29)}return Q&&(C.node.mtime=C.node.ctime=Date.now()),fe}}),b.mkdev(p,x,E)},forceLoadFile(s){if(s.isDevice||s.isFolder||s.link||s.contents)return!0;if(typeof XMLHttpRequest<"u")throw new Error("Lazy loading should have been performed (contents set) in createLazyFile, but it was not. Lazy loading only works in web workers. Use --embed-file or --preload-file in emcc on the main thread.");try{s.contents=A(s.url),s.usedBytes=s.contents.length}catch{throw new b.ErrnoError(29)}},createLazyFile(s,o,h,d,p){class x{lengthKnown=!1;chunks=[];get(ce){if(!(ce>this.length-1||ce<0)){var me=ce%this.chunkSize,Ye=ce/this.chunkSize|0;return this.getter(Ye)[me]}}setDataGetter(ce){this.getter=ce}cacheLength(){var ce=new XMLHttpRequest;if(ce.open("HEAD",h,!1),ce.send(null),!(ce.status>=200&&ce.status<300||ce.status===304))throw new Error("Couldn't load "+h+". Status: "+ce.status);var me=Number(ce.getResponseHeader("Content-length")),Ye,vt=(Ye=ce.getResponseHeader("Accept-Ranges"))&&Ye==="bytes",at=(Ye=ce.getResponseHeader("Content-Encoding"))&&Ye==="gzip",bt=1024*1024;vt||(bt=me);var nt=(Kt,xn)=>{if(Kt>xn)throw new Error("invalid range ("+Kt+", "+xn+") or no bytes requested!");if(xn>me-1)throw new Error("only "+me+" bytes available! programmer error!");var Nt=new XMLHttpRequest;if(Nt.open("GET",h,!1),me!==bt&&Nt.setRequestHeader("Range","bytes="+Kt+"-"+xn),Nt.responseType="arraybuffer",Nt.overrideMimeType&&Nt.overrideMimeType("text/plain; charset=x-user-defined"),Nt.send(null),!(Nt.status>=200&&Nt.status<300||Nt.status===304))throw new Error("Couldn't load "+h+". Status: "+Nt.status);return Nt.response!==void 0?new Uint8Array(Nt.response||[]):gt(Nt.responseText||"",!0)},qt=this;qt.setDataGetter(Kt=>{var xn=Kt*bt,Nt=(Kt+1)*bt-1;if(Nt=Math.min(Nt,me-1),typeof qt.chunks[Kt]>"u"&&(qt.chunks[Kt]=nt(xn,Nt)),typeof qt.chunks[Kt]>"u")throw new Error("doXHR failed!");return qt.chunks[Kt]}),(at||!me)&&(bt=me=1,me=this.getter(0).length,bt=me,U("LazyFiles on gzip forces download of the whole file when length is accessed")),this._length=me,this._chunkSize=bt,this.lengthKnown=!0}get length(){return this.lengthKnown||this.cacheLength(),this._length}get chunkSize(){return this.lengthKnown||this.cacheLength(),this._chunkSize}}if(typeof XMLHttpRequest<"u"){if(!r)throw"Cannot do synchronous binary XHRs outside webworkers in modern browsers. Use --embed-file or --preload-file in emcc";var E=new x,C={isDevice:!1,contents:E}}else var C={isDevice:!1,url:h};var F=b.createFile(s,o,C,d,p);C.contents?F.contents=C.contents:C.url&&(F.contents=null,F.url=C.url),Object.defineProperties(F,{usedBytes:{get:function(){return this.contents.length}}});var $={},Q=Object.keys(F.stream_ops);Q.forEach(fe=>{var ce=F.stream_ops[fe];$[fe]=(...me)=>(b.forceLoadFile(F),ce(...me))});function oe(fe,ce,me,Ye,vt){var at=fe.node.contents;if(vt>=at.length)return 0;var bt=Math.min(at.length-vt,Ye);if(G(bt>=0),at.slice)for(var nt=0;nt<bt;nt++)ce[me+nt]=at[vt+nt];else for(var nt=0;nt<bt;nt++)ce[me+nt]=at.get(vt+nt);return bt}return $.read=(fe,ce,me,Ye,vt)=>(b.forceLoadFile(F),oe(fe,ce,me,Ye,vt)),$.mmap=(fe,ce,me,Ye,vt)=>{b.forceLoadFile(F);var at=Wt(ce);if(!at)throw new b.ErrnoError(48);return oe(fe,pt,at,ce,me),{ptr:at,allocated:!0}},F.stream_ops=$,F},absolutePath(){pe("FS.absolutePath has been removed; use PATH_FS.resolve instead")},createFolder(){pe("FS.createFolder has been removed; use FS.mkdir instead")},createLink(){pe("FS.createLink has been removed; use FS.symlink instead")},joinPath(){pe("FS.joinPath has been removed; use PATH.join instead")},mmapAlloc(){pe("FS.mmapAlloc has been replaced by the top level function mmapAlloc")},standardizePath(){pe("FS.standardizePath has been removed; use PATH.normalize instead")}},ft={DEFAULT_POLLMASK:5,calculateAt(s,o,h){if(q.isAbs(o))return o;var d;if(s===-100)d=b.cwd();else{var p=ft.getStreamFromFD(s);d=p.path}if(o.length==0){if(!h)throw new b.ErrnoError(44);return d}return d+"/"+o},writeStat(s,o){De[s>>2]=o.dev,De[s+4>>2]=o.mode,$e[s+8>>2]=o.nlink,De[s+12>>2]=o.uid,De[s+16>>2]=o.gid,De[s+20>>2]=o.rdev,W[s+24>>3]=BigInt(o.size),De[s+32>>2]=4096,De[s+36>>2]=o.blocks;var h=o.atime.getTime(),d=o.mtime.getTime(),p=o.ctime.getTime();return W[s+40>>3]=BigInt(Math.floor(h/1e3)),$e[s+48>>2]=h%1e3*1e3*1e3,W[s+56>>3]=BigInt(Math.floor(d/1e3)),$e[s+64>>2]=d%1e3*1e3*1e3,W[s+72>>3]=BigInt(Math.floor(p/1e3)),$e[s+80>>2]=p%1e3*1e3*1e3,W[s+88>>3]=BigInt(o.ino),0},writeStatFs(s,o){De[s+4>>2]=o.bsize,De[s+40>>2]=o.bsize,De[s+8>>2]=o.blocks,De[s+12>>2]=o.bfree,De[s+16>>2]=o.bavail,De[s+20>>2]=o.files,De[s+24>>2]=o.ffree,De[s+28>>2]=o.fsid,De[s+44>>2]=o.flags,De[s+36>>2]=o.namelen},doMsync(s,o,h,d,p){if(!b.isFile(o.node.mode))throw new b.ErrnoError(43);if(d&2)return 0;var x=It.slice(s,s+h);b.msync(o,x,p,h,d)},getStreamFromFD(s){var o=b.getStreamChecked(s);return o},varargs:void 0,getStr(s){var o=un(s);return o}};function Rn(s,o,h){try{var d=ft.getStreamFromFD(s);if(G(!h),d.fd===o)return-28;if(o<0||o>=b.MAX_OPEN_FDS)return-8;var p=b.getStream(o);return p&&b.close(p),b.dupStream(d,o).fd}catch(x){if(typeof b>"u"||x.name!=="ErrnoError")throw x;return-x.errno}}var Ft=()=>{G(ft.varargs!=null);var s=De[+ft.varargs>>2];return ft.varargs+=4,s},kt=Ft;function Wn(s,o,h){ft.varargs=h;try{var d=ft.getStreamFromFD(s);switch(o){case 0:{var p=Ft();if(p<0)return-28;for(;b.streams[p];)p++;var x;return x=b.dupStream(d,p),x.fd}case 1:case 2:return 0;case 3:return d.flags;case 4:{var p=Ft();return d.flags|=p,0}case 12:{var p=kt(),E=0;return Mt[p+E>>1]=2,0}case 13:case 14:return 0}return-28}catch(C){if(typeof b>"u"||C.name!=="ErrnoError")throw C;return-C.errno}}function va(s,o){try{return ft.writeStat(o,b.fstat(s))}catch(h){if(typeof b>"u"||h.name!=="ErrnoError")throw h;return-h.errno}}function Vf(s,o,h){ft.varargs=h;try{var d=ft.getStreamFromFD(s);switch(o){case 21509:return d.tty?0:-59;case 21505:{if(!d.tty)return-59;if(d.tty.ops.ioctl_tcgets){var p=d.tty.ops.ioctl_tcgets(d),x=kt();De[x>>2]=p.c_iflag||0,De[x+4>>2]=p.c_oflag||0,De[x+8>>2]=p.c_cflag||0,De[x+12>>2]=p.c_lflag||0;for(var E=0;E<32;E++)pt[x+E+17]=p.c_cc[E]||0;return 0}return 0}case 21510:case 21511:case 21512:return d.tty?0:-59;case 21506:case 21507:case 21508:{if(!d.tty)return-59;if(d.tty.ops.ioctl_tcsets){for(var x=kt(),C=De[x>>2],F=De[x+4>>2],$=De[x+8>>2],Q=De[x+12>>2],oe=[],E=0;E<32;E++)oe.push(pt[x+E+17]);return d.tty.ops.ioctl_tcsets(d.tty,o,{c_iflag:C,c_oflag:F,c_cflag:$,c_lflag:Q,c_cc:oe})}return 0}case 21519:{if(!d.tty)return-59;var x=kt();return De[x>>2]=0,0}case 21520:return d.tty?-28:-59;case 21531:{var x=kt();return b.ioctl(d,o,x)}case 21523:{if(!d.tty)return-59;if(d.tty.ops.ioctl_tiocgwinsz){var fe=d.tty.ops.ioctl_tiocgwinsz(d.tty),x=kt();Mt[x>>1]=fe[0],Mt[x+2>>1]=fe[1]}return 0}case 21524:return d.tty?0:-59;case 21515:return d.tty?0:-59;default:return-28}}catch(ce){if(typeof b>"u"||ce.name!=="ErrnoError")throw ce;return-ce.errno}}function Hf(s,o){try{return s=ft.getStr(s),ft.writeStat(o,b.lstat(s))}catch(h){if(typeof b>"u"||h.name!=="ErrnoError")throw h;return-h.errno}}function Wf(s,o,h,d){try{o=ft.getStr(o);var p=d&256,x=d&4096;return d=d&-6401,G(!d,`unknown flags in __syscall_newfstatat: ${d}`),o=ft.calculateAt(s,o,x),ft.writeStat(h,p?b.lstat(o):b.stat(o))}catch(E){if(typeof b>"u"||E.name!=="ErrnoError")throw E;return-E.errno}}function Xf(s,o,h,d){ft.varargs=d;try{o=ft.getStr(o),o=ft.calculateAt(s,o);var p=d?Ft():0;return b.open(o,h,p).fd}catch(x){if(typeof b>"u"||x.name!=="ErrnoError")throw x;return-x.errno}}function $f(s,o){try{return s=ft.getStr(s),ft.writeStat(o,b.stat(s))}catch(h){if(typeof b>"u"||h.name!=="ErrnoError")throw h;return-h.errno}}var qf=()=>pe("native code called abort()"),Zt=s=>{for(var o="";;){var h=It[s++];if(!h)return o;o+=String.fromCharCode(h)}},br={},nr={},ya={},ls=class extends Error{constructor(o){super(o),this.name="BindingError"}},xt=s=>{throw new ls(s)};function Yf(s,o,h={}){var d=o.name;if(s||xt(`type "${d}" must have a positive integer typeid pointer`),nr.hasOwnProperty(s)){if(h.ignoreDuplicateRegistrations)return;xt(`Cannot register type '${d}' twice`)}if(nr[s]=o,delete ya[s],br.hasOwnProperty(s)){var p=br[s];delete br[s],p.forEach(x=>x())}}function Bn(s,o,h={}){if(o.argPackAdvance===void 0)throw new TypeError("registerType registeredInstance requires argPackAdvance");return Yf(s,o,h)}var Gh=(s,o,h)=>{switch(o){case 1:return h?d=>pt[d]:d=>It[d];case 2:return h?d=>Mt[d>>1]:d=>rn[d>>1];case 4:return h?d=>De[d>>2]:d=>$e[d>>2];case 8:return h?d=>W[d>>3]:d=>yn[d>>3];default:throw new TypeError(`invalid integer width (${o}): ${s}`)}},ir=s=>{if(s===null)return"null";var o=typeof s;return o==="object"||o==="array"||o==="function"?s.toString():""+s},Vh=(s,o,h,d)=>{if(o<h||o>d)throw new TypeError(`Passing a number "${ir(o)}" from JS side to C/C++ side to an argument of type "${s}", which is outside the valid range [${h}, ${d}]!`)},jf=(s,o,h,d,p)=>{o=Zt(o);let x=d===0n,E=C=>C;if(x){let C=h*8;E=F=>BigInt.asUintN(C,F),p=E(p)}Bn(s,{name:o,fromWireType:E,toWireType:(C,F)=>{if(typeof F=="number")F=BigInt(F);else if(typeof F!="bigint")throw new TypeError(`Cannot convert "${ir(F)}" to ${this.name}`);return Vh(o,F,d,p),F},argPackAdvance:ri,readValueFromPointer:Gh(o,h,!x),destructorFunction:null})},ri=8,Zf=(s,o,h,d)=>{o=Zt(o),Bn(s,{name:o,fromWireType:function(p){return!!p},toWireType:function(p,x){return x?h:d},argPackAdvance:ri,readValueFromPointer:function(p){return this.fromWireType(It[p])},destructorFunction:null})},Jf=s=>({count:s.count,deleteScheduled:s.deleteScheduled,preservePointerOnDelete:s.preservePointerOnDelete,ptr:s.ptr,ptrType:s.ptrType,smartPtr:s.smartPtr,smartPtrType:s.smartPtrType}),ql=s=>{function o(h){return h.$$.ptrType.registeredClass.name}xt(o(s)+" instance already deleted")},Yl=!1,Hh=s=>{},Kf=s=>{s.smartPtr?s.smartPtrType.rawDestructor(s.smartPtr):s.ptrType.registeredClass.rawDestructor(s.ptr)},Wh=s=>{s.count.value-=1;var o=s.count.value===0;o&&Kf(s)},Xh=(s,o,h)=>{if(o===h)return s;if(h.baseClass===void 0)return null;var d=Xh(s,o,h.baseClass);return d===null?null:h.downcast(d)},$h={},Qf={},ep=(s,o)=>{for(o===void 0&&xt("ptr should not be undefined");s.baseClass;)o=s.upcast(o),s=s.baseClass;return o},tp=(s,o)=>(o=ep(s,o),Qf[o]),np=class extends Error{constructor(o){super(o),this.name="InternalError"}},xa=s=>{throw new np(s)},Sa=(s,o)=>{(!o.ptrType||!o.ptr)&&xa("makeClassHandle requires ptr and ptrType");var h=!!o.smartPtrType,d=!!o.smartPtr;return h!==d&&xa("Both smartPtrType and smartPtr must be specified"),o.count={value:1},cs(Object.create(s,{$$:{value:o,writable:!0}}))};function qh(s){var o=this.getPointee(s);if(!o)return this.destructor(s),null;var h=tp(this.registeredClass,o);if(h!==void 0){if(h.$$.count.value===0)return h.$$.ptr=o,h.$$.smartPtr=s,h.clone();var d=h.clone();return this.destructor(s),d}function p(){return this.isSmartPointer?Sa(this.registeredClass.instancePrototype,{ptrType:this.pointeeType,ptr:o,smartPtrType:this,smartPtr:s}):Sa(this.registeredClass.instancePrototype,{ptrType:this,ptr:s})}var x=this.registeredClass.getActualType(o),E=$h[x];if(!E)return p.call(this);var C;this.isConst?C=E.constPointerType:C=E.pointerType;var F=Xh(o,this.registeredClass,C.registeredClass);return F===null?p.call(this):this.isSmartPointer?Sa(C.registeredClass.instancePrototype,{ptrType:C,ptr:F,smartPtrType:this,smartPtr:s}):Sa(C.registeredClass.instancePrototype,{ptrType:C,ptr:F})}var cs=s=>typeof FinalizationRegistry>"u"?(cs=o=>o,s):(Yl=new FinalizationRegistry(o=>{console.warn(o.leakWarning),Wh(o.$$)}),cs=o=>{var h=o.$$,d=!!h.smartPtr;if(d){var p={$$:h},x=h.ptrType.registeredClass,E=new Error(`Embind found a leaked C++ instance ${x.name} <${Bt(h.ptr)}>.
We'll free it automatically in this case, but this functionality is not reliable across various environments.
Make sure to invoke .delete() manually once you're done with the instance instead.
Originally allocated`);"captureStackTrace"in Error&&Error.captureStackTrace(E,qh),p.leakWarning=E.stack.replace(/^Error: /,""),Yl.register(o,p,o)}return o},Hh=o=>Yl.unregister(o),cs(s)),Ma=[],ip=()=>{for(;Ma.length;){var s=Ma.pop();s.$$.deleteScheduled=!1,s.delete()}},Yh,rp=()=>{let s=ba.prototype;Object.assign(s,{isAliasOf(h){if(!(this instanceof ba)||!(h instanceof ba))return!1;var d=this.$$.ptrType.registeredClass,p=this.$$.ptr;h.$$=h.$$;for(var x=h.$$.ptrType.registeredClass,E=h.$$.ptr;d.baseClass;)p=d.upcast(p),d=d.baseClass;for(;x.baseClass;)E=x.upcast(E),x=x.baseClass;return d===x&&p===E},clone(){if(this.$$.ptr||ql(this),this.$$.preservePointerOnDelete)return this.$$.count.value+=1,this;var h=cs(Object.create(Object.getPrototypeOf(this),{$$:{value:Jf(this.$$)}}));return h.$$.count.value+=1,h.$$.deleteScheduled=!1,h},delete(){this.$$.ptr||ql(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),Hh(this),Wh(this.$$),this.$$.preservePointerOnDelete||(this.$$.smartPtr=void 0,this.$$.ptr=void 0)},isDeleted(){return!this.$$.ptr},deleteLater(){return this.$$.ptr||ql(this),this.$$.deleteScheduled&&!this.$$.preservePointerOnDelete&&xt("Object already scheduled for deletion"),Ma.push(this),Ma.length===1&&Yh&&Yh(ip),this.$$.deleteScheduled=!0,this}});let o=Symbol.dispose;o&&(s[o]=s.delete)};function ba(){}var wa=(s,o)=>Object.defineProperty(o,"name",{value:s}),jl=(s,o,h)=>{if(s[o].overloadTable===void 0){var d=s[o];s[o]=function(...p){return s[o].overloadTable.hasOwnProperty(p.length)||xt(`Function '${h}' called with an invalid number of arguments (${p.length}) - expects one of (${s[o].overloadTable})!`),s[o].overloadTable[p.length].apply(this,p)},s[o].overloadTable=[],s[o].overloadTable[d.argCount]=d}},Zl=(s,o,h)=>{t.hasOwnProperty(s)?((h===void 0||t[s].overloadTable!==void 0&&t[s].overloadTable[h]!==void 0)&&xt(`Cannot register public name '${s}' twice`),jl(t,s,s),t[s].overloadTable.hasOwnProperty(h)&&xt(`Cannot register multiple overloads of a function with the same number of arguments (${h})!`),t[s].overloadTable[h]=o):(t[s]=o,t[s].argCount=h)},sp=48,ap=57,op=s=>{G(typeof s=="string"),s=s.replace(/[^a-zA-Z0-9_]/g,"$");var o=s.charCodeAt(0);return o>=sp&&o<=ap?`_${s}`:s};function lp(s,o,h,d,p,x,E,C){this.name=s,this.constructor=o,this.instancePrototype=h,this.rawDestructor=d,this.baseClass=p,this.getActualType=x,this.upcast=E,this.downcast=C,this.pureVirtualFunctions=[]}var Ea=(s,o,h)=>{for(;o!==h;)o.upcast||xt(`Expected null or instance of ${h.name}, got an instance of ${o.name}`),s=o.upcast(s),o=o.baseClass;return s};function cp(s,o){if(o===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;o.$$||xt(`Cannot pass "${ir(o)}" as a ${this.name}`),o.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`);var h=o.$$.ptrType.registeredClass,d=Ea(o.$$.ptr,h,this.registeredClass);return d}function hp(s,o){var h;if(o===null)return this.isReference&&xt(`null is not a valid ${this.name}`),this.isSmartPointer?(h=this.rawConstructor(),s!==null&&s.push(this.rawDestructor,h),h):0;(!o||!o.$$)&&xt(`Cannot pass "${ir(o)}" as a ${this.name}`),o.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),!this.isConst&&o.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${o.$$.smartPtrType?o.$$.smartPtrType.name:o.$$.ptrType.name} to parameter type ${this.name}`);var d=o.$$.ptrType.registeredClass;if(h=Ea(o.$$.ptr,d,this.registeredClass),this.isSmartPointer)switch(o.$$.smartPtr===void 0&&xt("Passing raw pointer to smart pointer is illegal"),this.sharingPolicy){case 0:o.$$.smartPtrType===this?h=o.$$.smartPtr:xt(`Cannot convert argument of type ${o.$$.smartPtrType?o.$$.smartPtrType.name:o.$$.ptrType.name} to parameter type ${this.name}`);break;case 1:h=o.$$.smartPtr;break;case 2:if(o.$$.smartPtrType===this)h=o.$$.smartPtr;else{var p=o.clone();h=this.rawShare(h,Jt.toHandle(()=>p.delete())),s!==null&&s.push(this.rawDestructor,h)}break;default:xt("Unsupporting sharing policy")}return h}function up(s,o){if(o===null)return this.isReference&&xt(`null is not a valid ${this.name}`),0;o.$$||xt(`Cannot pass "${ir(o)}" as a ${this.name}`),o.$$.ptr||xt(`Cannot pass deleted object as a pointer of type ${this.name}`),o.$$.ptrType.isConst&&xt(`Cannot convert argument of type ${o.$$.ptrType.name} to parameter type ${this.name}`);var h=o.$$.ptrType.registeredClass,d=Ea(o.$$.ptr,h,this.registeredClass);return d}function Ta(s){return this.fromWireType($e[s>>2])}var dp=()=>{Object.assign(Aa.prototype,{getPointee(s){return this.rawGetPointee&&(s=this.rawGetPointee(s)),s},destructor(s){this.rawDestructor?.(s)},argPackAdvance:ri,readValueFromPointer:Ta,fromWireType:qh})};function Aa(s,o,h,d,p,x,E,C,F,$,Q){this.name=s,this.registeredClass=o,this.isReference=h,this.isConst=d,this.isSmartPointer=p,this.pointeeType=x,this.sharingPolicy=E,this.rawGetPointee=C,this.rawConstructor=F,this.rawShare=$,this.rawDestructor=Q,!p&&o.baseClass===void 0?d?(this.toWireType=cp,this.destructorFunction=null):(this.toWireType=up,this.destructorFunction=null):this.toWireType=hp}var jh=(s,o,h)=>{t.hasOwnProperty(s)||xa("Replacing nonexistent public symbol"),t[s].overloadTable!==void 0&&h!==void 0?t[s].overloadTable[h]=o:(t[s]=o,t[s].argCount=h)},Zh=[],Ca,be=s=>{var o=Zh[s];return o||(Zh[s]=o=Ca.get(s)),G(Ca.get(s)==o,"JavaScript-side Wasm function table mirror is out of date!"),o},si=(s,o,h=!1)=>{G(!h,"Async bindings are only supported with JSPI."),s=Zt(s);function d(){var x=be(o);return x}var p=d();return typeof p!="function"&&xt(`unknown function pointer with signature ${s}: ${o}`),p};class fp extends Error{}var Jh=s=>{var o=mu(s),h=Zt(o);return $n(o),h},rr=(s,o)=>{var h=[],d={};function p(x){if(!d[x]&&!nr[x]){if(ya[x]){ya[x].forEach(p);return}h.push(x),d[x]=!0}}throw o.forEach(p),new fp(`${s}: `+h.map(Jh).join([", "]))},Xn=(s,o,h)=>{s.forEach(C=>ya[C]=o);function d(C){var F=h(C);F.length!==s.length&&xa("Mismatched type converter count");for(var $=0;$<s.length;++$)Bn(s[$],F[$])}var p=new Array(o.length),x=[],E=0;o.forEach((C,F)=>{nr.hasOwnProperty(C)?p[F]=nr[C]:(x.push(C),br.hasOwnProperty(C)||(br[C]=[]),br[C].push(()=>{p[F]=nr[C],++E,E===x.length&&d(p)}))}),x.length===0&&d(p)},pp=(s,o,h,d,p,x,E,C,F,$,Q,oe,fe)=>{Q=Zt(Q),x=si(p,x),C&&=si(E,C),$&&=si(F,$),fe=si(oe,fe);var ce=op(Q);Zl(ce,function(){rr(`Cannot construct ${Q} due to unbound types`,[d])}),Xn([s,o,h],d?[d]:[],me=>{me=me[0];var Ye,vt;d?(Ye=me.registeredClass,vt=Ye.instancePrototype):vt=ba.prototype;var at=wa(Q,function(...Nt){if(Object.getPrototypeOf(this)!==bt)throw new ls(`Use 'new' to construct ${Q}`);if(nt.constructor_body===void 0)throw new ls(`${Q} has no accessible constructor`);var or=nt.constructor_body[Nt.length];if(or===void 0)throw new ls(`Tried to invoke ctor of ${Q} with invalid number of parameters (${Nt.length}) - expected (${Object.keys(nt.constructor_body).toString()}) parameters instead!`);return or.apply(this,Nt)}),bt=Object.create(vt,{constructor:{value:at}});at.prototype=bt;var nt=new lp(Q,at,bt,fe,Ye,x,C,$);nt.baseClass&&(nt.baseClass.__derivedClasses??=[],nt.baseClass.__derivedClasses.push(nt));var qt=new Aa(Q,nt,!0,!1,!1),Kt=new Aa(Q+"*",nt,!1,!1,!1),xn=new Aa(Q+" const*",nt,!1,!0,!1);return $h[s]={pointerType:Kt,constPointerType:xn},jh(ce,at),[qt,Kt,xn]})},Ra=s=>{for(;s.length;){var o=s.pop(),h=s.pop();h(o)}};function Kh(s){for(var o=1;o<s.length;++o)if(s[o]!==null&&s[o].destructorFunction===void 0)return!0;return!1}function Qh(s,o,h,d,p){if(s<o||s>h){var x=o==h?o:`${o} to ${h}`;p(`function ${d} called with ${s} arguments, expected ${x}`)}}function Nw(s,o,h,d){var p=Kh(s),x=s.length-2,E=[],C=["fn"];o&&C.push("thisWired");for(var F=0;F<x;++F)E.push(`arg${F}`),C.push(`arg${F}Wired`);E=E.join(","),C=C.join(",");var $=`return function (${E}) {
`;$+=`checkArgCount(arguments.length, minArgs, maxArgs, humanName, throwBindingError);
`,p&&($+=`var destructors = [];
`);var Q=p?"destructors":"null",oe=["humanName","throwBindingError","invoker","fn","runDestructors","retType","classParam"];o&&($+=`var thisWired = classParam['toWireType'](${Q}, this);
`);for(var F=0;F<x;++F)$+=`var arg${F}Wired = argType${F}['toWireType'](${Q}, arg${F});
`,oe.push(`argType${F}`);$+=(h||d?"var rv = ":"")+`invoker(${C});
`;var fe=h?"rv":"";if(p)$+=`runDestructors(destructors);
`;else for(var F=o?1:2;F<s.length;++F){var ce=F===1?"thisWired":"arg"+(F-2)+"Wired";s[F].destructorFunction!==null&&($+=`${ce}_dtor(${ce});
`,oe.push(`${ce}_dtor`))}return h&&($+=`var ret = retType['fromWireType'](rv);
return ret;
`),$+=`}
`,oe.push("checkArgCount","minArgs","maxArgs"),$=`if (arguments.length !== ${oe.length}){ throw new Error(humanName + "Expected ${oe.length} closure arguments " + arguments.length + " given."); }
${$}`,[oe,$]}function mp(s){for(var o=s.length-2,h=s.length-1;h>=2&&s[h].optional;--h)o--;return o}function Pa(s,o,h,d,p,x){var E=o.length;E<2&&xt("argTypes array size mismatch! Must at least get return value and 'this' types!"),G(!x,"Async bindings are only supported with JSPI.");for(var C=o[1]!==null&&h!==null,F=Kh(o),$=o[0].name!=="void",Q=E-2,oe=mp(o),fe=[s,xt,d,p,Ra,o[0],o[1]],ce=0;ce<E-2;++ce)fe.push(o[ce+2]);if(!F)for(var ce=C?1:2;ce<o.length;++ce)o[ce].destructorFunction!==null&&fe.push(o[ce].destructorFunction);fe.push(Qh,oe,Q);var me=C?1:2,Ye=function(...vt){Qh(vt.length,oe,Q,s,xt);for(var at=F?[]:null,bt=C?[o[1].toWireType(at,this)]:[],nt=0;nt<Q;++nt)bt.push(o[nt+2].toWireType(at,vt[nt]));var qt=d(p,...bt);if(F)Ra(at);else for(var nt=me;nt<o.length;++nt)o[nt].destructorFunction?.(bt[nt-me]);if($)return o[0].fromWireType(qt)};return wa(s,Ye)}var Ia=(s,o)=>{for(var h=[],d=0;d<s;d++)h.push($e[o+d*4>>2]);return h},Jl=s=>{s=s.trim();let o=s.indexOf("(");return o===-1?s:(G(s.endsWith(")"),"Parentheses for argument names should match."),s.slice(0,o))},gp=(s,o,h,d,p,x,E,C,F)=>{var $=Ia(h,d);o=Zt(o),o=Jl(o),x=si(p,x,C),Xn([],[s],Q=>{Q=Q[0];var oe=`${Q.name}.${o}`;function fe(){rr(`Cannot call ${oe} due to unbound types`,$)}o.startsWith("@@")&&(o=Symbol[o.substring(2)]);var ce=Q.registeredClass.constructor;return ce[o]===void 0?(fe.argCount=h-1,ce[o]=fe):(jl(ce,o,oe),ce[o].overloadTable[h-1]=fe),Xn([],$,me=>{var Ye=[me[0],null].concat(me.slice(1)),vt=Pa(oe,Ye,null,x,E,C);if(ce[o].overloadTable===void 0?(vt.argCount=h-1,ce[o]=vt):ce[o].overloadTable[h-1]=vt,Q.registeredClass.__derivedClasses)for(let at of Q.registeredClass.__derivedClasses)at.constructor.hasOwnProperty(o)||(at.constructor[o]=vt);return[]}),[]})},_p=(s,o,h,d,p,x)=>{G(o>0);var E=Ia(o,h);p=si(d,p);var C=[x],F=[];Xn([],[s],$=>{$=$[0];var Q=`constructor ${$.name}`;if($.registeredClass.constructor_body===void 0&&($.registeredClass.constructor_body=[]),$.registeredClass.constructor_body[o-1]!==void 0)throw new ls(`Cannot register multiple constructors with identical number of parameters (${o-1}) for class '${$.name}'! Overload resolution is currently only performed using the parameter count, not actual type info!`);return $.registeredClass.constructor_body[o-1]=()=>{rr(`Cannot construct ${$.name} due to unbound types`,E)},Xn([],E,oe=>(oe.splice(1,0,null),$.registeredClass.constructor_body[o-1]=Pa(Q,oe,null,p,x),[])),[]})},vp=(s,o,h,d,p,x,E,C,F,$)=>{var Q=Ia(h,d);o=Zt(o),o=Jl(o),x=si(p,x,F),Xn([],[s],oe=>{oe=oe[0];var fe=`${oe.name}.${o}`;o.startsWith("@@")&&(o=Symbol[o.substring(2)]),C&&oe.registeredClass.pureVirtualFunctions.push(o);function ce(){rr(`Cannot call ${fe} due to unbound types`,Q)}var me=oe.registeredClass.instancePrototype,Ye=me[o];return Ye===void 0||Ye.overloadTable===void 0&&Ye.className!==oe.name&&Ye.argCount===h-2?(ce.argCount=h-2,ce.className=oe.name,me[o]=ce):(jl(me,o,fe),me[o].overloadTable[h-2]=ce),Xn([],Q,vt=>{var at=Pa(fe,vt,oe,x,E,F);return me[o].overloadTable===void 0?(at.argCount=h-2,me[o]=at):me[o].overloadTable[h-2]=at,[]}),[]})},eu=(s,o,h)=>(s instanceof Object||xt(`${h} with invalid "this": ${s}`),s instanceof o.registeredClass.constructor||xt(`${h} incompatible with "this" of type ${s.constructor.name}`),s.$$.ptr||xt(`cannot call emscripten binding method ${h} on deleted object`),Ea(s.$$.ptr,s.$$.ptrType.registeredClass,o.registeredClass)),yp=(s,o,h,d,p,x,E,C,F,$)=>{o=Zt(o),p=si(d,p),Xn([],[s],Q=>{Q=Q[0];var oe=`${Q.name}.${o}`,fe={get(){rr(`Cannot access ${oe} due to unbound types`,[h,E])},enumerable:!0,configurable:!0};return F?fe.set=()=>rr(`Cannot access ${oe} due to unbound types`,[h,E]):fe.set=ce=>xt(oe+" is a read-only property"),Object.defineProperty(Q.registeredClass.instancePrototype,o,fe),Xn([],F?[h,E]:[h],ce=>{var me=ce[0],Ye={get(){var at=eu(this,Q,oe+" getter");return me.fromWireType(p(x,at))},enumerable:!0};if(F){F=si(C,F);var vt=ce[1];Ye.set=function(at){var bt=eu(this,Q,oe+" setter"),nt=[];F($,bt,vt.toWireType(nt,at)),Ra(nt)}}return Object.defineProperty(Q.registeredClass.instancePrototype,o,Ye),[]}),[]})},xp=(s,o,h)=>{s=Zt(s),Xn([],[o],d=>(d=d[0],t[s]=d.fromWireType(h),[]))},tu=[],ai=[0,1,,1,null,1,!0,1,!1,1],Kl=s=>{s>9&&--ai[s+1]===0&&(G(ai[s]!==void 0,"Decref for unallocated handle."),ai[s]=void 0,tu.push(s))},Jt={toValue:s=>(s||xt(`Cannot use deleted val. handle = ${s}`),G(s===2||ai[s]!==void 0&&s%2===0,`invalid handle: ${s}`),ai[s]),toHandle:s=>{switch(s){case void 0:return 2;case null:return 4;case!0:return 6;case!1:return 8;default:{let o=tu.pop()||ai.length;return ai[o]=s,ai[o+1]=1,o}}}},nu={name:"emscripten::val",fromWireType:s=>{var o=Jt.toValue(s);return Kl(s),o},toWireType:(s,o)=>Jt.toHandle(o),argPackAdvance:ri,readValueFromPointer:Ta,destructorFunction:null},iu=s=>Bn(s,nu),Sp=(s,o,h)=>{switch(o){case 1:return h?function(d){return this.fromWireType(pt[d])}:function(d){return this.fromWireType(It[d])};case 2:return h?function(d){return this.fromWireType(Mt[d>>1])}:function(d){return this.fromWireType(rn[d>>1])};case 4:return h?function(d){return this.fromWireType(De[d>>2])}:function(d){return this.fromWireType($e[d>>2])};default:throw new TypeError(`invalid integer width (${o}): ${s}`)}},Mp=(s,o,h,d)=>{o=Zt(o);function p(){}p.values={},Bn(s,{name:o,constructor:p,fromWireType:function(x){return this.constructor.values[x]},toWireType:(x,E)=>E.value,argPackAdvance:ri,readValueFromPointer:Sp(o,h,d),destructorFunction:null}),Zl(o,p)},Da=(s,o)=>{var h=nr[s];return h===void 0&&xt(`${o} has unknown type ${Jh(s)}`),h},bp=(s,o,h)=>{var d=Da(s,"enum");o=Zt(o);var p=d.constructor,x=Object.create(d.constructor.prototype,{value:{value:h},constructor:{value:wa(`${d.name}_${o}`,function(){})}});p.values[h]=x,p[o]=x},wp=(s,o)=>{switch(o){case 4:return function(h){return this.fromWireType(hn[h>>2])};case 8:return function(h){return this.fromWireType(sn[h>>3])};default:throw new TypeError(`invalid float width (${o}): ${s}`)}},Ep=(s,o,h)=>{o=Zt(o),Bn(s,{name:o,fromWireType:d=>d,toWireType:(d,p)=>{if(typeof p!="number"&&typeof p!="boolean")throw new TypeError(`Cannot convert ${ir(p)} to ${this.name}`);return p},argPackAdvance:ri,readValueFromPointer:wp(o,h),destructorFunction:null})},Tp=(s,o,h,d,p,x,E,C)=>{var F=Ia(o,h);s=Zt(s),s=Jl(s),p=si(d,p,E),Zl(s,function(){rr(`Cannot call ${s} due to unbound types`,F)},o-1),Xn([],F,$=>{var Q=[$[0],null].concat($.slice(1));return jh(s,Pa(s,Q,null,p,x,E),o-1),[]})},Ap=(s,o,h,d,p)=>{o=Zt(o);let x=d===0,E=F=>F;if(x){var C=32-8*h;E=F=>F<<C>>>C,p=E(p)}Bn(s,{name:o,fromWireType:E,toWireType:(F,$)=>{if(typeof $!="number"&&typeof $!="boolean")throw new TypeError(`Cannot convert "${ir($)}" to ${o}`);return Vh(o,$,d,p),$},argPackAdvance:ri,readValueFromPointer:Gh(o,h,d!==0),destructorFunction:null})},Cp=(s,o,h)=>{var d=[Int8Array,Uint8Array,Int16Array,Uint16Array,Int32Array,Uint32Array,Float32Array,Float64Array,BigInt64Array,BigUint64Array],p=d[o];function x(E){var C=$e[E>>2],F=$e[E+4>>2];return new p(pt.buffer,F,C)}h=Zt(h),Bn(s,{name:h,fromWireType:x,argPackAdvance:ri,readValueFromPointer:x},{ignoreDuplicateRegistrations:!0})},Rp=Object.assign({optional:!0},nu),Pp=(s,o)=>{Bn(s,Rp)},sr=(s,o,h)=>(G(typeof h=="number","stringToUTF8(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),st(s,It,o,h)),Ip=(s,o)=>{o=Zt(o);var h=!0;Bn(s,{name:o,fromWireType(d){var p=$e[d>>2],x=d+4,E;if(h)for(var C=x,F=0;F<=p;++F){var $=x+F;if(F==p||It[$]==0){var Q=$-C,oe=un(C,Q);E===void 0?E=oe:(E+="\0",E+=oe),C=$+1}}else{for(var fe=new Array(p),F=0;F<p;++F)fe[F]=String.fromCharCode(It[x+F]);E=fe.join("")}return $n(d),E},toWireType(d,p){p instanceof ArrayBuffer&&(p=new Uint8Array(p));var x,E=typeof p=="string";E||ArrayBuffer.isView(p)&&p.BYTES_PER_ELEMENT==1||xt("Cannot pass non-string to std::string"),h&&E?x=Ge(p):x=p.length;var C=ic(4+x+1),F=C+4;if($e[C>>2]=x,E)if(h)sr(p,F,x+1);else for(var $=0;$<x;++$){var Q=p.charCodeAt($);Q>255&&($n(C),xt("String has UTF-16 code units that do not fit in 8 bits")),It[F+$]=Q}else It.set(p,F);return d!==null&&d.push($n,C),C},argPackAdvance:ri,readValueFromPointer:Ta,destructorFunction(d){$n(d)}})},ru=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0,Dp=(s,o)=>{G(s%2==0,"Pointer passed to UTF16ToString must be aligned to two bytes!");for(var h=s>>1,d=h+o/2,p=h;!(p>=d)&&rn[p];)++p;if(p-h>16&&ru)return ru.decode(rn.subarray(h,p));for(var x="",E=h;!(E>=d);++E){var C=rn[E];if(C==0)break;x+=String.fromCharCode(C)}return x},Lp=(s,o,h)=>{if(G(o%2==0,"Pointer passed to stringToUTF16 must be aligned to two bytes!"),G(typeof h=="number","stringToUTF16(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),h??=2147483647,h<2)return 0;h-=2;for(var d=o,p=h<s.length*2?h/2:s.length,x=0;x<p;++x){var E=s.charCodeAt(x);Mt[o>>1]=E,o+=2}return Mt[o>>1]=0,o-d},Fp=s=>s.length*2,Np=(s,o)=>{G(s%4==0,"Pointer passed to UTF32ToString must be aligned to four bytes!");for(var h="",d=0;!(d>=o/4);d++){var p=De[s+d*4>>2];if(!p)break;h+=String.fromCodePoint(p)}return h},Up=(s,o,h)=>{if(G(o%4==0,"Pointer passed to stringToUTF32 must be aligned to four bytes!"),G(typeof h=="number","stringToUTF32(str, outPtr, maxBytesToWrite) is missing the third parameter that specifies the length of the output buffer!"),h??=2147483647,h<4)return 0;for(var d=o,p=d+h-4,x=0;x<s.length;++x){var E=s.codePointAt(x);if(E>65535&&x++,De[o>>2]=E,o+=4,o+4>p)break}return De[o>>2]=0,o-d},Op=s=>{for(var o=0,h=0;h<s.length;++h){var d=s.codePointAt(h);d>65535&&h++,o+=4}return o},Bp=(s,o,h)=>{h=Zt(h);var d,p,x,E;o===2?(d=Dp,p=Lp,E=Fp,x=C=>rn[C>>1]):o===4&&(d=Np,p=Up,E=Op,x=C=>$e[C>>2]),Bn(s,{name:h,fromWireType:C=>{for(var F=$e[C>>2],$,Q=C+4,oe=0;oe<=F;++oe){var fe=C+4+oe*o;if(oe==F||x(fe)==0){var ce=fe-Q,me=d(Q,ce);$===void 0?$=me:($+="\0",$+=me),Q=fe+o}}return $n(C),$},toWireType:(C,F)=>{typeof F!="string"&&xt(`Cannot pass non-string to C++ string type ${h}`);var $=E(F),Q=ic(4+$+o);return $e[Q>>2]=$/o,p(F,Q+4,$+o),C!==null&&C.push($n,Q),Q},argPackAdvance:ri,readValueFromPointer:Ta,destructorFunction(C){$n(C)}})},kp=(s,o)=>{iu(s)},zp=(s,o)=>{o=Zt(o),Bn(s,{isVoid:!0,name:o,argPackAdvance:0,fromWireType:()=>{},toWireType:(h,d)=>{}})},Gp=()=>{throw new ge},Ql=(s,o,h)=>{var d=[],p=s.toWireType(d,h);return d.length&&($e[o>>2]=Jt.toHandle(d)),p},Vp=(s,o,h)=>(s=Jt.toValue(s),o=Da(o,"emval::as"),Ql(o,h,s)),La=[],Hp=(s,o,h,d)=>(s=La[s],o=Jt.toValue(o),s(null,o,h,d)),Wp={},ec=s=>{var o=Wp[s];return o===void 0?Zt(s):o},Xp=(s,o,h,d,p)=>(s=La[s],o=Jt.toValue(o),h=ec(h),s(o,o[h],d,p)),su=()=>globalThis,$p=s=>s===0?Jt.toHandle(su()):(s=ec(s),Jt.toHandle(su()[s])),qp=s=>{var o=La.length;return La.push(s),o},Yp=(s,o)=>{for(var h=new Array(s),d=0;d<s;++d)h[d]=Da($e[o+d*4>>2],`parameter ${d}`);return h},jp=(s,o,h)=>{var d=Yp(s,o),p=d.shift();s--;var x=`return function (obj, func, destructorsRef, args) {
`,E=0,C=[];h===0&&C.push("obj");for(var F=["retType"],$=[p],Q=0;Q<s;++Q)C.push(`arg${Q}`),F.push(`argType${Q}`),$.push(d[Q]),x+=`  var arg${Q} = argType${Q}.readValueFromPointer(args${E?"+"+E:""});
`,E+=d[Q].argPackAdvance;var oe=h===1?"new func":"func.call";x+=`  var rv = ${oe}(${C.join(", ")});
`,p.isVoid||(F.push("emval_returnValue"),$.push(Ql),x+=`  return emval_returnValue(retType, destructorsRef, rv);
`),x+=`};
`;var fe=(me,Ye,vt,at)=>{for(var bt=h===0?[me]:[],nt=0;nt<s;++nt)bt.push(d[nt].readValueFromPointer(at)),at+=d[nt].argPackAdvance;var qt=h===1?new Ye(...bt):Ye.call(...bt);if(!p.isVoid)return Ql(p,vt,qt)},ce=`methodCaller<(${d.map(me=>me.name).join(", ")}) => ${p.name}>`;return qp(wa(ce,fe))},Zp=(s,o)=>(s=Jt.toValue(s),o=Jt.toValue(o),Jt.toHandle(s[o])),Jp=s=>{s>9&&(ai[s+1]+=1)},Kp=s=>(s=Jt.toValue(s),typeof s=="number"),Qp=s=>(s=Jt.toValue(s),typeof s=="string"),em=()=>Jt.toHandle([]),tm=s=>Jt.toHandle(ec(s)),nm=s=>{var o=Jt.toValue(s);Ra(o),Kl(s)},im=(s,o)=>{s=Da(s,"_emval_take_value");var h=s.readValueFromPointer(o);return Jt.toHandle(h)},rm=s=>{throw s=Jt.toValue(s),s},sm=s=>s%4===0&&(s%100!==0||s%400===0),am=[0,31,60,91,121,152,182,213,244,274,305,335],om=[0,31,59,90,120,151,181,212,243,273,304,334],au=s=>{var o=sm(s.getFullYear()),h=o?am:om,d=h[s.getMonth()]+s.getDate()-1;return d},lm=9007199254740992,cm=-9007199254740992,tc=s=>s<cm||s>lm?NaN:Number(s);function hm(s,o){s=tc(s);var h=new Date(s*1e3);De[o>>2]=h.getSeconds(),De[o+4>>2]=h.getMinutes(),De[o+8>>2]=h.getHours(),De[o+12>>2]=h.getDate(),De[o+16>>2]=h.getMonth(),De[o+20>>2]=h.getFullYear()-1900,De[o+24>>2]=h.getDay();var d=au(h)|0;De[o+28>>2]=d,De[o+36>>2]=-(h.getTimezoneOffset()*60);var p=new Date(h.getFullYear(),0,1),x=new Date(h.getFullYear(),6,1).getTimezoneOffset(),E=p.getTimezoneOffset(),C=(x!=E&&h.getTimezoneOffset()==Math.min(E,x))|0;De[o+32>>2]=C}var um=function(s){var o=(()=>{var h=new Date(De[s+20>>2]+1900,De[s+16>>2],De[s+12>>2],De[s+8>>2],De[s+4>>2],De[s>>2],0),d=De[s+32>>2],p=h.getTimezoneOffset(),x=new Date(h.getFullYear(),0,1),E=new Date(h.getFullYear(),6,1).getTimezoneOffset(),C=x.getTimezoneOffset(),F=Math.min(C,E);if(d<0)De[s+32>>2]=+(E!=C&&F==p);else if(d>0!=(F==p)){var $=Math.max(C,E),Q=d>0?F:$;h.setTime(h.getTime()+(Q-p)*6e4)}De[s+24>>2]=h.getDay();var oe=au(h)|0;De[s+28>>2]=oe,De[s>>2]=h.getSeconds(),De[s+4>>2]=h.getMinutes(),De[s+8>>2]=h.getHours(),De[s+12>>2]=h.getDate(),De[s+16>>2]=h.getMonth(),De[s+20>>2]=h.getYear();var fe=h.getTime();return isNaN(fe)?-1:fe/1e3})();return BigInt(o)},dm=(s,o,h,d)=>{var p=new Date().getFullYear(),x=new Date(p,0,1),E=new Date(p,6,1),C=x.getTimezoneOffset(),F=E.getTimezoneOffset(),$=Math.max(C,F);$e[s>>2]=$*60,De[o>>2]=+(C!=F);var Q=ce=>{var me=ce>=0?"-":"+",Ye=Math.abs(ce),vt=String(Math.floor(Ye/60)).padStart(2,"0"),at=String(Ye%60).padStart(2,"0");return`UTC${me}${vt}${at}`},oe=Q(C),fe=Q(F);G(oe),G(fe),G(Ge(oe)<=16,`timezone name truncated to fit in TZNAME_MAX (${oe})`),G(Ge(fe)<=16,`timezone name truncated to fit in TZNAME_MAX (${fe})`),F<C?(sr(oe,h,17),sr(fe,d,17)):(sr(oe,d,17),sr(fe,h,17))},ou=()=>performance.now(),lu=()=>Date.now(),fm=1,pm=s=>s>=0&&s<=3;function mm(s,o,h){if(o=tc(o),!pm(s))return 28;var d;if(s===0)d=lu();else if(fm)d=ou();else return 52;var p=Math.round(d*1e3*1e3);return W[h>>3]=BigInt(p),0}var Fa=[],gm=(s,o)=>{G(Array.isArray(Fa)),G(o%16==0),Fa.length=0;for(var h;h=It[s++];){var d=String.fromCharCode(h),p=["d","f","i","p"];p.push("j"),G(p.includes(d),`Invalid character ${h}("${d}") in readEmAsmArgs! Use only [${p}], and do not specify "v" for void return argument.`);var x=h!=105;x&=h!=112,o+=x&&o%8?4:0,Fa.push(h==112?$e[o>>2]:h==106?W[o>>3]:h==105?De[o>>2]:sn[o>>3]),o+=x?8:4}return Fa},_m=(s,o,h)=>{var d=gm(o,h);return G(pu.hasOwnProperty(s),`No EM_ASM constant found at address ${s}.  The loaded WebAssembly file is likely out of sync with the generated JavaScript.`),pu[s](...d)},vm=(s,o,h)=>_m(s,o,h),cu=()=>2147483648,ym=()=>cu(),xm=(s,o)=>(G(o,"alignment argument is required"),Math.ceil(s/o)*o),Sm=s=>{var o=Ht.buffer,h=(s-o.byteLength+65535)/65536|0;try{return Ht.grow(h),Ut(),1}catch(d){I(`growMemory: Attempted to grow heap from ${o.byteLength} bytes to ${s} bytes, but got error: ${d}`)}},Mm=s=>{var o=It.length;s>>>=0,G(s>o);var h=cu();if(s>h)return I(`Cannot enlarge memory, requested ${s} bytes, but the limit is ${h} bytes!`),!1;for(var d=1;d<=4;d*=2){var p=o*(1+.2/d);p=Math.min(p,s+100663296);var x=Math.min(h,xm(Math.max(s,p),65536)),E=Sm(x);if(E)return!0}return I(`Failed to grow the heap from ${o} bytes to ${x} bytes, not enough memory!`),!1},nc={},bm=()=>u||"./this.program",hs=()=>{if(!hs.strings){var s=(typeof navigator=="object"&&navigator.language||"C").replace("-","_")+".UTF-8",o={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:s,_:bm()};for(var h in nc)nc[h]===void 0?delete o[h]:o[h]=nc[h];var d=[];for(var h in o)d.push(`${h}=${o[h]}`);hs.strings=d}return hs.strings},wm=(s,o)=>{var h=0,d=0;for(var p of hs()){var x=o+h;$e[s+d>>2]=x,h+=sr(p,x,1/0)+1,d+=4}return 0},Em=(s,o)=>{var h=hs();$e[s>>2]=h.length;var d=0;for(var p of h)d+=Ge(p)+1;return $e[o>>2]=d,0},hu=0,uu=()=>Tt||hu>0,Tm=s=>{ie=s,uu()||(t.onExit?.(s),z=!0),m(s,new Ae(s))},Am=(s,o)=>{if(ie=s,G_(),uu()&&!o){var h=`program exited (with status: ${s}), but keepRuntimeAlive() is set (counter=${hu}) due to an async operation, so halting execution but not exiting the runtime or preventing further async execution (you can use emscripten_force_exit, if you want to force a true shutdown)`;mt?.(h),I(h)}Tm(s)},Cm=Am;function Rm(s){try{var o=ft.getStreamFromFD(s);return b.close(o),0}catch(h){if(typeof b>"u"||h.name!=="ErrnoError")throw h;return h.errno}}var Pm=(s,o,h,d)=>{for(var p=0,x=0;x<h;x++){var E=$e[o>>2],C=$e[o+4>>2];o+=8;var F=b.read(s,pt,E,C,d);if(F<0)return-1;if(p+=F,F<C)break;typeof d<"u"&&(d+=F)}return p};function Im(s,o,h,d){try{var p=ft.getStreamFromFD(s),x=Pm(p,o,h);return $e[d>>2]=x,0}catch(E){if(typeof b>"u"||E.name!=="ErrnoError")throw E;return E.errno}}function Dm(s,o,h,d){o=tc(o);try{if(isNaN(o))return 61;var p=ft.getStreamFromFD(s);return b.llseek(p,o,h),W[d>>3]=BigInt(p.position),p.getdents&&o===0&&h===0&&(p.getdents=null),0}catch(x){if(typeof b>"u"||x.name!=="ErrnoError")throw x;return x.errno}}var Lm=(s,o,h,d)=>{for(var p=0,x=0;x<h;x++){var E=$e[o>>2],C=$e[o+4>>2];o+=8;var F=b.write(s,pt,E,C,d);if(F<0)return-1;if(p+=F,F<C)break;typeof d<"u"&&(d+=F)}return p};function Fm(s,o,h,d){try{var p=ft.getStreamFromFD(s),x=Lm(p,o,h);return $e[d>>2]=x,0}catch(E){if(typeof b>"u"||E.name!=="ErrnoError")throw E;return E.errno}}var Nm=s=>s,Um=s=>{var o=t["_"+s];return G(o,"Cannot call unknown function "+s+", make sure it is exported"),o},Om=(s,o)=>{G(s.length>=0,"writeArrayToMemory array must have a length (should be an array or typed array)"),pt.set(s,o)},Na=s=>xu(s),Bm=s=>{var o=Ge(s)+1,h=Na(o);return sr(s,h,o),h},du=(s,o,h,d,p)=>{var x={string:me=>{var Ye=0;return me!=null&&me!==0&&(Ye=Bm(me)),Ye},array:me=>{var Ye=Na(me.length);return Om(me,Ye),Ye}};function E(me){return o==="string"?un(me):o==="boolean"?!!me:me}var C=Um(s),F=[],$=0;if(G(o!=="array",'Return type should not be "array".'),d)for(var Q=0;Q<d.length;Q++){var oe=x[h[Q]];oe?($===0&&($=_e()),F[Q]=oe(d[Q])):F[Q]=d[Q]}var fe=C(...F);function ce(me){return $!==0&&ye($),E(me)}return fe=ce(fe),fe},km=(s,o,h,d)=>(...p)=>du(s,o,h,p,d),zm=(...s)=>b.createPath(...s),Gm=(...s)=>b.unlink(...s),Vm=(...s)=>b.createLazyFile(...s),Hm=(...s)=>b.createDevice(...s),Wm=s=>Ua(s),Xm=s=>ac(s),$m=s=>{var o=_e(),h=Na(4),d=Na(4);Mu(s,h,d);var p=$e[h>>2],x=$e[d>>2],E=un(p);$n(p);var C;return x&&(C=un(x),$n(x)),ye(o),[E,C]},fu=s=>$m(s);b.createPreloadedFile=ti,b.staticInit(),rp(),dp(),G(ai.length===10),t.noExitRuntime&&(Tt=t.noExitRuntime),t.preloadPlugins&&(an=t.preloadPlugins),t.print&&(U=t.print),t.printErr&&(I=t.printErr),t.wasmBinary&&(ee=t.wasmBinary),jm(),t.arguments&&(f=t.arguments),t.thisProgram&&(u=t.thisProgram),G(typeof t.memoryInitializerPrefixURL>"u","Module.memoryInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.pthreadMainPrefixURL>"u","Module.pthreadMainPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.cdInitializerPrefixURL>"u","Module.cdInitializerPrefixURL option was removed, use Module.locateFile instead"),G(typeof t.filePackagePrefixURL>"u","Module.filePackagePrefixURL option was removed, use Module.locateFile instead"),G(typeof t.read>"u","Module.read option was removed"),G(typeof t.readAsync>"u","Module.readAsync option was removed (modify readAsync in JS)"),G(typeof t.readBinary>"u","Module.readBinary option was removed (modify readBinary in JS)"),G(typeof t.setWindowTitle>"u","Module.setWindowTitle option was removed (modify emscripten_set_window_title in JS)"),G(typeof t.TOTAL_MEMORY>"u","Module.TOTAL_MEMORY has been renamed Module.INITIAL_MEMORY"),G(typeof t.ENVIRONMENT>"u","Module.ENVIRONMENT has been deprecated. To force the environment, use the ENVIRONMENT compile-time option (for example, -sENVIRONMENT=web or -sENVIRONMENT=node)"),G(typeof t.STACK_SIZE>"u","STACK_SIZE can no longer be set at runtime.  Use -sSTACK_SIZE at link time"),G(typeof t.wasmMemory>"u","Use of `wasmMemory` detected.  Use -sIMPORTED_MEMORY to define wasmMemory externally"),G(typeof t.INITIAL_MEMORY>"u","Detected runtime INITIAL_MEMORY setting.  Use -sIMPORTED_MEMORY to define wasmMemory dynamically"),t.addRunDependency=ve,t.removeRunDependency=de,t.ccall=du,t.cwrap=km,t.FS_createPreloadedFile=ti,t.FS_unlink=Gm,t.FS_createPath=zm,t.FS_createDevice=Hm,t.FS=b,t.FS_createDataFile=jt,t.FS_createLazyFile=Vm,t.MEMFS=ke;var qm=["writeI53ToI64","writeI53ToI64Clamped","writeI53ToI64Signaling","writeI53ToU64Clamped","writeI53ToU64Signaling","readI53FromI64","readI53FromU64","convertI32PairToI53","convertI32PairToI53Checked","convertU32PairToI53","getTempRet0","zeroMemory","withStackSave","inetPton4","inetNtop4","inetPton6","inetNtop6","readSockaddr","writeSockaddr","emscriptenLog","runMainThreadEmAsm","jstoi_q","autoResumeAudioContext","getDynCaller","dynCall","handleException","runtimeKeepalivePush","runtimeKeepalivePop","callUserCallback","maybeExit","asmjsMangle","HandleAllocator","getNativeTypeSize","addOnInit","addOnPostCtor","addOnPreMain","addOnExit","STACK_SIZE","STACK_ALIGN","POINTER_SIZE","ASSERTIONS","uleb128Encode","sigToWasmTypes","generateFuncType","convertJsFunctionToWasm","getEmptyTableSlot","updateTableMap","getFunctionAddress","addFunction","removeFunction","reallyNegative","unSign","strLen","reSign","formatString","intArrayToString","stringToAscii","stringToNewUTF8","registerKeyEventCallback","maybeCStringToJsString","findEventTarget","getBoundingClientRect","fillMouseEventData","registerMouseEventCallback","registerWheelEventCallback","registerUiEventCallback","registerFocusEventCallback","fillDeviceOrientationEventData","registerDeviceOrientationEventCallback","fillDeviceMotionEventData","registerDeviceMotionEventCallback","screenOrientation","fillOrientationChangeEventData","registerOrientationChangeEventCallback","fillFullscreenChangeEventData","registerFullscreenChangeEventCallback","JSEvents_requestFullscreen","JSEvents_resizeCanvasForFullscreen","registerRestoreOldStyle","hideEverythingExceptGivenElement","restoreHiddenElements","setLetterbox","softFullscreenResizeWebGLRenderTarget","doRequestFullscreen","fillPointerlockChangeEventData","registerPointerlockChangeEventCallback","registerPointerlockErrorEventCallback","requestPointerLock","fillVisibilityChangeEventData","registerVisibilityChangeEventCallback","registerTouchEventCallback","fillGamepadEventData","registerGamepadEventCallback","registerBeforeUnloadEventCallback","fillBatteryEventData","battery","registerBatteryEventCallback","setCanvasElementSize","getCanvasElementSize","jsStackTrace","getCallstack","convertPCtoSourceLocation","wasiRightsToMuslOFlags","wasiOFlagsToMuslOFlags","safeSetTimeout","setImmediateWrapped","safeRequestAnimationFrame","clearImmediateWrapped","registerPostMainLoop","registerPreMainLoop","getPromise","makePromise","idsToPromises","makePromiseCallback","Browser_asyncPrepareDataCounter","arraySum","addDays","getSocketFromFD","getSocketAddress","FS_mkdirTree","_setNetworkCallback","heapObjectForWebGLType","toTypedArrayIndex","webgl_enable_ANGLE_instanced_arrays","webgl_enable_OES_vertex_array_object","webgl_enable_WEBGL_draw_buffers","webgl_enable_WEBGL_multi_draw","webgl_enable_EXT_polygon_offset_clamp","webgl_enable_EXT_clip_control","webgl_enable_WEBGL_polygon_mode","emscriptenWebGLGet","computeUnpackAlignedImageSize","colorChannelsInGlTextureFormat","emscriptenWebGLGetTexPixelData","emscriptenWebGLGetUniform","webglGetUniformLocation","webglPrepareUniformLocationsBeforeFirstUse","webglGetLeftBracePos","emscriptenWebGLGetVertexAttrib","__glGetActiveAttribOrUniform","writeGLArray","registerWebGlEventCallback","runAndAbortIfError","ALLOC_NORMAL","ALLOC_STACK","allocate","writeStringToMemory","writeAsciiToMemory","demangle","stackTrace","getFunctionArgsName","createJsInvokerSignature","PureVirtualError","registerInheritedInstance","unregisterInheritedInstance","getInheritedInstanceCount","getLiveInheritedInstances","setDelayFunction","count_emval_handles"];qm.forEach(Qe);var Ym=["run","out","err","callMain","abort","wasmMemory","wasmExports","HEAPF32","HEAPF64","HEAP8","HEAPU8","HEAP16","HEAPU16","HEAP32","HEAPU32","HEAP64","HEAPU64","writeStackCookie","checkStackCookie","INT53_MAX","INT53_MIN","bigintToI53Checked","stackSave","stackRestore","stackAlloc","setTempRet0","ptrToString","exitJS","getHeapMax","growMemory","ENV","ERRNO_CODES","strError","DNS","Protocols","Sockets","timers","warnOnce","readEmAsmArgsArray","readEmAsmArgs","runEmAsmFunction","getExecutableName","keepRuntimeAlive","asyncLoad","alignMemory","mmapAlloc","wasmTable","getUniqueRunDependency","noExitRuntime","addOnPreRun","addOnPostRun","freeTableIndexes","functionsInTableMap","setValue","getValue","PATH","PATH_FS","UTF8Decoder","UTF8ArrayToString","UTF8ToString","stringToUTF8Array","stringToUTF8","lengthBytesUTF8","intArrayFromString","AsciiToString","UTF16Decoder","UTF16ToString","stringToUTF16","lengthBytesUTF16","UTF32ToString","stringToUTF32","lengthBytesUTF32","stringToUTF8OnStack","writeArrayToMemory","JSEvents","specialHTMLTargets","findCanvasEventTarget","currentFullscreenStrategy","restoreOldWindowedStyle","UNWIND_CACHE","ExitStatus","getEnvStrings","checkWasiClock","doReadv","doWritev","initRandomFill","randomFill","emSetImmediate","emClearImmediate_deps","emClearImmediate","promiseMap","uncaughtExceptionCount","exceptionLast","exceptionCaught","ExceptionInfo","findMatchingCatch","getExceptionMessageCommon","Browser","requestFullscreen","requestFullScreen","setCanvasSize","getUserMedia","createContext","getPreloadedImageData__data","wget","MONTH_DAYS_REGULAR","MONTH_DAYS_LEAP","MONTH_DAYS_REGULAR_CUMULATIVE","MONTH_DAYS_LEAP_CUMULATIVE","isLeapYear","ydayFromDate","SYSCALLS","preloadPlugins","FS_modeStringToFlags","FS_getMode","FS_stdin_getChar_buffer","FS_stdin_getChar","FS_readFile","FS_root","FS_mounts","FS_devices","FS_streams","FS_nextInode","FS_nameTable","FS_currentPath","FS_initialized","FS_ignorePermissions","FS_filesystems","FS_syncFSRequests","FS_readFiles","FS_lookupPath","FS_getPath","FS_hashName","FS_hashAddNode","FS_hashRemoveNode","FS_lookupNode","FS_createNode","FS_destroyNode","FS_isRoot","FS_isMountpoint","FS_isFile","FS_isDir","FS_isLink","FS_isChrdev","FS_isBlkdev","FS_isFIFO","FS_isSocket","FS_flagsToPermissionString","FS_nodePermissions","FS_mayLookup","FS_mayCreate","FS_mayDelete","FS_mayOpen","FS_checkOpExists","FS_nextfd","FS_getStreamChecked","FS_getStream","FS_createStream","FS_closeStream","FS_dupStream","FS_doSetAttr","FS_chrdev_stream_ops","FS_major","FS_minor","FS_makedev","FS_registerDevice","FS_getDevice","FS_getMounts","FS_syncfs","FS_mount","FS_unmount","FS_lookup","FS_mknod","FS_statfs","FS_statfsStream","FS_statfsNode","FS_create","FS_mkdir","FS_mkdev","FS_symlink","FS_rename","FS_rmdir","FS_readdir","FS_readlink","FS_stat","FS_fstat","FS_lstat","FS_doChmod","FS_chmod","FS_lchmod","FS_fchmod","FS_doChown","FS_chown","FS_lchown","FS_fchown","FS_doTruncate","FS_truncate","FS_ftruncate","FS_utime","FS_open","FS_close","FS_isClosed","FS_llseek","FS_read","FS_write","FS_mmap","FS_msync","FS_ioctl","FS_writeFile","FS_cwd","FS_chdir","FS_createDefaultDirectories","FS_createDefaultDevices","FS_createSpecialDirectories","FS_createStandardStreams","FS_staticInit","FS_init","FS_quit","FS_findObject","FS_analyzePath","FS_createFile","FS_forceLoadFile","FS_absolutePath","FS_createFolder","FS_createLink","FS_joinPath","FS_mmapAlloc","FS_standardizePath","TTY","PIPEFS","SOCKFS","tempFixedLengthArray","miniTempWebGLFloatBuffers","miniTempWebGLIntBuffers","GL","AL","GLUT","EGL","GLEW","IDBStore","SDL","SDL_gfx","allocateUTF8","allocateUTF8OnStack","print","printErr","jstoi_s","InternalError","BindingError","throwInternalError","throwBindingError","registeredTypes","awaitingDependencies","typeDependencies","tupleRegistrations","structRegistrations","sharedRegisterType","whenDependentTypesAreResolved","getTypeName","getFunctionName","heap32VectorToArray","requireRegisteredType","usesDestructorStack","checkArgCount","getRequiredArgCount","createJsInvoker","UnboundTypeError","GenericWireTypeSize","EmValType","EmValOptionalType","throwUnboundTypeError","ensureOverloadTable","exposePublicSymbol","replacePublicSymbol","createNamedFunction","embindRepr","registeredInstances","getBasestPointer","getInheritedInstance","registeredPointers","registerType","integerReadValueFromPointer","enumReadValueFromPointer","floatReadValueFromPointer","assertIntegerRange","readPointer","runDestructors","craftInvokerFunction","embind__requireFunction","genericPointerToWireType","constNoSmartPtrRawPointerToWireType","nonConstNoSmartPtrRawPointerToWireType","init_RegisteredPointer","RegisteredPointer","RegisteredPointer_fromWireType","runDestructor","releaseClassHandle","finalizationRegistry","detachFinalizer_deps","detachFinalizer","attachFinalizer","makeClassHandle","init_ClassHandle","ClassHandle","throwInstanceAlreadyDeleted","deletionQueue","flushPendingDeletes","delayFunction","RegisteredClass","shallowCopyInternalPointer","downcastPointer","upcastPointer","validateThis","char_0","char_9","makeLegalFunctionName","emval_freelist","emval_handles","emval_symbols","getStringOrSymbol","Emval","emval_get_global","emval_returnValue","emval_lookupTypes","emval_methodCallers","emval_addMethodCaller"];Ym.forEach(Et),t.incrementExceptionRefcount=Wm,t.decrementExceptionRefcount=Xm,t.getExceptionMessage=fu;function jm(){Ze("fetchSettings")}var pu={679512:()=>{typeof t<"u"&&"mjDISABLESTRING mjENABLESTRING mjFRAMESTRING mjLABELSTRING mjRNDSTRING mjTIMERSTRING mjVISSTRING".split(" ").forEach(function(s){Object.defineProperty(t,s,{get:function(){return t["get_"+s]()},set:function(o){},enumerable:!0,configurable:!0})})}},mu=Pe("___getTypeName"),ic=Pe("_malloc"),Zm=Pe("___cxa_free_exception"),rc=Pe("_fflush"),$n=Pe("_free"),sc=Pe("_emscripten_stack_get_end"),Jm=Pe("_emscripten_stack_get_base"),gu=Pe("_strerror"),xe=Pe("_setThrew"),_u=Pe("__emscripten_tempret_set"),vu=Pe("_emscripten_stack_init"),Km=Pe("_emscripten_stack_get_free"),yu=Pe("__emscripten_stack_restore"),xu=Pe("__emscripten_stack_alloc"),Su=Pe("_emscripten_stack_get_current"),ac=Pe("___cxa_decrement_exception_refcount"),Ua=Pe("___cxa_increment_exception_refcount"),Mu=Pe("___get_exception_message"),bu=Pe("___cxa_can_catch"),wu=Pe("___cxa_get_exception_ptr");function Qm(s){mu=Me("__getTypeName",1),ic=Me("malloc",1),Zm=Me("__cxa_free_exception",1),rc=Me("fflush",1),$n=Me("free",1),sc=s.emscripten_stack_get_end,Jm=s.emscripten_stack_get_base,gu=Me("strerror",1),xe=Me("setThrew",2),_u=Me("_emscripten_tempret_set",1),vu=s.emscripten_stack_init,Km=s.emscripten_stack_get_free,yu=s._emscripten_stack_restore,xu=s._emscripten_stack_alloc,Su=s.emscripten_stack_get_current,ac=Me("__cxa_decrement_exception_refcount",1),Ua=Me("__cxa_increment_exception_refcount",1),Mu=Me("__get_exception_message",3),bu=Me("__cxa_can_catch",3),wu=Me("__cxa_get_exception_ptr",1)}var Eu={__assert_fail:as,__cxa_begin_catch:xr,__cxa_current_primary_exception:_a,__cxa_end_catch:er,__cxa_find_matching_catch_2:Wl,__cxa_find_matching_catch_3:Xl,__cxa_find_matching_catch_4:$l,__cxa_rethrow:os,__cxa_rethrow_primary_exception:R,__cxa_throw:V,__cxa_uncaught_exceptions:te,__resumeException:K,__syscall_dup3:Rn,__syscall_fcntl64:Wn,__syscall_fstat64:va,__syscall_ioctl:Vf,__syscall_lstat64:Hf,__syscall_newfstatat:Wf,__syscall_openat:Xf,__syscall_stat64:$f,_abort_js:qf,_embind_register_bigint:jf,_embind_register_bool:Zf,_embind_register_class:pp,_embind_register_class_class_function:gp,_embind_register_class_constructor:_p,_embind_register_class_function:vp,_embind_register_class_property:yp,_embind_register_constant:xp,_embind_register_emval:iu,_embind_register_enum:Mp,_embind_register_enum_value:bp,_embind_register_float:Ep,_embind_register_function:Tp,_embind_register_integer:Ap,_embind_register_memory_view:Cp,_embind_register_optional:Pp,_embind_register_std_string:Ip,_embind_register_std_wstring:Bp,_embind_register_user_type:kp,_embind_register_void:zp,_emscripten_throw_longjmp:Gp,_emval_as:Vp,_emval_call:Hp,_emval_call_method:Xp,_emval_decref:Kl,_emval_get_global:$p,_emval_get_method_caller:jp,_emval_get_property:Zp,_emval_incref:Jp,_emval_is_number:Kp,_emval_is_string:Qp,_emval_new_array:em,_emval_new_cstring:tm,_emval_run_destructors:nm,_emval_take_value:im,_emval_throw:rm,_localtime_js:hm,_mktime_js:um,_tzset_js:dm,clock_time_get:mm,emscripten_asm_const_int:vm,emscripten_date_now:lu,emscripten_get_heap_max:ym,emscripten_get_now:ou,emscripten_resize_heap:Mm,environ_get:wm,environ_sizes_get:Em,exit:Cm,fd_close:Rm,fd_read:Im,fd_seek:Dm,fd_write:Fm,invoke_ddd:T_,invoke_dddi:Hg,invoke_dddidi:Wg,invoke_ddidi:Vg,invoke_di:Xg,invoke_dii:Lg,invoke_diii:fg,invoke_diiii:Gg,invoke_diiiidd:kg,invoke_diiiidi:gg,invoke_diiiii:lg,invoke_diiiiii:Mg,invoke_diiiiiii:$g,invoke_diiiiiiiii:xg,invoke_diiiiiiiiiiii:Sg,invoke_fiii:O_,invoke_i:cg,invoke_id:u_,invoke_ii:ng,invoke_iid:n_,invoke_iidddd:I_,invoke_iidiii:Pg,invoke_iidiiid:Cg,invoke_iidiiiiidi:Ig,invoke_iif:P_,invoke_iii:eg,invoke_iiid:Dg,invoke_iiididdddddd:Rg,invoke_iiidiiiiiiii:Ag,invoke_iiii:sg,invoke_iiiidddiiiii:Yg,invoke_iiiii:dg,invoke_iiiiid:f_,invoke_iiiiii:o_,invoke_iiiiiii:r_,invoke_iiiiiiii:t_,invoke_iiiiiiiidd:p_,invoke_iiiiiiiii:Bg,invoke_iiiiiiiiii:s_,invoke_iiiiiiiiiidddiiiiiiiii:Tg,invoke_iiiiiiiiiii:U_,invoke_iiiiiiiiiiii:B_,invoke_iiiiiiiiiiiii:y_,invoke_iiij:a_,invoke_iiji:d_,invoke_j:F_,invoke_ji:w_,invoke_jiiii:l_,invoke_jij:E_,invoke_v:rg,invoke_vi:ig,invoke_vid:i_,invoke_viddd:c_,invoke_vidddd:h_,invoke_vidi:zg,invoke_vidiii:wg,invoke_vii:og,invoke_viid:Ug,invoke_viiddi:v_,invoke_viiddidi:__,invoke_viiddii:qg,invoke_viidi:Ng,invoke_viidii:mg,invoke_viidiii:Qg,invoke_viidiiid:Jg,invoke_viidiiiii:Eg,invoke_viidiiiiidi:e_,invoke_viidiiiiiiii:bg,invoke_viii:tg,invoke_viiid:vg,invoke_viiidd:g_,invoke_viiidi:Fg,invoke_viiididdddddd:Kg,invoke_viiidiiiiiiii:Zg,invoke_viiii:ug,invoke_viiiiddd:m_,invoke_viiiidi:A_,invoke_viiiifi:C_,invoke_viiiii:ag,invoke_viiiiid:_g,invoke_viiiiii:hg,invoke_viiiiiii:pg,invoke_viiiiiiii:Og,invoke_viiiiiiiiii:M_,invoke_viiiiiiiiiidddiiiiiiiii:jg,invoke_viiiiiiiiiiid:yg,invoke_viiiiiiiiiiiii:S_,invoke_viiiiiiiiiiiiiii:k_,invoke_viiiiiiiiiiiiiiiiii:b_,invoke_viiiij:D_,invoke_viij:L_,invoke_viijii:N_,invoke_vij:R_,invoke_vijjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjjj:x_,llvm_eh_typeid_for:Nm},ar=await Ee();function eg(s,o,h){var d=_e();try{return be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function tg(s,o,h,d){var p=_e();try{be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function ng(s,o){var h=_e();try{return be(s)(o)}catch(d){if(ye(h),!(d instanceof H))throw d;xe(1,0)}}function ig(s,o){var h=_e();try{be(s)(o)}catch(d){if(ye(h),!(d instanceof H))throw d;xe(1,0)}}function rg(s){var o=_e();try{be(s)()}catch(h){if(ye(o),!(h instanceof H))throw h;xe(1,0)}}function sg(s,o,h,d){var p=_e();try{return be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function ag(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function og(s,o,h){var d=_e();try{be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function lg(s,o,h,d,p,x){var E=_e();try{return be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function cg(s){var o=_e();try{return be(s)()}catch(h){if(ye(o),!(h instanceof H))throw h;xe(1,0)}}function hg(s,o,h,d,p,x,E){var C=_e();try{be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function ug(s,o,h,d,p){var x=_e();try{be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;xe(1,0)}}function dg(s,o,h,d,p){var x=_e();try{return be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;xe(1,0)}}function fg(s,o,h,d){var p=_e();try{return be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function pg(s,o,h,d,p,x,E,C){var F=_e();try{be(s)(o,h,d,p,x,E,C)}catch($){if(ye(F),!($ instanceof H))throw $;xe(1,0)}}function mg(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function gg(s,o,h,d,p,x,E){var C=_e();try{return be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function _g(s,o,h,d,p,x,E){var C=_e();try{be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function vg(s,o,h,d,p){var x=_e();try{be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;xe(1,0)}}function yg(s,o,h,d,p,x,E,C,F,$,Q,oe,fe){var ce=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function xg(s,o,h,d,p,x,E,C,F,$){var Q=_e();try{return be(s)(o,h,d,p,x,E,C,F,$)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function Sg(s,o,h,d,p,x,E,C,F,$,Q,oe,fe){var ce=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Mg(s,o,h,d,p,x,E){var C=_e();try{return be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function bg(s,o,h,d,p,x,E,C,F,$,Q,oe){var fe=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function wg(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function Eg(s,o,h,d,p,x,E,C,F){var $=_e();try{be(s)(o,h,d,p,x,E,C,F)}catch(Q){if(ye($),!(Q instanceof H))throw Q;xe(1,0)}}function Tg(s,o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt){var xn=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt)}catch(Nt){if(ye(xn),!(Nt instanceof H))throw Nt;xe(1,0)}}function Ag(s,o,h,d,p,x,E,C,F,$,Q,oe){var fe=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function Cg(s,o,h,d,p,x,E){var C=_e();try{return be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function Rg(s,o,h,d,p,x,E,C,F,$,Q,oe){var fe=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function Pg(s,o,h,d,p,x){var E=_e();try{return be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function Ig(s,o,h,d,p,x,E,C,F,$){var Q=_e();try{return be(s)(o,h,d,p,x,E,C,F,$)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function Dg(s,o,h,d){var p=_e();try{return be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function Lg(s,o,h){var d=_e();try{return be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function Fg(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function Ng(s,o,h,d,p){var x=_e();try{be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;xe(1,0)}}function Ug(s,o,h,d){var p=_e();try{be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function Og(s,o,h,d,p,x,E,C,F){var $=_e();try{be(s)(o,h,d,p,x,E,C,F)}catch(Q){if(ye($),!(Q instanceof H))throw Q;xe(1,0)}}function Bg(s,o,h,d,p,x,E,C,F){var $=_e();try{return be(s)(o,h,d,p,x,E,C,F)}catch(Q){if(ye($),!(Q instanceof H))throw Q;xe(1,0)}}function kg(s,o,h,d,p,x,E){var C=_e();try{return be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function zg(s,o,h,d){var p=_e();try{be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function Gg(s,o,h,d,p){var x=_e();try{return be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;xe(1,0)}}function Vg(s,o,h,d,p){var x=_e();try{return be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;xe(1,0)}}function Hg(s,o,h,d){var p=_e();try{return be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function Wg(s,o,h,d,p,x){var E=_e();try{return be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function Xg(s,o){var h=_e();try{return be(s)(o)}catch(d){if(ye(h),!(d instanceof H))throw d;xe(1,0)}}function $g(s,o,h,d,p,x,E,C){var F=_e();try{return be(s)(o,h,d,p,x,E,C)}catch($){if(ye(F),!($ instanceof H))throw $;xe(1,0)}}function qg(s,o,h,d,p,x,E){var C=_e();try{be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function Yg(s,o,h,d,p,x,E,C,F,$,Q,oe){var fe=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function jg(s,o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,xn){var Nt=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,xn)}catch(or){if(ye(Nt),!(or instanceof H))throw or;xe(1,0)}}function Zg(s,o,h,d,p,x,E,C,F,$,Q,oe,fe){var ce=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Jg(s,o,h,d,p,x,E,C){var F=_e();try{be(s)(o,h,d,p,x,E,C)}catch($){if(ye(F),!($ instanceof H))throw $;xe(1,0)}}function Kg(s,o,h,d,p,x,E,C,F,$,Q,oe,fe){var ce=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function Qg(s,o,h,d,p,x,E){var C=_e();try{be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function e_(s,o,h,d,p,x,E,C,F,$,Q){var oe=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function t_(s,o,h,d,p,x,E,C){var F=_e();try{return be(s)(o,h,d,p,x,E,C)}catch($){if(ye(F),!($ instanceof H))throw $;xe(1,0)}}function n_(s,o,h){var d=_e();try{return be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function i_(s,o,h){var d=_e();try{be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function r_(s,o,h,d,p,x,E){var C=_e();try{return be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function s_(s,o,h,d,p,x,E,C,F,$){var Q=_e();try{return be(s)(o,h,d,p,x,E,C,F,$)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function a_(s,o,h,d){var p=_e();try{return be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function o_(s,o,h,d,p,x){var E=_e();try{return be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function l_(s,o,h,d,p){var x=_e();try{return be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;return xe(1,0),0n}}function c_(s,o,h,d,p){var x=_e();try{be(s)(o,h,d,p)}catch(E){if(ye(x),!(E instanceof H))throw E;xe(1,0)}}function h_(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function u_(s,o){var h=_e();try{return be(s)(o)}catch(d){if(ye(h),!(d instanceof H))throw d;xe(1,0)}}function d_(s,o,h,d){var p=_e();try{return be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function f_(s,o,h,d,p,x){var E=_e();try{return be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function p_(s,o,h,d,p,x,E,C,F,$){var Q=_e();try{return be(s)(o,h,d,p,x,E,C,F,$)}catch(oe){if(ye(Q),!(oe instanceof H))throw oe;xe(1,0)}}function m_(s,o,h,d,p,x,E,C){var F=_e();try{be(s)(o,h,d,p,x,E,C)}catch($){if(ye(F),!($ instanceof H))throw $;xe(1,0)}}function g_(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function __(s,o,h,d,p,x,E,C){var F=_e();try{be(s)(o,h,d,p,x,E,C)}catch($){if(ye(F),!($ instanceof H))throw $;xe(1,0)}}function v_(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function y_(s,o,h,d,p,x,E,C,F,$,Q,oe,fe){var ce=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe)}catch(me){if(ye(ce),!(me instanceof H))throw me;xe(1,0)}}function x_(s,o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,xn,Nt,or,H_,W_,X_,$_,q_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,C0,R0,P0,I0,D0,L0,F0,N0,U0,O0,B0,k0,z0,G0,V0,H0,W0,X0,$0,q0,Y0,j0){var Z0=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt,nt,qt,Kt,xn,Nt,or,H_,W_,X_,$_,q_,Y_,j_,Z_,J_,K_,Q_,e0,t0,n0,i0,r0,s0,a0,o0,l0,c0,h0,u0,d0,f0,p0,m0,g0,_0,v0,y0,x0,S0,M0,b0,w0,E0,T0,A0,C0,R0,P0,I0,D0,L0,F0,N0,U0,O0,B0,k0,z0,G0,V0,H0,W0,X0,$0,q0,Y0,j0)}catch(Au){if(ye(Z0),!(Au instanceof H))throw Au;xe(1,0)}}function S_(s,o,h,d,p,x,E,C,F,$,Q,oe,fe,ce){var me=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe,ce)}catch(Ye){if(ye(me),!(Ye instanceof H))throw Ye;xe(1,0)}}function M_(s,o,h,d,p,x,E,C,F,$,Q){var oe=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function b_(s,o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt){var nt=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye,vt,at,bt)}catch(qt){if(ye(nt),!(qt instanceof H))throw qt;xe(1,0)}}function w_(s,o){var h=_e();try{return be(s)(o)}catch(d){if(ye(h),!(d instanceof H))throw d;return xe(1,0),0n}}function E_(s,o,h){var d=_e();try{return be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;return xe(1,0),0n}}function T_(s,o,h){var d=_e();try{return be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function A_(s,o,h,d,p,x,E){var C=_e();try{be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function C_(s,o,h,d,p,x,E){var C=_e();try{be(s)(o,h,d,p,x,E)}catch(F){if(ye(C),!(F instanceof H))throw F;xe(1,0)}}function R_(s,o,h){var d=_e();try{be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function P_(s,o,h){var d=_e();try{return be(s)(o,h)}catch(p){if(ye(d),!(p instanceof H))throw p;xe(1,0)}}function I_(s,o,h,d,p,x){var E=_e();try{return be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function D_(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function L_(s,o,h,d){var p=_e();try{be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function F_(s){var o=_e();try{return be(s)()}catch(h){if(ye(o),!(h instanceof H))throw h;return xe(1,0),0n}}function N_(s,o,h,d,p,x){var E=_e();try{be(s)(o,h,d,p,x)}catch(C){if(ye(E),!(C instanceof H))throw C;xe(1,0)}}function U_(s,o,h,d,p,x,E,C,F,$,Q){var oe=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q)}catch(fe){if(ye(oe),!(fe instanceof H))throw fe;xe(1,0)}}function O_(s,o,h,d){var p=_e();try{return be(s)(o,h,d)}catch(x){if(ye(p),!(x instanceof H))throw x;xe(1,0)}}function B_(s,o,h,d,p,x,E,C,F,$,Q,oe){var fe=_e();try{return be(s)(o,h,d,p,x,E,C,F,$,Q,oe)}catch(ce){if(ye(fe),!(ce instanceof H))throw ce;xe(1,0)}}function k_(s,o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye){var vt=_e();try{be(s)(o,h,d,p,x,E,C,F,$,Q,oe,fe,ce,me,Ye)}catch(at){if(ye(vt),!(at instanceof H))throw at;xe(1,0)}}var Tu;function z_(){vu(),Se()}function oc(){if(Ke>0){L=oc;return}if(z_(),Le(),Ke>0){L=oc;return}function s(){G(!Tu),Tu=!0,t.calledRun=!0,!z&&($t(),Ct?.(t),t.onRuntimeInitialized?.(),Fe("onRuntimeInitialized"),G(!t._main,'compiled without a main, but one is present. if you added it from JS, use Module["onRuntimeInitialized"]'),Je())}t.setStatus?(t.setStatus("Running..."),setTimeout(()=>{setTimeout(()=>t.setStatus(""),1),s()},1)):s(),re()}function G_(){var s=U,o=I,h=!1;U=I=d=>{h=!0};try{rc(0),["stdout","stderr"].forEach(d=>{var p=b.analyzePath("/dev/"+d);if(p){var x=p.object,E=x.rdev,C=lt.ttys[E];C?.output?.length&&(h=!0)}})}catch{}U=s,I=o,h&&ei("stdio streams had content in them that was not flushed. you should set EXIT_RUNTIME to 1 (see the Emscripten FAQ), or make sure to emit a newline when you printf etc.")}function V_(){if(t.preInit)for(typeof t.preInit=="function"&&(t.preInit=[t.preInit]);t.preInit.length>0;)t.preInit.shift()();Fe("preInit")}V_(),oc(),Rt?e=t:e=new Promise((s,o)=>{Ct=s,mt=o});for(let s of Object.keys(t))s in i||Object.defineProperty(i,s,{configurable:!0,get(){pe(`Access to module property ('${s}') is no longer possible via the module constructor argument; Instead, use the result of the module constructor.`)}});return e}),Du=av;var Lu=i=>Du({wasmBinary:i});function ov([i,e,t,n]){return[1-2*(t*t+n*n),2*(e*t-i*n),2*(e*n+i*t),2*(e*t+i*n),1-2*(e*e+n*n),2*(t*n-i*e),2*(e*n-i*t),2*(t*n+i*e),1-2*(e*e+t*t)]}var lv=([i,e,t,n])=>Math.atan2(2*(i*n+e*t),1-2*(t*t+n*n)),cv=i=>Math.abs(i%1)===.5?2*Math.round(i/2):Math.round(i);function hv(i,e,t){let n=new i.MjVFS;for(let[a,l]of Object.entries(t))n.addBuffer(a,Uint8Array.from(atob(l),c=>c.charCodeAt(0)));let r=i.MjModel.from_xml_string(e,n);return n.delete(),r}var ps=class{constructor(e,t,n){this.mujoco=e,this.robot=n,this.model=hv(e,t.xml,n.files),t.heights&&this.model.hfield_data.set(t.heights),this.data=new e.MjData(this.model),this.base=e.mj_name2id(this.model,e.mjtObj.mjOBJ_BODY.value,n.base),this.gravity=Math.hypot(...this.model.opt.gravity),this.compiled={mass:this.model.body_mass[this.base],inertia:this.model.body_inertia.slice(3*this.base,3*this.base+3)},this.play=new Float64Array(n.start.length-7),this.reset()}delete(){this.data.delete(),this.model.delete()}reset(e=this.robot.start){let{mujoco:t,model:n,data:r}=this,a=e.slice(7);if(t.mj_resetData(n,r),r.qpos.set(e),r.ctrl.set(a),this.play.set(a),n.nhistory){let{actuator_historyadr:l,actuator_history:c}=n,f=c.length/n.nu;a.forEach((u,m)=>{let v=l[m]+2+c[f*m];l[m]>=0&&r.history.fill(u,v,v+c[f*m])})}t.mj_forward(n,r),this.settled=!0}step(e){let{mujoco:t,model:n,data:r,robot:a}=this;r.ctrl.set(a.servo?this.servoTarget(e):e);for(let l=0;l<a.decimation;l++)this.settled||t.mj_step1(n,r),t.mj_step2(n,r),t.mj_step1(n,r),this.settled=!0}servoTarget(e){let{target_step:t,backlash:n,dead_band:r}=this.robot.servo,a=this.reading("joint_position");return Array.from(e,(l,c)=>{let f=t[c]>0?t[c]*cv(l/t[c]):l;this.play[c]=Math.min(Math.max(this.play[c],f-n[c]/2),f+n[c]/2);let u=this.play[c]-a[c];return this.play[c]-Math.min(Math.max(u,-r[c]),r[c])})}reading(e){return this.data.sensordata.slice(...this.robot.columns[e])}projectedGravity(){let e=ov(this.reading("orientation")),t=this.model.opt.gravity;return[0,1,2].map(n=>(e[n]*t[0]+e[3+n]*t[1]+e[6+n]*t[2])/this.gravity)}position(){return this.data.qpos.slice(0,3)}yaw(){return lv(this.data.qpos.slice(3,7))}fallen(){return!(this.projectedGravity()[2]<-.5)||this.reading("trunk_force")[0]>0||!Number.isFinite(this.data.qpos[0])}push(e){let{qvel:t}=this.data;e.forEach((n,r)=>{t[r]+=n}),this.settled=!1}setFriction(e){let{geom_friction:t}=this.model;for(let n=0;n<t.length;n+=3)t[n]=e;this.settled=!1}setPayload(e){let{mujoco:t,model:n,base:r,compiled:a}=this,l=a.mass+e;n.body_mass[r]=l,a.inertia.forEach((f,u)=>{n.body_inertia[3*r+u]=f*l/a.mass});let c=new t.MjData(n);t.mj_setConst(n,c),c.delete(),this.settled=!1}setSlope(e){this.model.opt.gravity.set([-this.gravity*Math.sin(e),0,-this.gravity*Math.cos(e)]),this.settled=!1}};var ji={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Zi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ud=0,Wc=1,dd=2;var pr=1,fd=2,Zr=3,Ji=0,dn=1,pi=2,mr=0,Jr=1,Xc=2,$c=3,qc=4,pd=5;var gr=100,md=101,gd=102,_d=103,vd=104,yd=200,xd=201,Sd=202,Md=203,Yc=204,jc=205,bd=206,wd=207,Ed=208,Td=209,Ad=210,Cd=211,Rd=212,Pd=213,Id=214,go=0,_o=1,vo=2,kr=3,yo=4,xo=5,So=6,Mo=7,qo=0,Dd=1,Ld=2,mi=0,Zc=1,Jc=2,Kc=3,Qc=4,eh=5,th=6,ea=7;var nh=300,_r=301,Kr=302,Yo=303,jo=304,zr=1e3,li=1001,bo=1002,cn=1003,Fd=1004;var ta=1005;var Mn=1006,Zo=1007;var Pi=1008;var An=1009,ih=1010,rh=1011,Qr=1012,Jo=1013,Jn=1014,Vn=1015,Kn=1016,Ko=1017,Qo=1018,vr=1020,sh=35902,ah=35899,oh=1021,lh=1022,Qn=1023,Ti=1026,Ii=1027,el=1028,tl=1029,Ki=1030,nl=1031;var il=1033,na=33776,ia=33777,ra=33778,sa=33779,rl=35840,sl=35841,al=35842,ol=35843,ll=36196,cl=37492,hl=37496,ul=37488,dl=37489,aa=37490,fl=37491,pl=37808,ml=37809,gl=37810,_l=37811,vl=37812,yl=37813,xl=37814,Sl=37815,Ml=37816,bl=37817,wl=37818,El=37819,Tl=37820,Al=37821,Cl=36492,Rl=36494,Pl=36495,Il=36283,Dl=36284,oa=36285,Ll=36286;var Es=2300,wo=2301,po=2302,Nc=2303,Uc=2400,Oc=2401,Bc=2402;var Nd=3200;var la=0,Ud=1,Di="",gn="srgb",Ts="srgb-linear",As="linear",Pt="srgb";var mo=7680;var Od=519,Bd=512,kd=513,zd=514,ch=515,Gd=516,Vd=517,hh=518,uh=519,Hd=35044;var dh="300 es",zn=2e3,Gr=2001;function uv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function dv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Cs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Wd(){let i=Cs("canvas");return i.style.display="block",i}var Fu={},Vr=null;function fh(...i){let e="THREE."+i.shift();Vr?Vr("log",e,...i):console.log(e,...i)}function Xd(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function et(...i){i=Xd(i);let e="THREE."+i.shift();if(Vr)Vr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function it(...i){i=Xd(i);let e="THREE."+i.shift();if(Vr)Vr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ms(...i){let e=i.join(" ");e in Fu||(Fu[e]=!0,et(...i))}function $d(i,e,t){return new Promise(function(n,r){function a(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(a,t);break;default:n()}}setTimeout(a,t)})}var qd={[go]:go,[vo]:So,[yo]:yo,[kr]:xo,[_o]:_o,[So]:vo,[Mo]:Mo,[xo]:kr},Zn=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let a=r.indexOf(t);a!==-1&&r.splice(a,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let a=0,l=r.length;a<l;a++)r[a].call(this,e);e.target=null}}},pn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Nu=1234567,bs=Math.PI/180,Hr=180/Math.PI;function es(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(pn[i&255]+pn[i>>8&255]+pn[i>>16&255]+pn[i>>24&255]+"-"+pn[e&255]+pn[e>>8&255]+"-"+pn[e>>16&15|64]+pn[e>>24&255]+"-"+pn[t&63|128]+pn[t>>8&255]+"-"+pn[t>>16&255]+pn[t>>24&255]+pn[n&255]+pn[n>>8&255]+pn[n>>16&255]+pn[n>>24&255]).toLowerCase()}function yt(i,e,t){return Math.max(e,Math.min(t,i))}function ph(i,e){return(i%e+e)%e}function fv(i,e,t,n,r){return n+(i-e)*(r-n)/(t-e)}function pv(i,e,t){return i!==e?(t-i)/(e-i):0}function ws(i,e,t){return(1-t)*i+t*e}function mv(i,e,t,n){return ws(i,e,1-Math.exp(-t*n))}function gv(i,e=1){return e-Math.abs(ph(i,e*2)-e)}function _v(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function vv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function yv(i,e){return i+Math.floor(Math.random()*(e-i+1))}function xv(i,e){return i+Math.random()*(e-i)}function Sv(i){return i*(.5-Math.random())}function Mv(i){i!==void 0&&(Nu=i);let e=Nu+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function bv(i){return i*bs}function wv(i){return i*Hr}function Ev(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Tv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function mh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Av(i,e,t,n,r){let a=Math.cos,l=Math.sin,c=a(t/2),f=l(t/2),u=a((e+n)/2),m=l((e+n)/2),v=a((e-n)/2),g=l((e-n)/2),y=a((n-e)/2),M=l((n-e)/2);switch(r){case"XYX":i.set(c*m,f*v,f*g,c*u);break;case"YZY":i.set(f*g,c*m,f*v,c*u);break;case"ZXZ":i.set(f*v,f*g,c*m,c*u);break;case"XZX":i.set(c*m,f*M,f*y,c*u);break;case"YXY":i.set(f*y,c*m,f*M,c*u);break;case"ZYZ":i.set(f*M,f*y,c*m,c*u);break;default:et("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function gh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Yd(i,e){if(e.constructor===Float32Array)return i;let t=gh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function jd(i,e){if(e.constructor===Float32Array)return i;let t=gh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var _h={DEG2RAD:bs,RAD2DEG:Hr,generateUUID:es,clamp:yt,euclideanModulo:ph,mapLinear:fv,inverseLerp:pv,lerp:ws,damp:mv,pingpong:gv,smoothstep:_v,smootherstep:vv,randInt:yv,randFloat:xv,randFloatSpread:Sv,seededRandom:Mv,degToRad:bv,radToDeg:wv,isPowerOfTwo:Ev,ceilPowerOfTwo:Tv,floorPowerOfTwo:mh,setQuaternionFromProperEuler:Av,normalize:jd,denormalize:Yd},tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),a=this.x-e.x,l=this.y-e.y;return this.x=a*n-l*r+e.x,this.y=a*r+l*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},bn=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,a,l,c){let f=n[r+0],u=n[r+1],m=n[r+2],v=n[r+3],g=a[l+0],y=a[l+1],M=a[l+2],A=a[l+3];if(v!==A||f!==g||u!==y||m!==M){let S=f*g+u*y+m*M+v*A;S<0&&(g=-g,y=-y,M=-M,A=-A,S=-S);let _=1-c;if(S<.9995){let P=Math.acos(S),U=Math.sin(P);_=Math.sin(_*P)/U,c=Math.sin(c*P)/U,f=f*_+g*c,u=u*_+y*c,m=m*_+M*c,v=v*_+A*c}else{f=f*_+g*c,u=u*_+y*c,m=m*_+M*c,v=v*_+A*c;let P=1/Math.sqrt(f*f+u*u+m*m+v*v);f*=P,u*=P,m*=P,v*=P}}e[t]=f,e[t+1]=u,e[t+2]=m,e[t+3]=v}static multiplyQuaternionsFlat(e,t,n,r,a,l){let c=n[r],f=n[r+1],u=n[r+2],m=n[r+3],v=a[l],g=a[l+1],y=a[l+2],M=a[l+3];return e[t]=c*M+m*v+f*y-u*g,e[t+1]=f*M+m*g+u*v-c*y,e[t+2]=u*M+m*y+c*g-f*v,e[t+3]=m*M-c*v-f*g-u*y,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,a=e._z,l=e._order,c=Math.cos,f=Math.sin,u=c(n/2),m=c(r/2),v=c(a/2),g=f(n/2),y=f(r/2),M=f(a/2);switch(l){case"XYZ":this._x=g*m*v+u*y*M,this._y=u*y*v-g*m*M,this._z=u*m*M+g*y*v,this._w=u*m*v-g*y*M;break;case"YXZ":this._x=g*m*v+u*y*M,this._y=u*y*v-g*m*M,this._z=u*m*M-g*y*v,this._w=u*m*v+g*y*M;break;case"ZXY":this._x=g*m*v-u*y*M,this._y=u*y*v+g*m*M,this._z=u*m*M+g*y*v,this._w=u*m*v-g*y*M;break;case"ZYX":this._x=g*m*v-u*y*M,this._y=u*y*v+g*m*M,this._z=u*m*M-g*y*v,this._w=u*m*v+g*y*M;break;case"YZX":this._x=g*m*v+u*y*M,this._y=u*y*v+g*m*M,this._z=u*m*M-g*y*v,this._w=u*m*v-g*y*M;break;case"XZY":this._x=g*m*v-u*y*M,this._y=u*y*v-g*m*M,this._z=u*m*M+g*y*v,this._w=u*m*v+g*y*M;break;default:et("Quaternion: .setFromEuler() encountered an unknown order: "+l)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],a=t[8],l=t[1],c=t[5],f=t[9],u=t[2],m=t[6],v=t[10],g=n+c+v;if(g>0){let y=.5/Math.sqrt(g+1);this._w=.25/y,this._x=(m-f)*y,this._y=(a-u)*y,this._z=(l-r)*y}else if(n>c&&n>v){let y=2*Math.sqrt(1+n-c-v);this._w=(m-f)/y,this._x=.25*y,this._y=(r+l)/y,this._z=(a+u)/y}else if(c>v){let y=2*Math.sqrt(1+c-n-v);this._w=(a-u)/y,this._x=(r+l)/y,this._y=.25*y,this._z=(f+m)/y}else{let y=2*Math.sqrt(1+v-n-c);this._w=(l-r)/y,this._x=(a+u)/y,this._y=(f+m)/y,this._z=.25*y}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,a=e._z,l=e._w,c=t._x,f=t._y,u=t._z,m=t._w;return this._x=n*m+l*c+r*u-a*f,this._y=r*m+l*f+a*c-n*u,this._z=a*m+l*u+n*f-r*c,this._w=l*m-n*c-r*f-a*u,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,a=e._z,l=e._w,c=this.dot(e);c<0&&(n=-n,r=-r,a=-a,l=-l,c=-c);let f=1-t;if(c<.9995){let u=Math.acos(c),m=Math.sin(u);f=Math.sin(f*u)/m,t=Math.sin(t*u)/m,this._x=this._x*f+n*t,this._y=this._y*f+r*t,this._z=this._z*f+a*t,this._w=this._w*f+l*t,this._onChangeCallback()}else this._x=this._x*f+n*t,this._y=this._y*f+r*t,this._z=this._z*f+a*t,this._w=this._w*f+l*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),a=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),a*Math.sin(t),a*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},j=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Uu.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Uu.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,a=e.elements;return this.x=a[0]*t+a[3]*n+a[6]*r,this.y=a[1]*t+a[4]*n+a[7]*r,this.z=a[2]*t+a[5]*n+a[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,a=e.elements,l=1/(a[3]*t+a[7]*n+a[11]*r+a[15]);return this.x=(a[0]*t+a[4]*n+a[8]*r+a[12])*l,this.y=(a[1]*t+a[5]*n+a[9]*r+a[13])*l,this.z=(a[2]*t+a[6]*n+a[10]*r+a[14])*l,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,a=e.x,l=e.y,c=e.z,f=e.w,u=2*(l*r-c*n),m=2*(c*t-a*r),v=2*(a*n-l*t);return this.x=t+f*u+l*v-c*m,this.y=n+f*m+c*u-a*v,this.z=r+f*v+a*m-l*u,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*r,this.y=a[1]*t+a[5]*n+a[9]*r,this.z=a[2]*t+a[6]*n+a[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,a=e.z,l=t.x,c=t.y,f=t.z;return this.x=r*f-a*c,this.y=a*l-n*f,this.z=n*c-r*l,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return fc.copy(this).projectOnVector(e),this.sub(fc)}reflect(e){return this.sub(fc.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},fc=new j,Uu=new bn,ct=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,a,l,c,f,u){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,a,l,c,f,u)}set(e,t,n,r,a,l,c,f,u){let m=this.elements;return m[0]=e,m[1]=r,m[2]=c,m[3]=t,m[4]=a,m[5]=f,m[6]=n,m[7]=l,m[8]=u,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,a=this.elements,l=n[0],c=n[3],f=n[6],u=n[1],m=n[4],v=n[7],g=n[2],y=n[5],M=n[8],A=r[0],S=r[3],_=r[6],P=r[1],U=r[4],I=r[7],O=r[2],N=r[5],w=r[8];return a[0]=l*A+c*P+f*O,a[3]=l*S+c*U+f*N,a[6]=l*_+c*I+f*w,a[1]=u*A+m*P+v*O,a[4]=u*S+m*U+v*N,a[7]=u*_+m*I+v*w,a[2]=g*A+y*P+M*O,a[5]=g*S+y*U+M*N,a[8]=g*_+y*I+M*w,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],a=e[3],l=e[4],c=e[5],f=e[6],u=e[7],m=e[8];return t*l*m-t*c*u-n*a*m+n*c*f+r*a*u-r*l*f}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],a=e[3],l=e[4],c=e[5],f=e[6],u=e[7],m=e[8],v=m*l-c*u,g=c*f-m*a,y=u*a-l*f,M=t*v+n*g+r*y;if(M===0)return this.set(0,0,0,0,0,0,0,0,0);let A=1/M;return e[0]=v*A,e[1]=(r*u-m*n)*A,e[2]=(c*n-r*l)*A,e[3]=g*A,e[4]=(m*t-r*f)*A,e[5]=(r*a-c*t)*A,e[6]=y*A,e[7]=(n*f-u*t)*A,e[8]=(l*t-n*a)*A,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,a,l,c){let f=Math.cos(a),u=Math.sin(a);return this.set(n*f,n*u,-n*(f*l+u*c)+l+e,-r*u,r*f,-r*(-u*l+f*c)+c+t,0,0,1),this}scale(e,t){return Ms("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(pc.makeScale(e,t)),this}rotate(e){return Ms("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(pc.makeRotation(-e)),this}translate(e,t){return Ms("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(pc.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},pc=new ct,Ou=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Bu=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Cv(){let i={enabled:!0,workingColorSpace:Ts,spaces:{},convert:function(r,a,l){return this.enabled===!1||a===l||!a||!l||(this.spaces[a].transfer===Pt&&(r.r=Ei(r.r),r.g=Ei(r.g),r.b=Ei(r.b)),this.spaces[a].primaries!==this.spaces[l].primaries&&(r.applyMatrix3(this.spaces[a].toXYZ),r.applyMatrix3(this.spaces[l].fromXYZ)),this.spaces[l].transfer===Pt&&(r.r=Br(r.r),r.g=Br(r.g),r.b=Br(r.b))),r},workingToColorSpace:function(r,a){return this.convert(r,this.workingColorSpace,a)},colorSpaceToWorking:function(r,a){return this.convert(r,a,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Di?As:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,a=this.workingColorSpace){return r.fromArray(this.spaces[a].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,a,l){return r.copy(this.spaces[l].fromXYZ).multiply(this.spaces[a].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ts]:{primaries:e,whitePoint:n,transfer:As,toXYZ:Ou,fromXYZ:Bu,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:gn},outputColorSpaceConfig:{drawingBufferColorSpace:gn}},[gn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:Ou,fromXYZ:Bu,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:gn}}}),i}var St=Cv();function Ei(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Br(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var wr,Eo=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{wr===void 0&&(wr=Cs("canvas")),wr.width=e.width,wr.height=e.height;let r=wr.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=wr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Cs("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),a=r.data;for(let l=0;l<a.length;l++)a[l]=Ei(a[l]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ei(t[n]/255)*255):t[n]=Ei(t[n]);return{data:t,width:e.width,height:e.height}}else return et("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Rv=0,Wr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Rv++}),this.uuid=es(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let a;if(Array.isArray(r)){a=[];for(let l=0,c=r.length;l<c;l++)r[l].isDataTexture?a.push(mc(r[l].image)):a.push(mc(r[l]))}else a=mc(r);n.url=a}return t||(e.images[this.uuid]=n),n}};function mc(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Eo.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(et("Texture: Unable to serialize Texture."),{})}var Pv=0,gc=new j,wn=class i extends Zn{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=li,r=li,a=Mn,l=Pi,c=Qn,f=An,u=i.DEFAULT_ANISOTROPY,m=Di){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Pv++}),this.uuid=es(),this.name="",this.source=new Wr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=a,this.minFilter=l,this.anisotropy=u,this.format=c,this.internalFormat=null,this.type=f,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=m,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(gc).x}get height(){return this.source.getSize(gc).y}get depth(){return this.source.getSize(gc).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){et(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){et(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==nh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case zr:e.x=e.x-Math.floor(e.x);break;case li:e.x=e.x<0?0:1;break;case bo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case zr:e.y=e.y-Math.floor(e.y);break;case li:e.y=e.y<0?0:1;break;case bo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};wn.DEFAULT_IMAGE=null;wn.DEFAULT_MAPPING=nh;wn.DEFAULT_ANISOTROPY=1;var Gt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,a=this.w,l=e.elements;return this.x=l[0]*t+l[4]*n+l[8]*r+l[12]*a,this.y=l[1]*t+l[5]*n+l[9]*r+l[13]*a,this.z=l[2]*t+l[6]*n+l[10]*r+l[14]*a,this.w=l[3]*t+l[7]*n+l[11]*r+l[15]*a,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,a,f=e.elements,u=f[0],m=f[4],v=f[8],g=f[1],y=f[5],M=f[9],A=f[2],S=f[6],_=f[10];if(Math.abs(m-g)<.01&&Math.abs(v-A)<.01&&Math.abs(M-S)<.01){if(Math.abs(m+g)<.1&&Math.abs(v+A)<.1&&Math.abs(M+S)<.1&&Math.abs(u+y+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let U=(u+1)/2,I=(y+1)/2,O=(_+1)/2,N=(m+g)/4,w=(v+A)/4,D=(M+S)/4;return U>I&&U>O?U<.01?(n=0,r=.707106781,a=.707106781):(n=Math.sqrt(U),r=N/n,a=w/n):I>O?I<.01?(n=.707106781,r=0,a=.707106781):(r=Math.sqrt(I),n=N/r,a=D/r):O<.01?(n=.707106781,r=.707106781,a=0):(a=Math.sqrt(O),n=w/a,r=D/a),this.set(n,r,a,t),this}let P=Math.sqrt((S-M)*(S-M)+(v-A)*(v-A)+(g-m)*(g-m));return Math.abs(P)<.001&&(P=1),this.x=(S-M)/P,this.y=(v-A)/P,this.z=(g-m)/P,this.w=Math.acos((u+y+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},To=class extends Zn{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Mn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t),this.textures=[];let r=n.count;for(let a=0;a<r;a++)this.textures[a]=new wn({width:e,height:t,depth:n.depth}),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Mn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,a=this.textures.length;r<a;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Wr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fn=class extends To{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Rs=class extends wn{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=cn,this.minFilter=cn,this.wrapR=li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ao=class extends wn{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=cn,this.minFilter=cn,this.wrapR=li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Lt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,a,l,c,f,u,m,v,g,y,M,A,S){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,a,l,c,f,u,m,v,g,y,M,A,S)}set(e,t,n,r,a,l,c,f,u,m,v,g,y,M,A,S){let _=this.elements;return _[0]=e,_[4]=t,_[8]=n,_[12]=r,_[1]=a,_[5]=l,_[9]=c,_[13]=f,_[2]=u,_[6]=m,_[10]=v,_[14]=g,_[3]=y,_[7]=M,_[11]=A,_[15]=S,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/Er.setFromMatrixColumn(e,0).length(),a=1/Er.setFromMatrixColumn(e,1).length(),l=1/Er.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*a,t[5]=n[5]*a,t[6]=n[6]*a,t[7]=0,t[8]=n[8]*l,t[9]=n[9]*l,t[10]=n[10]*l,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,a=e.z,l=Math.cos(n),c=Math.sin(n),f=Math.cos(r),u=Math.sin(r),m=Math.cos(a),v=Math.sin(a);if(e.order==="XYZ"){let g=l*m,y=l*v,M=c*m,A=c*v;t[0]=f*m,t[4]=-f*v,t[8]=u,t[1]=y+M*u,t[5]=g-A*u,t[9]=-c*f,t[2]=A-g*u,t[6]=M+y*u,t[10]=l*f}else if(e.order==="YXZ"){let g=f*m,y=f*v,M=u*m,A=u*v;t[0]=g+A*c,t[4]=M*c-y,t[8]=l*u,t[1]=l*v,t[5]=l*m,t[9]=-c,t[2]=y*c-M,t[6]=A+g*c,t[10]=l*f}else if(e.order==="ZXY"){let g=f*m,y=f*v,M=u*m,A=u*v;t[0]=g-A*c,t[4]=-l*v,t[8]=M+y*c,t[1]=y+M*c,t[5]=l*m,t[9]=A-g*c,t[2]=-l*u,t[6]=c,t[10]=l*f}else if(e.order==="ZYX"){let g=l*m,y=l*v,M=c*m,A=c*v;t[0]=f*m,t[4]=M*u-y,t[8]=g*u+A,t[1]=f*v,t[5]=A*u+g,t[9]=y*u-M,t[2]=-u,t[6]=c*f,t[10]=l*f}else if(e.order==="YZX"){let g=l*f,y=l*u,M=c*f,A=c*u;t[0]=f*m,t[4]=A-g*v,t[8]=M*v+y,t[1]=v,t[5]=l*m,t[9]=-c*m,t[2]=-u*m,t[6]=y*v+M,t[10]=g-A*v}else if(e.order==="XZY"){let g=l*f,y=l*u,M=c*f,A=c*u;t[0]=f*m,t[4]=-v,t[8]=u*m,t[1]=g*v+A,t[5]=l*m,t[9]=y*v-M,t[2]=M*v-y,t[6]=c*m,t[10]=A*v+g}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Iv,e,Dv)}lookAt(e,t,n){let r=this.elements;return In.subVectors(e,t),In.lengthSq()===0&&(In.z=1),In.normalize(),Oi.crossVectors(n,In),Oi.lengthSq()===0&&(Math.abs(n.z)===1?In.x+=1e-4:In.z+=1e-4,In.normalize(),Oi.crossVectors(n,In)),Oi.normalize(),Ha.crossVectors(In,Oi),r[0]=Oi.x,r[4]=Ha.x,r[8]=In.x,r[1]=Oi.y,r[5]=Ha.y,r[9]=In.y,r[2]=Oi.z,r[6]=Ha.z,r[10]=In.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,a=this.elements,l=n[0],c=n[4],f=n[8],u=n[12],m=n[1],v=n[5],g=n[9],y=n[13],M=n[2],A=n[6],S=n[10],_=n[14],P=n[3],U=n[7],I=n[11],O=n[15],N=r[0],w=r[4],D=r[8],X=r[12],k=r[1],Y=r[5],Z=r[9],ee=r[13],z=r[2],ie=r[6],G=r[10],ne=r[14],Se=r[3],re=r[7],H=r[11],ge=r[15];return a[0]=l*N+c*k+f*z+u*Se,a[4]=l*w+c*Y+f*ie+u*re,a[8]=l*D+c*Z+f*G+u*H,a[12]=l*X+c*ee+f*ne+u*ge,a[1]=m*N+v*k+g*z+y*Se,a[5]=m*w+v*Y+g*ie+y*re,a[9]=m*D+v*Z+g*G+y*H,a[13]=m*X+v*ee+g*ne+y*ge,a[2]=M*N+A*k+S*z+_*Se,a[6]=M*w+A*Y+S*ie+_*re,a[10]=M*D+A*Z+S*G+_*H,a[14]=M*X+A*ee+S*ne+_*ge,a[3]=P*N+U*k+I*z+O*Se,a[7]=P*w+U*Y+I*ie+O*re,a[11]=P*D+U*Z+I*G+O*H,a[15]=P*X+U*ee+I*ne+O*ge,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],a=e[12],l=e[1],c=e[5],f=e[9],u=e[13],m=e[2],v=e[6],g=e[10],y=e[14],M=e[3],A=e[7],S=e[11],_=e[15],P=f*y-u*g,U=c*y-u*v,I=c*g-f*v,O=l*y-u*m,N=l*g-f*m,w=l*v-c*m;return t*(A*P-S*U+_*I)-n*(M*P-S*O+_*N)+r*(M*U-A*O+_*w)-a*(M*I-A*N+S*w)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],a=e[1],l=e[5],c=e[9],f=e[2],u=e[6],m=e[10];return t*(l*m-c*u)-n*(a*m-c*f)+r*(a*u-l*f)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],a=e[3],l=e[4],c=e[5],f=e[6],u=e[7],m=e[8],v=e[9],g=e[10],y=e[11],M=e[12],A=e[13],S=e[14],_=e[15],P=t*c-n*l,U=t*f-r*l,I=t*u-a*l,O=n*f-r*c,N=n*u-a*c,w=r*u-a*f,D=m*A-v*M,X=m*S-g*M,k=m*_-y*M,Y=v*S-g*A,Z=v*_-y*A,ee=g*_-y*S,z=P*ee-U*Z+I*Y+O*k-N*X+w*D;if(z===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let ie=1/z;return e[0]=(c*ee-f*Z+u*Y)*ie,e[1]=(r*Z-n*ee-a*Y)*ie,e[2]=(A*w-S*N+_*O)*ie,e[3]=(g*N-v*w-y*O)*ie,e[4]=(f*k-l*ee-u*X)*ie,e[5]=(t*ee-r*k+a*X)*ie,e[6]=(S*I-M*w-_*U)*ie,e[7]=(m*w-g*I+y*U)*ie,e[8]=(l*Z-c*k+u*D)*ie,e[9]=(n*k-t*Z-a*D)*ie,e[10]=(M*N-A*I+_*P)*ie,e[11]=(v*I-m*N-y*P)*ie,e[12]=(c*X-l*Y-f*D)*ie,e[13]=(t*Y-n*X+r*D)*ie,e[14]=(A*U-M*O-S*P)*ie,e[15]=(m*O-v*U+g*P)*ie,this}scale(e){let t=this.elements,n=e.x,r=e.y,a=e.z;return t[0]*=n,t[4]*=r,t[8]*=a,t[1]*=n,t[5]*=r,t[9]*=a,t[2]*=n,t[6]*=r,t[10]*=a,t[3]*=n,t[7]*=r,t[11]*=a,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),a=1-n,l=e.x,c=e.y,f=e.z,u=a*l,m=a*c;return this.set(u*l+n,u*c-r*f,u*f+r*c,0,u*c+r*f,m*c+n,m*f-r*l,0,u*f-r*c,m*f+r*l,a*f*f+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,a,l){return this.set(1,n,a,0,e,1,l,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,a=t._x,l=t._y,c=t._z,f=t._w,u=a+a,m=l+l,v=c+c,g=a*u,y=a*m,M=a*v,A=l*m,S=l*v,_=c*v,P=f*u,U=f*m,I=f*v,O=n.x,N=n.y,w=n.z;return r[0]=(1-(A+_))*O,r[1]=(y+I)*O,r[2]=(M-U)*O,r[3]=0,r[4]=(y-I)*N,r[5]=(1-(g+_))*N,r[6]=(S+P)*N,r[7]=0,r[8]=(M+U)*w,r[9]=(S-P)*w,r[10]=(1-(g+A))*w,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let a=this.determinantAffine();if(a===0)return n.set(1,1,1),t.identity(),this;let l=Er.set(r[0],r[1],r[2]).length(),c=Er.set(r[4],r[5],r[6]).length(),f=Er.set(r[8],r[9],r[10]).length();a<0&&(l=-l),qn.copy(this);let u=1/l,m=1/c,v=1/f;return qn.elements[0]*=u,qn.elements[1]*=u,qn.elements[2]*=u,qn.elements[4]*=m,qn.elements[5]*=m,qn.elements[6]*=m,qn.elements[8]*=v,qn.elements[9]*=v,qn.elements[10]*=v,t.setFromRotationMatrix(qn),n.x=l,n.y=c,n.z=f,this}makePerspective(e,t,n,r,a,l,c=zn,f=!1){let u=this.elements,m=2*a/(t-e),v=2*a/(n-r),g=(t+e)/(t-e),y=(n+r)/(n-r),M,A;if(f)M=a/(l-a),A=l*a/(l-a);else if(c===zn)M=-(l+a)/(l-a),A=-2*l*a/(l-a);else if(c===Gr)M=-l/(l-a),A=-l*a/(l-a);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+c);return u[0]=m,u[4]=0,u[8]=g,u[12]=0,u[1]=0,u[5]=v,u[9]=y,u[13]=0,u[2]=0,u[6]=0,u[10]=M,u[14]=A,u[3]=0,u[7]=0,u[11]=-1,u[15]=0,this}makeOrthographic(e,t,n,r,a,l,c=zn,f=!1){let u=this.elements,m=2/(t-e),v=2/(n-r),g=-(t+e)/(t-e),y=-(n+r)/(n-r),M,A;if(f)M=1/(l-a),A=l/(l-a);else if(c===zn)M=-2/(l-a),A=-(l+a)/(l-a);else if(c===Gr)M=-1/(l-a),A=-a/(l-a);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+c);return u[0]=m,u[4]=0,u[8]=0,u[12]=g,u[1]=0,u[5]=v,u[9]=0,u[13]=y,u[2]=0,u[6]=0,u[10]=M,u[14]=A,u[3]=0,u[7]=0,u[11]=0,u[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Er=new j,qn=new Lt,Iv=new j(0,0,0),Dv=new j(1,1,1),Oi=new j,Ha=new j,In=new j,ku=new Lt,zu=new bn,ci=class i{constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,a=r[0],l=r[4],c=r[8],f=r[1],u=r[5],m=r[9],v=r[2],g=r[6],y=r[10];switch(t){case"XYZ":this._y=Math.asin(yt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-m,y),this._z=Math.atan2(-l,a)):(this._x=Math.atan2(g,u),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(m,-1,1)),Math.abs(m)<.9999999?(this._y=Math.atan2(c,y),this._z=Math.atan2(f,u)):(this._y=Math.atan2(-v,a),this._z=0);break;case"ZXY":this._x=Math.asin(yt(g,-1,1)),Math.abs(g)<.9999999?(this._y=Math.atan2(-v,y),this._z=Math.atan2(-l,u)):(this._y=0,this._z=Math.atan2(f,a));break;case"ZYX":this._y=Math.asin(-yt(v,-1,1)),Math.abs(v)<.9999999?(this._x=Math.atan2(g,y),this._z=Math.atan2(f,a)):(this._x=0,this._z=Math.atan2(-l,u));break;case"YZX":this._z=Math.asin(yt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(-m,u),this._y=Math.atan2(-v,a)):(this._x=0,this._y=Math.atan2(c,y));break;case"XZY":this._z=Math.asin(-yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(g,u),this._y=Math.atan2(c,a)):(this._x=Math.atan2(-m,y),this._y=0);break;default:et("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return ku.makeRotationFromQuaternion(e),this.setFromRotationMatrix(ku,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return zu.setFromEuler(this),this.setFromQuaternion(zu,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ci.DEFAULT_ORDER="XYZ";var Xr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Lv=0,Gu=new j,Tr=new bn,xi=new Lt,Wa=new j,ms=new j,Fv=new j,Nv=new bn,Vu=new j(1,0,0),Hu=new j(0,1,0),Wu=new j(0,0,1),Xu={type:"added"},Uv={type:"removed"},Ar={type:"childadded",child:null},_c={type:"childremoved",child:null},Qt=class i extends Zn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Lv++}),this.uuid=es(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new j,t=new ci,n=new bn,r=new j(1,1,1);function a(){n.setFromEuler(t,!1)}function l(){t.setFromQuaternion(n,void 0,!1)}t._onChange(a),n._onChange(l),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Lt},normalMatrix:{value:new ct}}),this.matrix=new Lt,this.matrixWorld=new Lt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Xr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Tr.setFromAxisAngle(e,t),this.quaternion.multiply(Tr),this}rotateOnWorldAxis(e,t){return Tr.setFromAxisAngle(e,t),this.quaternion.premultiply(Tr),this}rotateX(e){return this.rotateOnAxis(Vu,e)}rotateY(e){return this.rotateOnAxis(Hu,e)}rotateZ(e){return this.rotateOnAxis(Wu,e)}translateOnAxis(e,t){return Gu.copy(e).applyQuaternion(this.quaternion),this.position.add(Gu.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Vu,e)}translateY(e){return this.translateOnAxis(Hu,e)}translateZ(e){return this.translateOnAxis(Wu,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Wa.copy(e):Wa.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),ms.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xi.lookAt(ms,Wa,this.up):xi.lookAt(Wa,ms,this.up),this.quaternion.setFromRotationMatrix(xi),r&&(xi.extractRotation(r.matrixWorld),Tr.setFromRotationMatrix(xi),this.quaternion.premultiply(Tr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Xu),Ar.child=e,this.dispatchEvent(Ar),Ar.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Uv),_c.child=e,this.dispatchEvent(_c),_c.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xi.multiply(e.parent.matrixWorld)),e.applyMatrix4(xi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Xu),Ar.child=e,this.dispatchEvent(Ar),Ar.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let l=this.children[n].getObjectByProperty(e,t);if(l!==void 0)return l}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let a=0,l=r.length;a<l;a++)r[a].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ms,e,Fv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ms,Nv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,a=this.matrix.elements;a[12]+=t-a[0]*t-a[4]*n-a[8]*r,a[13]+=n-a[1]*t-a[5]*n-a[9]*r,a[14]+=r-a[2]*t-a[6]*n-a[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let a=this.children;for(let l=0,c=a.length;l<c;l++)a[l].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(c=>({...c,boundingBox:c.boundingBox?c.boundingBox.toJSON():void 0,boundingSphere:c.boundingSphere?c.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(c=>({...c})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function a(c,f){return c[f.uuid]===void 0&&(c[f.uuid]=f.toJSON(e)),f.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=a(e.geometries,this.geometry);let c=this.geometry.parameters;if(c!==void 0&&c.shapes!==void 0){let f=c.shapes;if(Array.isArray(f))for(let u=0,m=f.length;u<m;u++){let v=f[u];a(e.shapes,v)}else a(e.shapes,f)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(a(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let c=[];for(let f=0,u=this.material.length;f<u;f++)c.push(a(e.materials,this.material[f]));r.material=c}else r.material=a(e.materials,this.material);if(this.children.length>0){r.children=[];for(let c=0;c<this.children.length;c++)r.children.push(this.children[c].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let c=0;c<this.animations.length;c++){let f=this.animations[c];r.animations.push(a(e.animations,f))}}if(t){let c=l(e.geometries),f=l(e.materials),u=l(e.textures),m=l(e.images),v=l(e.shapes),g=l(e.skeletons),y=l(e.animations),M=l(e.nodes);c.length>0&&(n.geometries=c),f.length>0&&(n.materials=f),u.length>0&&(n.textures=u),m.length>0&&(n.images=m),v.length>0&&(n.shapes=v),g.length>0&&(n.skeletons=g),y.length>0&&(n.animations=y),M.length>0&&(n.nodes=M)}return n.object=r,n;function l(c){let f=[];for(let u in c){let m=c[u];delete m.metadata,f.push(m)}return f}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Qt.DEFAULT_UP=new j(0,1,0);Qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Gn=class extends Qt{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ov={type:"move"},$r=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Gn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Gn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new j,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new j),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Gn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new j,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new j,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,a=null,l=null,c=this._targetRay,f=this._grip,u=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(u&&e.hand){l=!0;for(let A of e.hand.values()){let S=t.getJointPose(A,n),_=this._getHandJoint(u,A);S!==null&&(_.matrix.fromArray(S.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=S.radius),_.visible=S!==null}let m=u.joints["index-finger-tip"],v=u.joints["thumb-tip"],g=m.position.distanceTo(v.position),y=.02,M=.005;u.inputState.pinching&&g>y+M?(u.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!u.inputState.pinching&&g<=y-M&&(u.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else f!==null&&e.gripSpace&&(a=t.getPose(e.gripSpace,n),a!==null&&(f.matrix.fromArray(a.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,a.linearVelocity?(f.hasLinearVelocity=!0,f.linearVelocity.copy(a.linearVelocity)):f.hasLinearVelocity=!1,a.angularVelocity?(f.hasAngularVelocity=!0,f.angularVelocity.copy(a.angularVelocity)):f.hasAngularVelocity=!1,f.eventsEnabled&&f.dispatchEvent({type:"gripUpdated",data:e,target:this})));c!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&a!==null&&(r=a),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,this.dispatchEvent(Ov)))}return c!==null&&(c.visible=r!==null),f!==null&&(f.visible=a!==null),u!==null&&(u.visible=l!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Gn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Zd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Bi={h:0,s:0,l:0},Xa={h:0,s:0,l:0};function vc(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ht=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=gn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=St.workingColorSpace){if(e=ph(e,1),t=yt(t,0,1),n=yt(n,0,1),t===0)this.r=this.g=this.b=n;else{let a=n<=.5?n*(1+t):n+t-n*t,l=2*n-a;this.r=vc(l,a,e+1/3),this.g=vc(l,a,e),this.b=vc(l,a,e-1/3)}return St.colorSpaceToWorking(this,r),this}setStyle(e,t=gn){function n(a){a!==void 0&&parseFloat(a)<1&&et("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let a,l=r[1],c=r[2];switch(l){case"rgb":case"rgba":if(a=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(c))return n(a[4]),this.setRGB(Math.min(255,parseInt(a[1],10))/255,Math.min(255,parseInt(a[2],10))/255,Math.min(255,parseInt(a[3],10))/255,t);if(a=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(c))return n(a[4]),this.setRGB(Math.min(100,parseFloat(a[1]))/100,Math.min(100,parseFloat(a[2]))/100,Math.min(100,parseFloat(a[3]))/100,t);break;case"hsl":case"hsla":if(a=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(c))return n(a[4]),this.setHSL(parseFloat(a[1])/360,parseFloat(a[2])/100,parseFloat(a[3])/100,t);break;default:et("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let a=r[1],l=a.length;if(l===3)return this.setRGB(parseInt(a.charAt(0),16)/15,parseInt(a.charAt(1),16)/15,parseInt(a.charAt(2),16)/15,t);if(l===6)return this.setHex(parseInt(a,16),t);et("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=gn){let n=Zd[e.toLowerCase()];return n!==void 0?this.setHex(n,t):et("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ei(e.r),this.g=Ei(e.g),this.b=Ei(e.b),this}copyLinearToSRGB(e){return this.r=Br(e.r),this.g=Br(e.g),this.b=Br(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=gn){return St.workingToColorSpace(mn.copy(this),e),Math.round(yt(mn.r*255,0,255))*65536+Math.round(yt(mn.g*255,0,255))*256+Math.round(yt(mn.b*255,0,255))}getHexString(e=gn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(mn.copy(this),t);let n=mn.r,r=mn.g,a=mn.b,l=Math.max(n,r,a),c=Math.min(n,r,a),f,u,m=(c+l)/2;if(c===l)f=0,u=0;else{let v=l-c;switch(u=m<=.5?v/(l+c):v/(2-l-c),l){case n:f=(r-a)/v+(r<a?6:0);break;case r:f=(a-n)/v+2;break;case a:f=(n-r)/v+4;break}f/=6}return e.h=f,e.s=u,e.l=m,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(mn.copy(this),t),e.r=mn.r,e.g=mn.g,e.b=mn.b,e}getStyle(e=gn){St.workingToColorSpace(mn.copy(this),e);let t=mn.r,n=mn.g,r=mn.b;return e!==gn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(Bi),this.setHSL(Bi.h+e,Bi.s+t,Bi.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Bi),e.getHSL(Xa);let n=ws(Bi.h,Xa.h,t),r=ws(Bi.s,Xa.s,t),a=ws(Bi.l,Xa.l,t);return this.setHSL(n,r,a),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,a=e.elements;return this.r=a[0]*t+a[3]*n+a[6]*r,this.g=a[1]*t+a[4]*n+a[7]*r,this.b=a[2]*t+a[5]*n+a[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},mn=new ht;ht.NAMES=Zd;var Ps=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ht(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},dr=class extends Qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ci,this.environmentIntensity=1,this.environmentRotation=new ci,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Yn=new j,Si=new j,yc=new j,Mi=new j,Cr=new j,Rr=new j,$u=new j,xc=new j,Sc=new j,Mc=new j,bc=new Gt,wc=new Gt,Ec=new Gt,Vi=class i{constructor(e=new j,t=new j,n=new j){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),Yn.subVectors(e,t),r.cross(Yn);let a=r.lengthSq();return a>0?r.multiplyScalar(1/Math.sqrt(a)):r.set(0,0,0)}static getBarycoord(e,t,n,r,a){Yn.subVectors(r,t),Si.subVectors(n,t),yc.subVectors(e,t);let l=Yn.dot(Yn),c=Yn.dot(Si),f=Yn.dot(yc),u=Si.dot(Si),m=Si.dot(yc),v=l*u-c*c;if(v===0)return a.set(0,0,0),null;let g=1/v,y=(u*f-c*m)*g,M=(l*m-c*f)*g;return a.set(1-y-M,M,y)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,Mi)===null?!1:Mi.x>=0&&Mi.y>=0&&Mi.x+Mi.y<=1}static getInterpolation(e,t,n,r,a,l,c,f){return this.getBarycoord(e,t,n,r,Mi)===null?(f.x=0,f.y=0,"z"in f&&(f.z=0),"w"in f&&(f.w=0),null):(f.setScalar(0),f.addScaledVector(a,Mi.x),f.addScaledVector(l,Mi.y),f.addScaledVector(c,Mi.z),f)}static getInterpolatedAttribute(e,t,n,r,a,l){return bc.setScalar(0),wc.setScalar(0),Ec.setScalar(0),bc.fromBufferAttribute(e,t),wc.fromBufferAttribute(e,n),Ec.fromBufferAttribute(e,r),l.setScalar(0),l.addScaledVector(bc,a.x),l.addScaledVector(wc,a.y),l.addScaledVector(Ec,a.z),l}static isFrontFacing(e,t,n,r){return Yn.subVectors(n,t),Si.subVectors(e,t),Yn.cross(Si).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Yn.subVectors(this.c,this.b),Si.subVectors(this.a,this.b),Yn.cross(Si).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,a){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,a)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,a=this.c,l,c;Cr.subVectors(r,n),Rr.subVectors(a,n),xc.subVectors(e,n);let f=Cr.dot(xc),u=Rr.dot(xc);if(f<=0&&u<=0)return t.copy(n);Sc.subVectors(e,r);let m=Cr.dot(Sc),v=Rr.dot(Sc);if(m>=0&&v<=m)return t.copy(r);let g=f*v-m*u;if(g<=0&&f>=0&&m<=0&&f-m>0)return l=f/(f-m),t.copy(n).addScaledVector(Cr,l);Mc.subVectors(e,a);let y=Cr.dot(Mc),M=Rr.dot(Mc);if(M>=0&&y<=M)return t.copy(a);let A=y*u-f*M;if(A<=0&&u>=0&&M<=0)return c=u/(u-M),t.copy(n).addScaledVector(Rr,c);let S=m*M-y*v;if(S<=0&&v-m>=0&&y-M>=0)return $u.subVectors(a,r),c=(v-m)/(v-m+(y-M)),t.copy(r).addScaledVector($u,c);let _=1/(S+A+g);return l=A*_,c=g*_,t.copy(n).addScaledVector(Cr,l).addScaledVector(Rr,c)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},hi=class{constructor(e=new j(1/0,1/0,1/0),t=new j(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(jn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(jn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=jn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let a=n.getAttribute("position");if(t===!0&&a!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let l=0,c=a.count;l<c;l++)e.isMesh===!0?e.getVertexPosition(l,jn):jn.fromBufferAttribute(a,l),jn.applyMatrix4(e.matrixWorld),this.expandByPoint(jn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),$a.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),$a.copy(n.boundingBox)),$a.applyMatrix4(e.matrixWorld),this.union($a)}let r=e.children;for(let a=0,l=r.length;a<l;a++)this.expandByObject(r[a],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,jn),jn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(gs),qa.subVectors(this.max,gs),Pr.subVectors(e.a,gs),Ir.subVectors(e.b,gs),Dr.subVectors(e.c,gs),ki.subVectors(Ir,Pr),zi.subVectors(Dr,Ir),lr.subVectors(Pr,Dr);let t=[0,-ki.z,ki.y,0,-zi.z,zi.y,0,-lr.z,lr.y,ki.z,0,-ki.x,zi.z,0,-zi.x,lr.z,0,-lr.x,-ki.y,ki.x,0,-zi.y,zi.x,0,-lr.y,lr.x,0];return!Tc(t,Pr,Ir,Dr,qa)||(t=[1,0,0,0,1,0,0,0,1],!Tc(t,Pr,Ir,Dr,qa))?!1:(Ya.crossVectors(ki,zi),t=[Ya.x,Ya.y,Ya.z],Tc(t,Pr,Ir,Dr,qa))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,jn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(jn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(bi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),bi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),bi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),bi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),bi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),bi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),bi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),bi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(bi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},bi=[new j,new j,new j,new j,new j,new j,new j,new j],jn=new j,$a=new hi,Pr=new j,Ir=new j,Dr=new j,ki=new j,zi=new j,lr=new j,gs=new j,qa=new j,Ya=new j,cr=new j;function Tc(i,e,t,n,r){for(let a=0,l=i.length-3;a<=l;a+=3){cr.fromArray(i,a);let c=r.x*Math.abs(cr.x)+r.y*Math.abs(cr.y)+r.z*Math.abs(cr.z),f=e.dot(cr),u=t.dot(cr),m=n.dot(cr);if(Math.max(-Math.max(f,u,m),Math.min(f,u,m))>c)return!1}return!0}var Yt=new j,ja=new tt,Bv=0,Tn=class extends Zn{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Bv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Hd,this.updateRanges=[],this.gpuType=Vn,this.version=0,this._normalizationScale=e!==void 0?gh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,a=this.itemSize;r<a;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)ja.fromBufferAttribute(this,t),ja.applyMatrix3(e),this.setXY(t,ja.x,ja.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix3(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyMatrix4(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.applyNormalMatrix(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Yt.fromBufferAttribute(this,t),Yt.transformDirection(e),this.setXYZ(t,Yt.x,Yt.y,Yt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,a){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),a=this._normalize(a)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=a,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Yd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):jd(e,this.array)}};var Is=class extends Tn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ds=class extends Tn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Xt=class extends Tn{constructor(e,t,n){super(new Float32Array(e),t,n)}},kv=new hi,_s=new j,Ac=new j,Ai=class{constructor(e=new j,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):kv.setFromPoints(e).getCenter(n);let r=0;for(let a=0,l=e.length;a<l;a++)r=Math.max(r,n.distanceToSquared(e[a]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;_s.subVectors(e,this.center);let t=_s.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector(_s,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ac.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(_s.copy(e.center).add(Ac)),this.expandByPoint(_s.copy(e.center).sub(Ac))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},zv=0,kn=new Lt,Cc=new Qt,Lr=new j,Dn=new hi,vs=new hi,ln=new j,En=class i extends Zn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:zv++}),this.uuid=es(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(uv(e)?Ds:Is)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let a=new ct().getNormalMatrix(e);n.applyNormalMatrix(a),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return kn.makeRotationFromQuaternion(e),this.applyMatrix4(kn),this}rotateX(e){return kn.makeRotationX(e),this.applyMatrix4(kn),this}rotateY(e){return kn.makeRotationY(e),this.applyMatrix4(kn),this}rotateZ(e){return kn.makeRotationZ(e),this.applyMatrix4(kn),this}translate(e,t,n){return kn.makeTranslation(e,t,n),this.applyMatrix4(kn),this}scale(e,t,n){return kn.makeScale(e,t,n),this.applyMatrix4(kn),this}lookAt(e){return Cc.lookAt(e),Cc.updateMatrix(),this.applyMatrix4(Cc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Lr).negate(),this.translate(Lr.x,Lr.y,Lr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,a=e.length;r<a;r++){let l=e[r];n.push(l.x,l.y,l.z||0)}this.setAttribute("position",new Xt(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let a=e[r];t.setXYZ(r,a.x,a.y,a.z||0)}e.length>t.count&&et("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new hi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new j(-1/0,-1/0,-1/0),new j(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let a=t[n];Dn.setFromBufferAttribute(a),this.morphTargetsRelative?(ln.addVectors(this.boundingBox.min,Dn.min),this.boundingBox.expandByPoint(ln),ln.addVectors(this.boundingBox.max,Dn.max),this.boundingBox.expandByPoint(ln)):(this.boundingBox.expandByPoint(Dn.min),this.boundingBox.expandByPoint(Dn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ai);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new j,1/0);return}if(e){let n=this.boundingSphere.center;if(Dn.setFromBufferAttribute(e),t)for(let a=0,l=t.length;a<l;a++){let c=t[a];vs.setFromBufferAttribute(c),this.morphTargetsRelative?(ln.addVectors(Dn.min,vs.min),Dn.expandByPoint(ln),ln.addVectors(Dn.max,vs.max),Dn.expandByPoint(ln)):(Dn.expandByPoint(vs.min),Dn.expandByPoint(vs.max))}Dn.getCenter(n);let r=0;for(let a=0,l=e.count;a<l;a++)ln.fromBufferAttribute(e,a),r=Math.max(r,n.distanceToSquared(ln));if(t)for(let a=0,l=t.length;a<l;a++){let c=t[a],f=this.morphTargetsRelative;for(let u=0,m=c.count;u<m;u++)ln.fromBufferAttribute(c,u),f&&(Lr.fromBufferAttribute(e,u),ln.add(Lr)),r=Math.max(r,n.distanceToSquared(ln))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,a=t.uv,l=this.getAttribute("tangent");(l===void 0||l.count!==n.count)&&(l=new Tn(new Float32Array(4*n.count),4),this.setAttribute("tangent",l));let c=[],f=[],u=new Uint8Array(n.count);for(let X=0;X<n.count;X++)c[X]=new j,f[X]=new j;let m=new j,v=new j,g=new j,y=new tt,M=new tt,A=new tt,S=new j,_=new j;function P(X,k,Y){u[X]=u[k]=u[Y]=1,m.fromBufferAttribute(n,X),v.fromBufferAttribute(n,k),g.fromBufferAttribute(n,Y),y.fromBufferAttribute(a,X),M.fromBufferAttribute(a,k),A.fromBufferAttribute(a,Y),v.sub(m),g.sub(m),M.sub(y),A.sub(y);let Z=1/(M.x*A.y-A.x*M.y);isFinite(Z)&&(S.copy(v).multiplyScalar(A.y).addScaledVector(g,-M.y).multiplyScalar(Z),_.copy(g).multiplyScalar(M.x).addScaledVector(v,-A.x).multiplyScalar(Z),c[X].add(S),c[k].add(S),c[Y].add(S),f[X].add(_),f[k].add(_),f[Y].add(_))}let U=this.groups;U.length===0&&(U=[{start:0,count:e.count}]);for(let X=0,k=U.length;X<k;++X){let Y=U[X],Z=Y.start,ee=Y.count;for(let z=Z,ie=Z+ee;z<ie;z+=3)P(e.getX(z+0),e.getX(z+1),e.getX(z+2))}let I=new j,O=new j,N=new j,w=new j;function D(X){N.fromBufferAttribute(r,X),w.copy(N);let k=c[X];I.copy(k),I.sub(N.multiplyScalar(N.dot(k))).normalize(),O.crossVectors(w,k);let Z=O.dot(f[X])<0?-1:1;l.setXYZW(X,I.x,I.y,I.z,Z)}for(let X=0,k=n.count;X<k;++X)u[X]&&D(X);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Tn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let g=0,y=n.count;g<y;g++)n.setXYZ(g,0,0,0);let r=new j,a=new j,l=new j,c=new j,f=new j,u=new j,m=new j,v=new j;if(e)for(let g=0,y=e.count;g<y;g+=3){let M=e.getX(g+0),A=e.getX(g+1),S=e.getX(g+2);r.fromBufferAttribute(t,M),a.fromBufferAttribute(t,A),l.fromBufferAttribute(t,S),m.subVectors(l,a),v.subVectors(r,a),m.cross(v),c.fromBufferAttribute(n,M),f.fromBufferAttribute(n,A),u.fromBufferAttribute(n,S),c.add(m),f.add(m),u.add(m),n.setXYZ(M,c.x,c.y,c.z),n.setXYZ(A,f.x,f.y,f.z),n.setXYZ(S,u.x,u.y,u.z)}else for(let g=0,y=t.count;g<y;g+=3)r.fromBufferAttribute(t,g+0),a.fromBufferAttribute(t,g+1),l.fromBufferAttribute(t,g+2),m.subVectors(l,a),v.subVectors(r,a),m.cross(v),n.setXYZ(g+0,m.x,m.y,m.z),n.setXYZ(g+1,m.x,m.y,m.z),n.setXYZ(g+2,m.x,m.y,m.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)ln.fromBufferAttribute(e,t),ln.normalize(),e.setXYZ(t,ln.x,ln.y,ln.z)}toNonIndexed(){function e(c,f){let u=c.array,m=c.itemSize,v=c.normalized,g=new u.constructor(f.length*m),y=0,M=0;for(let A=0,S=f.length;A<S;A++){c.isInterleavedBufferAttribute?y=f[A]*c.data.stride+c.offset:y=f[A]*m;for(let _=0;_<m;_++)g[M++]=u[y++]}return new Tn(g,m,v)}if(this.index===null)return et("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let c in r){let f=r[c],u=e(f,n);t.setAttribute(c,u)}let a=this.morphAttributes;for(let c in a){let f=[],u=a[c];for(let m=0,v=u.length;m<v;m++){let g=u[m],y=e(g,n);f.push(y)}t.morphAttributes[c]=f}t.morphTargetsRelative=this.morphTargetsRelative;let l=this.groups;for(let c=0,f=l.length;c<f;c++){let u=l[c];t.addGroup(u.start,u.count,u.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let f=this.parameters;for(let u in f)f[u]!==void 0&&(e[u]=f[u]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let f in n){let u=n[f];e.data.attributes[f]=u.toJSON(e.data)}let r={},a=!1;for(let f in this.morphAttributes){let u=this.morphAttributes[f],m=[];for(let v=0,g=u.length;v<g;v++){let y=u[v];m.push(y.toJSON(e.data))}m.length>0&&(r[f]=m,a=!0)}a&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let l=this.groups;l.length>0&&(e.data.groups=JSON.parse(JSON.stringify(l)));let c=this.boundingSphere;return c!==null&&(e.data.boundingSphere=c.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let u in r){let m=r[u];this.setAttribute(u,m.clone(t))}let a=e.morphAttributes;for(let u in a){let m=[],v=a[u];for(let g=0,y=v.length;g<y;g++)m.push(v[g].clone(t));this.morphAttributes[u]=m}this.morphTargetsRelative=e.morphTargetsRelative;let l=e.groups;for(let u=0,m=l.length;u<m;u++){let v=l[u];this.addGroup(v.start,v.count,v.materialIndex)}let c=e.boundingBox;c!==null&&(this.boundingBox=c.clone());let f=e.boundingSphere;return f!==null&&(this.boundingSphere=f.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Rc=new j,Gv=new j,Vv=new ct,Ln=class{constructor(e=new j(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=Rc.subVectors(n,t).cross(Gv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(Rc),a=this.normal.dot(r);if(a===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let l=-(e.start.dot(this.normal)+this.constant)/a;return n===!0&&(l<0||l>1)?null:t.copy(e.start).addScaledVector(r,l)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Vv.getNormalMatrix(e),r=this.coplanarPoint(Rc).applyMatrix4(e),a=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(a),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Hv=0,ui=class extends Zn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Hv++}),this.uuid=es(),this.name="",this.type="Material",this.blending=Jr,this.side=Ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Yc,this.blendDst=jc,this.blendEquation=gr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=kr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Od,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=mo,this.stencilZFail=mo,this.stencilZPass=mo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){et(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){et(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(a=>a.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(a){let l=[];for(let c in a){let f=a[c];delete f.metadata,l.push(f)}return l}if(t){let a=r(e.textures),l=r(e.images);a.length>0&&(n.textures=a),l.length>0&&(n.images=l)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Ln().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new tt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let a=0;a!==r;++a)n[a]=t[a].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var wi=new j,Pc=new j,Za=new j,Ja=new j,Hi=class{constructor(e=new j,t=new j(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,wi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=wi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(wi.copy(this.origin).addScaledVector(this.direction,t),wi.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){Pc.copy(e).add(t).multiplyScalar(.5),Za.copy(t).sub(e).normalize(),Ja.copy(this.origin).sub(Pc);let a=e.distanceTo(t)*.5,l=-this.direction.dot(Za),c=Ja.dot(this.direction),f=-Ja.dot(Za),u=Ja.lengthSq(),m=Math.abs(1-l*l),v,g,y,M;if(m>0)if(v=l*f-c,g=l*c-f,M=a*m,v>=0)if(g>=-M)if(g<=M){let A=1/m;v*=A,g*=A,y=v*(v+l*g+2*c)+g*(l*v+g+2*f)+u}else g=a,v=Math.max(0,-(l*g+c)),y=-v*v+g*(g+2*f)+u;else g=-a,v=Math.max(0,-(l*g+c)),y=-v*v+g*(g+2*f)+u;else g<=-M?(v=Math.max(0,-(-l*a+c)),g=v>0?-a:Math.min(Math.max(-a,-f),a),y=-v*v+g*(g+2*f)+u):g<=M?(v=0,g=Math.min(Math.max(-a,-f),a),y=g*(g+2*f)+u):(v=Math.max(0,-(l*a+c)),g=v>0?a:Math.min(Math.max(-a,-f),a),y=-v*v+g*(g+2*f)+u);else g=l>0?-a:a,v=Math.max(0,-(l*g+c)),y=-v*v+g*(g+2*f)+u;return n&&n.copy(this.origin).addScaledVector(this.direction,v),r&&r.copy(Pc).addScaledVector(Za,g),y}intersectSphere(e,t){if(e.radius<0)return null;wi.subVectors(e.center,this.origin);let n=wi.dot(this.direction),r=wi.dot(wi)-n*n,a=e.radius*e.radius;if(r>a)return null;let l=Math.sqrt(a-r),c=n-l,f=n+l;return f<0?null:c<0?this.at(f,t):this.at(c,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,a,l,c,f,u=1/this.direction.x,m=1/this.direction.y,v=1/this.direction.z,g=this.origin;return u>=0?(n=(e.min.x-g.x)*u,r=(e.max.x-g.x)*u):(n=(e.max.x-g.x)*u,r=(e.min.x-g.x)*u),m>=0?(a=(e.min.y-g.y)*m,l=(e.max.y-g.y)*m):(a=(e.max.y-g.y)*m,l=(e.min.y-g.y)*m),n>l||a>r||((a>n||isNaN(n))&&(n=a),(l<r||isNaN(r))&&(r=l),v>=0?(c=(e.min.z-g.z)*v,f=(e.max.z-g.z)*v):(c=(e.max.z-g.z)*v,f=(e.min.z-g.z)*v),n>f||c>r)||((c>n||n!==n)&&(n=c),(f<r||r!==r)&&(r=f),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,wi)!==null}intersectTriangle(e,t,n,r,a){let l=this.origin,c=this.direction,f=c.x,u=c.y,m=c.z,v=e.x-l.x,g=e.y-l.y,y=e.z-l.z,M=t.x-l.x,A=t.y-l.y,S=t.z-l.z,_=n.x-l.x,P=n.y-l.y,U=n.z-l.z,I=Math.abs(f),O=Math.abs(u),N=Math.abs(m),w,D,X,k,Y,Z,ee,z,ie,G,ne,Se;if(I>=O&&I>=N?(X=f,Z=v,ie=M,Se=_,f>=0?(w=u,D=m,k=g,Y=y,ee=A,z=S,G=P,ne=U):(w=m,D=u,k=y,Y=g,ee=S,z=A,G=U,ne=P)):O>=N?(X=u,Z=g,ie=A,Se=P,u>=0?(w=m,D=f,k=y,Y=v,ee=S,z=M,G=U,ne=_):(w=f,D=m,k=v,Y=y,ee=M,z=S,G=_,ne=U)):(X=m,Z=y,ie=S,Se=U,m>=0?(w=f,D=u,k=v,Y=g,ee=M,z=A,G=_,ne=P):(w=u,D=f,k=g,Y=v,ee=A,z=M,G=P,ne=_)),X===0)return null;let re=w/X,H=D/X,ge=1/X,We=k-re*Z,rt=Y-H*Z,ue=ee-re*ie,Fe=z-H*ie,Pe=G-re*Se,Ze=ne-H*Se,Ue=Pe*Fe-Ze*ue,ot=We*Ze-rt*Pe,Vt=ue*rt-Fe*We;if(r){if(Ue<0||ot<0||Vt<0)return null}else if((Ue<0||ot<0||Vt<0)&&(Ue>0||ot>0||Vt>0))return null;let Qe=Ue+ot+Vt;if(Qe===0)return null;let Et=ge*(Ue*Z+ot*ie+Vt*Se);return(Qe>0?Et<0:Et>0)?null:this.at(Et/Qe,a)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ls=class extends ui{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ci,this.combine=qo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},qu=new Lt,hr=new Hi,Ka=new Ai,Yu=new j,Qa=new j,eo=new j,to=new j,Ic=new j,no=new j,ju=new j,io=new j,Ot=class extends Qt{constructor(e=new En,t=new Ls){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let a=0,l=r.length;a<l;a++){let c=r[a].name||String(a);this.morphTargetInfluences.push(0),this.morphTargetDictionary[c]=a}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,a=n.morphAttributes.position,l=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let c=this.morphTargetInfluences;if(a&&c){no.set(0,0,0);for(let f=0,u=a.length;f<u;f++){let m=c[f],v=a[f];m!==0&&(Ic.fromBufferAttribute(v,e),l?no.addScaledVector(Ic,m):no.addScaledVector(Ic.sub(t),m))}t.add(no)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,a=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ka.copy(n.boundingSphere),Ka.applyMatrix4(a),hr.copy(e.ray).recast(e.near),!(Ka.containsPoint(hr.origin)===!1&&(hr.intersectSphere(Ka,Yu)===null||hr.origin.distanceToSquared(Yu)>(e.far-e.near)**2))&&(qu.copy(a).invert(),hr.copy(e.ray).applyMatrix4(qu),!(n.boundingBox!==null&&hr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,hr)))}_computeIntersections(e,t,n){let r,a=this.geometry,l=this.material,c=a.index,f=a.attributes.position,u=a.attributes.uv,m=a.attributes.uv1,v=a.attributes.normal,g=a.groups,y=a.drawRange;if(c!==null)if(Array.isArray(l))for(let M=0,A=g.length;M<A;M++){let S=g[M],_=l[S.materialIndex],P=Math.max(S.start,y.start),U=Math.min(c.count,Math.min(S.start+S.count,y.start+y.count));for(let I=P,O=U;I<O;I+=3){let N=c.getX(I),w=c.getX(I+1),D=c.getX(I+2);r=ro(this,_,e,n,u,m,v,N,w,D),r&&(r.faceIndex=Math.floor(I/3),r.face.materialIndex=S.materialIndex,t.push(r))}}else{let M=Math.max(0,y.start),A=Math.min(c.count,y.start+y.count);for(let S=M,_=A;S<_;S+=3){let P=c.getX(S),U=c.getX(S+1),I=c.getX(S+2);r=ro(this,l,e,n,u,m,v,P,U,I),r&&(r.faceIndex=Math.floor(S/3),t.push(r))}}else if(f!==void 0)if(Array.isArray(l))for(let M=0,A=g.length;M<A;M++){let S=g[M],_=l[S.materialIndex],P=Math.max(S.start,y.start),U=Math.min(f.count,Math.min(S.start+S.count,y.start+y.count));for(let I=P,O=U;I<O;I+=3){let N=I,w=I+1,D=I+2;r=ro(this,_,e,n,u,m,v,N,w,D),r&&(r.faceIndex=Math.floor(I/3),r.face.materialIndex=S.materialIndex,t.push(r))}}else{let M=Math.max(0,y.start),A=Math.min(f.count,y.start+y.count);for(let S=M,_=A;S<_;S+=3){let P=S,U=S+1,I=S+2;r=ro(this,l,e,n,u,m,v,P,U,I),r&&(r.faceIndex=Math.floor(S/3),t.push(r))}}}};function Wv(i,e,t,n,r,a,l,c){let f;if(e.side===dn?f=n.intersectTriangle(l,a,r,!0,c):f=n.intersectTriangle(r,a,l,e.side===Ji,c),f===null)return null;io.copy(c),io.applyMatrix4(i.matrixWorld);let u=t.ray.origin.distanceTo(io);return u<t.near||u>t.far?null:{distance:u,point:io.clone(),object:i}}function ro(i,e,t,n,r,a,l,c,f,u){i.getVertexPosition(c,Qa),i.getVertexPosition(f,eo),i.getVertexPosition(u,to);let m=Wv(i,e,t,n,Qa,eo,to,ju);if(m){let v=new j;Vi.getBarycoord(ju,Qa,eo,to,v),r&&(m.uv=Vi.getInterpolatedAttribute(r,c,f,u,v,new tt)),a&&(m.uv1=Vi.getInterpolatedAttribute(a,c,f,u,v,new tt)),l&&(m.normal=Vi.getInterpolatedAttribute(l,c,f,u,v,new j),m.normal.dot(n.direction)>0&&m.normal.multiplyScalar(-1));let g={a:c,b:f,c:u,normal:new j,materialIndex:0};Vi.getNormal(Qa,eo,to,g.normal),m.face=g,m.barycoord=v}return m}var Fs=class extends wn{constructor(e=null,t=1,n=1,r,a,l,c,f,u=cn,m=cn,v,g){super(null,l,c,f,u,m,r,a,v,g),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ns=class extends Tn{constructor(e,t,n,r=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Fr=new Lt,Zu=new Lt,so=[],Ju=new hi,Xv=new Lt,ys=new Ot,xs=new Ai,Us=class extends Ot{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Ns(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<n;r++)this.setMatrixAt(r,Xv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new hi),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Fr),Ju.copy(e.boundingBox).applyMatrix4(Fr),this.boundingBox.union(Ju)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ai),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Fr),xs.copy(e.boundingSphere).applyMatrix4(Fr),this.boundingSphere.union(xs)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,r=this.morphTexture.source.data.data,a=n.length+1,l=e*a+1;for(let c=0;c<n.length;c++)n[c]=r[l+c]}raycast(e,t){let n=this.matrixWorld,r=this.count;if(ys.geometry=this.geometry,ys.material=this.material,ys.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),xs.copy(this.boundingSphere),xs.applyMatrix4(n),e.ray.intersectsSphere(xs)!==!1))for(let a=0;a<r;a++){this.getMatrixAt(a,Fr),Zu.multiplyMatrices(n,Fr),ys.matrixWorld=Zu,ys.raycast(e,so);for(let l=0,c=so.length;l<c;l++){let f=so[l];f.instanceId=a,f.object=this,t.push(f)}so.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Ns(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,r=n.length+1;this.morphTexture===null&&(this.morphTexture=new Fs(new Float32Array(r*this.count),r,this.count,el,Vn));let a=this.morphTexture.source.data.data,l=0;for(let u=0;u<n.length;u++)l+=n[u];let c=this.geometry.morphTargetsRelative?1:1-l,f=r*e;return a[f]=c,a.set(n,f+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},ur=new Ai,$v=new tt(.5,.5),ao=new j,Wi=class{constructor(e=new Ln,t=new Ln,n=new Ln,r=new Ln,a=new Ln,l=new Ln){this.planes=[e,t,n,r,a,l]}set(e,t,n,r,a,l){let c=this.planes;return c[0].copy(e),c[1].copy(t),c[2].copy(n),c[3].copy(r),c[4].copy(a),c[5].copy(l),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=zn,n=!1){let r=this.planes,a=e.elements,l=a[0],c=a[1],f=a[2],u=a[3],m=a[4],v=a[5],g=a[6],y=a[7],M=a[8],A=a[9],S=a[10],_=a[11],P=a[12],U=a[13],I=a[14],O=a[15];if(r[0].setComponents(u-l,y-m,_-M,O-P).normalize(),r[1].setComponents(u+l,y+m,_+M,O+P).normalize(),r[2].setComponents(u+c,y+v,_+A,O+U).normalize(),r[3].setComponents(u-c,y-v,_-A,O-U).normalize(),n)r[4].setComponents(f,g,S,I).normalize(),r[5].setComponents(u-f,y-g,_-S,O-I).normalize();else if(r[4].setComponents(u-f,y-g,_-S,O-I).normalize(),t===zn)r[5].setComponents(u+f,y+g,_+S,O+I).normalize();else if(t===Gr)r[5].setComponents(f,g,S,I).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ur.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ur.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ur)}intersectsSprite(e){ur.center.set(0,0,0);let t=$v.distanceTo(e.center);return ur.radius=.7071067811865476+t,ur.applyMatrix4(e.matrixWorld),this.intersectsSphere(ur)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let a=0;a<6;a++)if(t[a].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(ao.x=r.normal.x>0?e.max.x:e.min.x,ao.y=r.normal.y>0?e.max.y:e.min.y,ao.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(ao)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Ku=new Lt,Co=class i{constructor(){this.coordinateSystem=zn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let a=t[r];Ku.multiplyMatrices(a.projectionMatrix,a.matrixWorldInverse),n[r]===void 0&&(n[r]=new Wi),n[r].setFromProjectionMatrix(Ku,a.coordinateSystem,a.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Wi),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Os=class extends ui{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ro=new j,Po=new j,Qu=new Lt,Ss=new Hi,oo=new Ai,Dc=new j,ed=new j,Io=class extends Qt{constructor(e=new En,t=new Os){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let r=1,a=t.count;r<a;r++)Ro.fromBufferAttribute(t,r-1),Po.fromBufferAttribute(t,r),n[r]=n[r-1],n[r]+=Ro.distanceTo(Po);e.setAttribute("lineDistance",new Xt(n,1))}else et("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,a=e.params.Line.threshold,l=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),oo.copy(n.boundingSphere),oo.applyMatrix4(r),oo.radius+=a,e.ray.intersectsSphere(oo)===!1)return;Qu.copy(r).invert(),Ss.copy(e.ray).applyMatrix4(Qu);let c=a/((this.scale.x+this.scale.y+this.scale.z)/3),f=c*c,u=this.isLineSegments?2:1,m=n.index,g=n.attributes.position;if(m!==null){let y=Math.max(0,l.start),M=Math.min(m.count,l.start+l.count);for(let A=y,S=M-1;A<S;A+=u){let _=m.getX(A),P=m.getX(A+1),U=lo(this,e,Ss,f,_,P,A);U&&t.push(U)}if(this.isLineLoop){let A=m.getX(M-1),S=m.getX(y),_=lo(this,e,Ss,f,A,S,M-1);_&&t.push(_)}}else{let y=Math.max(0,l.start),M=Math.min(g.count,l.start+l.count);for(let A=y,S=M-1;A<S;A+=u){let _=lo(this,e,Ss,f,A,A+1,A);_&&t.push(_)}if(this.isLineLoop){let A=lo(this,e,Ss,f,M-1,y,M-1);A&&t.push(A)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let a=0,l=r.length;a<l;a++){let c=r[a].name||String(a);this.morphTargetInfluences.push(0),this.morphTargetDictionary[c]=a}}}}};function lo(i,e,t,n,r,a,l){let c=i.geometry.attributes.position;if(Ro.fromBufferAttribute(c,r),Po.fromBufferAttribute(c,a),t.distanceSqToSegment(Ro,Po,Dc,ed)>n)return;Dc.applyMatrix4(i.matrixWorld);let u=e.ray.origin.distanceTo(Dc);if(!(u<e.near||u>e.far))return{distance:u,point:ed.clone().applyMatrix4(i.matrixWorld),index:l,face:null,faceIndex:null,barycoord:null,object:i}}var Bs=class extends wn{constructor(e=[],t=_r,n,r,a,l,c,f,u,m){super(e,t,n,r,a,l,c,f,u,m),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ks=class extends wn{constructor(e,t,n,r,a,l,c,f,u){super(e,t,n,r,a,l,c,f,u),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ci=class extends wn{constructor(e,t,n=Jn,r,a,l,c=cn,f=cn,u,m=Ti,v=1){if(m!==Ti&&m!==Ii)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let g={width:e,height:t,depth:v};super(g,r,a,l,c,f,m,n,u),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Wr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},zs=class extends Ci{constructor(e,t=Jn,n=_r,r,a,l=cn,c=cn,f,u=Ti){let m={width:e,height:e,depth:1},v=[m,m,m,m,m,m];super(e,e,t,n,r,a,l,c,f,u),this.image=v,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Gs=class extends wn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},di=class i extends En{constructor(e=1,t=1,n=1,r=1,a=1,l=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:a,depthSegments:l};let c=this;r=Math.floor(r),a=Math.floor(a),l=Math.floor(l);let f=[],u=[],m=[],v=[],g=0,y=0;M("z","y","x",-1,-1,n,t,e,l,a,0),M("z","y","x",1,-1,n,t,-e,l,a,1),M("x","z","y",1,1,e,n,t,r,l,2),M("x","z","y",1,-1,e,n,-t,r,l,3),M("x","y","z",1,-1,e,t,n,r,a,4),M("x","y","z",-1,-1,e,t,-n,r,a,5),this.setIndex(f),this.setAttribute("position",new Xt(u,3)),this.setAttribute("normal",new Xt(m,3)),this.setAttribute("uv",new Xt(v,2));function M(A,S,_,P,U,I,O,N,w,D,X){let k=I/w,Y=O/D,Z=I/2,ee=O/2,z=N/2,ie=w+1,G=D+1,ne=0,Se=0,re=new j;for(let H=0;H<G;H++){let ge=H*Y-ee;for(let We=0;We<ie;We++){let rt=We*k-Z;re[A]=rt*P,re[S]=ge*U,re[_]=z,u.push(re.x,re.y,re.z),re[A]=0,re[S]=0,re[_]=N>0?1:-1,m.push(re.x,re.y,re.z),v.push(We/w),v.push(1-H/D),ne+=1}}for(let H=0;H<D;H++)for(let ge=0;ge<w;ge++){let We=g+ge+ie*H,rt=g+ge+ie*(H+1),ue=g+(ge+1)+ie*(H+1),Fe=g+(ge+1)+ie*H;f.push(We,rt,Fe),f.push(rt,ue,Fe),Se+=6}c.addGroup(y,Se,X),y+=Se,g+=ne}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},Vs=class i extends En{constructor(e=1,t=1,n=4,r=8,a=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:r,heightSegments:a},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),r=Math.max(3,Math.floor(r)),a=Math.max(1,Math.floor(a));let l=[],c=[],f=[],u=[],m=t/2,v=Math.PI/2*e,g=t,y=2*v+g,M=n*2+a,A=r+1,S=new j,_=new j;for(let P=0;P<=M;P++){let U=0,I=0,O=0,N=0;if(P<=n){let X=P/n,k=X*Math.PI/2;I=-m-e*Math.cos(k),O=e*Math.sin(k),N=-e*Math.cos(k),U=X*v}else if(P<=n+a){let X=(P-n)/a;I=-m+X*t,O=e,N=0,U=v+X*g}else{let X=(P-n-a)/n,k=X*Math.PI/2;I=m+e*Math.sin(k),O=e*Math.cos(k),N=e*Math.sin(k),U=v+g+X*v}let w=Math.max(0,Math.min(1,U/y)),D=0;P===0?D=.5/r:P===M&&(D=-.5/r);for(let X=0;X<=r;X++){let k=X/r,Y=k*Math.PI*2,Z=Math.sin(Y),ee=Math.cos(Y);_.x=-O*ee,_.y=I,_.z=O*Z,c.push(_.x,_.y,_.z),S.set(-O*ee,N,O*Z),S.normalize(),f.push(S.x,S.y,S.z),u.push(k+D,w)}if(P>0){let X=(P-1)*A;for(let k=0;k<r;k++){let Y=X+k,Z=X+k+1,ee=P*A+k,z=P*A+k+1;l.push(Y,Z,ee),l.push(Z,z,ee)}}}this.setIndex(l),this.setAttribute("position",new Xt(c,3)),this.setAttribute("normal",new Xt(f,3)),this.setAttribute("uv",new Xt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var qr=class i extends En{constructor(e=1,t=1,n=1,r=32,a=1,l=!1,c=0,f=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:r,heightSegments:a,openEnded:l,thetaStart:c,thetaLength:f};let u=this;r=Math.floor(r),a=Math.floor(a);let m=[],v=[],g=[],y=[],M=0,A=[],S=n/2,_=0;P(),l===!1&&(e>0&&U(!0),t>0&&U(!1)),this.setIndex(m),this.setAttribute("position",new Xt(v,3)),this.setAttribute("normal",new Xt(g,3)),this.setAttribute("uv",new Xt(y,2));function P(){let I=new j,O=new j,N=0,w=(t-e)/n;for(let D=0;D<=a;D++){let X=[],k=D/a,Y=k*(t-e)+e;for(let Z=0;Z<=r;Z++){let ee=Z/r,z=ee*f+c,ie=Math.sin(z),G=Math.cos(z);O.x=Y*ie,O.y=-k*n+S,O.z=Y*G,v.push(O.x,O.y,O.z),I.set(ie,w,G).normalize(),g.push(I.x,I.y,I.z),y.push(ee,1-k),X.push(M++)}A.push(X)}for(let D=0;D<r;D++)for(let X=0;X<a;X++){let k=A[X][D],Y=A[X+1][D],Z=A[X+1][D+1],ee=A[X][D+1];(e>0||X!==0)&&(m.push(k,Y,ee),N+=3),(t>0||X!==a-1)&&(m.push(Y,Z,ee),N+=3)}u.addGroup(_,N,0),_+=N}function U(I){let O=M,N=new tt,w=new j,D=0,X=I===!0?e:t,k=I===!0?1:-1;for(let Z=1;Z<=r;Z++)v.push(0,S*k,0),g.push(0,k,0),y.push(.5,.5),M++;let Y=M;for(let Z=0;Z<=r;Z++){let z=Z/r*f+c,ie=Math.cos(z),G=Math.sin(z);w.x=X*G,w.y=S*k,w.z=X*ie,v.push(w.x,w.y,w.z),g.push(0,k,0),N.x=ie*.5+.5,N.y=G*.5*k+.5,y.push(N.x,N.y),M++}for(let Z=0;Z<r;Z++){let ee=O+Z,z=Y+Z;I===!0?m.push(z,z+1,ee):m.push(z+1,z,ee),D+=3}u.addGroup(_,D,I===!0?1:2),_+=D}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Do=class i extends qr{constructor(e=1,t=1,n=32,r=1,a=!1,l=0,c=Math.PI*2){super(0,e,t,n,r,a,l,c),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:r,openEnded:a,thetaStart:l,thetaLength:c}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Xi=class i extends En{constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let a=e/2,l=t/2,c=Math.floor(n),f=Math.floor(r),u=c+1,m=f+1,v=e/c,g=t/f,y=[],M=[],A=[],S=[];for(let _=0;_<m;_++){let P=_*g-l;for(let U=0;U<u;U++){let I=U*v-a;M.push(I,-P,0),A.push(0,0,1),S.push(U/c),S.push(1-_/f)}}for(let _=0;_<f;_++)for(let P=0;P<c;P++){let U=P+u*_,I=P+u*(_+1),O=P+1+u*(_+1),N=P+1+u*_;y.push(U,I,N),y.push(I,O,N)}this.setIndex(y),this.setAttribute("position",new Xt(M,3)),this.setAttribute("normal",new Xt(A,3)),this.setAttribute("uv",new Xt(S,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var fr=class i extends En{constructor(e=1,t=32,n=16,r=0,a=Math.PI*2,l=0,c=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:r,phiLength:a,thetaStart:l,thetaLength:c},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let f=Math.min(l+c,Math.PI),u=0,m=[],v=new j,g=new j,y=[],M=[],A=[],S=[];for(let _=0;_<=n;_++){let P=[],U=_/n,I=l+U*c,O=e*Math.cos(I),N=Math.sqrt(e*e-O*O),w=0;_===0&&l===0?w=.5/t:_===n&&f===Math.PI&&(w=-.5/t);for(let D=0;D<=t;D++){let X=D/t,k=r+X*a;v.x=-N*Math.cos(k),v.y=O,v.z=N*Math.sin(k),M.push(v.x,v.y,v.z),g.copy(v).normalize(),A.push(g.x,g.y,g.z),S.push(X+w,1-U),P.push(u++)}m.push(P)}for(let _=0;_<n;_++)for(let P=0;P<t;P++){let U=m[_][P+1],I=m[_][P],O=m[_+1][P],N=m[_+1][P+1];(_!==0||l>0)&&y.push(U,I,N),(_!==n-1||f<Math.PI)&&y.push(I,O,N)}this.setIndex(y),this.setAttribute("position",new Xt(M,3)),this.setAttribute("normal",new Xt(A,3)),this.setAttribute("uv",new Xt(S,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function yr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(td(r))r.isRenderTargetTexture?(et("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(td(r[0])){let a=[];for(let l=0,c=r.length;l<c;l++)a[l]=r[l].clone();e[t][n]=a}else e[t][n]=r.slice();else e[t][n]=r}}return e}function vn(i){let e={};for(let t=0;t<i.length;t++){let n=yr(i[t]);for(let r in n)e[r]=n[r]}return e}function td(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function qv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function vh(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Jd={clone:yr,merge:vn},Yv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,jv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,fi=class extends ui{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Yv,this.fragmentShader=jv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=yr(e.uniforms),this.uniformsGroups=qv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let l=this.uniforms[r].value;l&&l.isTexture?t.uniforms[r]={type:"t",value:l.toJSON(e).uuid}:l&&l.isColor?t.uniforms[r]={type:"c",value:l.getHex()}:l&&l.isVector2?t.uniforms[r]={type:"v2",value:l.toArray()}:l&&l.isVector3?t.uniforms[r]={type:"v3",value:l.toArray()}:l&&l.isVector4?t.uniforms[r]={type:"v4",value:l.toArray()}:l&&l.isMatrix3?t.uniforms[r]={type:"m3",value:l.toArray()}:l&&l.isMatrix4?t.uniforms[r]={type:"m4",value:l.toArray()}:t.uniforms[r]={value:l}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new ht().setHex(r.value);break;case"v2":this.uniforms[n].value=new tt().fromArray(r.value);break;case"v3":this.uniforms[n].value=new j().fromArray(r.value);break;case"v4":this.uniforms[n].value=new Gt().fromArray(r.value);break;case"m3":this.uniforms[n].value=new ct().fromArray(r.value);break;case"m4":this.uniforms[n].value=new Lt().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Lo=class extends fi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ri=class extends ui{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=la,this.normalScale=new tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ci,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Hs=class extends ui{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=la,this.normalScale=new tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ci,this.combine=qo,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Fo=class extends ui{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Nd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},No=class extends ui{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Nr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function co(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var $i=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],a=t[n-1];e:{t:{let l;n:{i:if(!(e<r)){for(let c=n+2;;){if(r===void 0){if(e<a)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===c)break;if(a=r,r=t[++n],e<r)break t}l=t.length;break n}if(!(e>=a)){let c=t[1];e<c&&(n=2,a=c);for(let f=n-2;;){if(a===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===f)break;if(r=a,a=t[--n-1],e>=a)break t}l=n,n=0;break n}break e}for(;n<l;){let c=n+l>>>1;e<t[c]?l=c:n=c+1}if(r=t[n],a=t[n-1],a===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,a,r)}return this.interpolate_(n,a,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,a=e*r;for(let l=0;l!==r;++l)t[l]=n[a+l];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Uo=class extends $i{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Uc,endingEnd:Uc}}intervalChanged_(e,t,n){let r=this.parameterPositions,a=e-2,l=e+1,c=r[a],f=r[l];if(c===void 0)switch(this.getSettings_().endingStart){case Oc:a=e,c=2*t-n;break;case Bc:a=r.length-2,c=t+r[a]-r[a+1];break;default:a=e,c=n}if(f===void 0)switch(this.getSettings_().endingEnd){case Oc:l=e,f=2*n-t;break;case Bc:l=1,f=n+r[1]-r[0];break;default:l=e-1,f=t}let u=(n-t)*.5,m=this.valueSize;this._weightPrev=u/(t-c),this._weightNext=u/(f-n),this._offsetPrev=a*m,this._offsetNext=l*m}interpolate_(e,t,n,r){let a=this.resultBuffer,l=this.sampleValues,c=this.valueSize,f=e*c,u=f-c,m=this._offsetPrev,v=this._offsetNext,g=this._weightPrev,y=this._weightNext,M=(n-t)/(r-t),A=M*M,S=A*M,_=-g*S+2*g*A-g*M,P=(1+g)*S+(-1.5-2*g)*A+(-.5+g)*M+1,U=(-1-y)*S+(1.5+y)*A+.5*M,I=y*S-y*A;for(let O=0;O!==c;++O)a[O]=_*l[m+O]+P*l[u+O]+U*l[f+O]+I*l[v+O];return a}},Oo=class extends $i{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let a=this.resultBuffer,l=this.sampleValues,c=this.valueSize,f=e*c,u=f-c,m=(n-t)/(r-t),v=1-m;for(let g=0;g!==c;++g)a[g]=l[u+g]*v+l[f+g]*m;return a}},Bo=class extends $i{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},ko=class extends $i{interpolate_(e,t,n,r){let a=this.resultBuffer,l=this.sampleValues,c=this.valueSize,f=e*c,u=f-c,m=this.inTangents,v=this.outTangents;if(!m||!v){let M=(n-t)/(r-t),A=1-M;for(let S=0;S!==c;++S)a[S]=l[u+S]*A+l[f+S]*M;return a}let g=c*2,y=e-1;for(let M=0;M!==c;++M){let A=l[u+M],S=l[f+M],_=y*g+M*2,P=v[_],U=v[_+1],I=e*g+M*2,O=m[I],N=m[I+1],w=Jv(n,t,P,O,r);a[M]=Kd(w,A,U,N,S)}return a}};function Kd(i,e,t,n,r){let a=1-i;return a*a*a*e+3*a*a*i*t+3*a*i*i*n+i*i*i*r}function Zv(i,e,t,n,r){let a=1-i;return 3*a*a*(t-e)+6*a*i*(n-t)+3*i*i*(r-n)}function Jv(i,e,t,n,r){let a=(i-e)/(r-e);for(let l=0;l<8;l++){let c=Kd(a,e,t,n,r)-i;if(Math.abs(c)<1e-10)break;let f=Zv(a,e,t,n,r);if(Math.abs(f)<1e-10)break;a=Math.max(0,Math.min(1,a-c/f))}return a}var Nn=class{constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Nr(t,this.TimeBufferType),this.values=Nr(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Nr(e.times,Array),values:Nr(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),co(e.settings)&&(n.settings={inTangents:Nr(e.settings.inTangents,Array),outTangents:Nr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Bo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Oo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Uo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ko(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Es:t=this.InterpolantFactoryMethodDiscrete;break;case wo:t=this.InterpolantFactoryMethodLinear;break;case po:t=this.InterpolantFactoryMethodSmooth;break;case Nc:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return et("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Es;case this.InterpolantFactoryMethodLinear:return wo;case this.InterpolantFactoryMethodSmooth:return po;case this.InterpolantFactoryMethodBezier:return Nc}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;co(this.settings)&&(nd(this.settings.inTangents,e),nd(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;co(this.settings)&&(id(this.settings.inTangents,e),id(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,a=0,l=r-1;for(;a!==r&&n[a]<e;)++a;for(;l!==-1&&n[l]>t;)--l;if(++l,a!==0||l!==r){a>=l&&(l=Math.max(l,1),a=l-1);let c=this.getValueSize();this.times=n.slice(a,l),this.values=this.values.slice(a*c,l*c)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,a=n.length;a===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let l=null;for(let c=0;c!==a;c++){let f=n[c];if(typeof f=="number"&&isNaN(f)){it("KeyframeTrack: Time is not a valid number.",this,c,f),e=!1;break}if(l!==null&&l>f){it("KeyframeTrack: Out of order keys.",this,c,f,l),e=!1;break}l=f}if(r!==void 0&&dv(r))for(let c=0,f=r.length;c!==f;++c){let u=r[c];if(isNaN(u)){it("KeyframeTrack: Value is not a valid number.",this,c,u),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===po,a=e.length-1,l=1;for(let c=1;c<a;++c){let f=!1,u=e[c],m=e[c+1];if(u!==m&&(c!==1||u!==e[0]))if(r)f=!0;else{let v=c*n,g=v-n,y=v+n;for(let M=0;M!==n;++M){let A=t[v+M];if(A!==t[g+M]||A!==t[y+M]){f=!0;break}}}if(f){if(c!==l){e[l]=e[c];let v=c*n,g=l*n;for(let y=0;y!==n;++y)t[g+y]=t[v+y]}++l}}if(a>0){e[l]=e[a];for(let c=a*n,f=l*n,u=0;u!==n;++u)t[f+u]=t[c+u];++l}return l!==e.length?(this.times=e.slice(0,l),this.values=t.slice(0,l*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,co(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function nd(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function id(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Nn.prototype.ValueTypeName="";Nn.prototype.TimeBufferType=Float32Array;Nn.prototype.ValueBufferType=Float32Array;Nn.prototype.DefaultInterpolation=wo;var qi=class extends Nn{constructor(e,t,n){super(e,t,n)}};qi.prototype.ValueTypeName="bool";qi.prototype.ValueBufferType=Array;qi.prototype.DefaultInterpolation=Es;qi.prototype.InterpolantFactoryMethodLinear=void 0;qi.prototype.InterpolantFactoryMethodSmooth=void 0;var zo=class extends Nn{constructor(e,t,n,r){super(e,t,n,r)}};zo.prototype.ValueTypeName="color";var Go=class extends Nn{constructor(e,t,n,r){super(e,t,n,r)}};Go.prototype.ValueTypeName="number";var Vo=class extends $i{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let a=this.resultBuffer,l=this.sampleValues,c=this.valueSize,f=(n-t)/(r-t),u=e*c;for(let m=u+c;u!==m;u+=4)bn.slerpFlat(a,0,l,u-c,l,u,f);return a}},Ws=class extends Nn{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new Vo(this.times,this.values,this.getValueSize(),e)}};Ws.prototype.ValueTypeName="quaternion";Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Yi=class extends Nn{constructor(e,t,n){super(e,t,n)}};Yi.prototype.ValueTypeName="string";Yi.prototype.ValueBufferType=Array;Yi.prototype.DefaultInterpolation=Es;Yi.prototype.InterpolantFactoryMethodLinear=void 0;Yi.prototype.InterpolantFactoryMethodSmooth=void 0;var Ho=class extends Nn{constructor(e,t,n,r){super(e,t,n,r)}};Ho.prototype.ValueTypeName="vector";var Wo=class{constructor(e,t,n){let r=this,a=!1,l=0,c=0,f,u=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(m){c++,a===!1&&r.onStart!==void 0&&r.onStart(m,l,c),a=!0},this.itemEnd=function(m){l++,r.onProgress!==void 0&&r.onProgress(m,l,c),l===c&&(a=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(m){r.onError!==void 0&&r.onError(m)},this.resolveURL=function(m){return m=m.normalize("NFC"),f?f(m):m},this.setURLModifier=function(m){return f=m,this},this.addHandler=function(m,v){return u.push(m,v),this},this.removeHandler=function(m){let v=u.indexOf(m);return v!==-1&&u.splice(v,2),this},this.getHandler=function(m){for(let v=0,g=u.length;v<g;v+=2){let y=u[v],M=u[v+1];if(y.global&&(y.lastIndex=0),y.test(m))return M}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Qd=new Wo,Xo=class{constructor(e){this.manager=e!==void 0?e:Qd,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,a){n.load(e,r,t,a)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Xo.DEFAULT_MATERIAL_NAME="__DEFAULT";var Xs=class extends Qt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Lc=new Lt,rd=new j,sd=new j,$s=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new tt(512,512),this.mapType=An,this.map=null,this.mapPass=null,this.matrix=new Lt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Wi,this._frameExtents=new tt(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;rd.setFromMatrixPosition(e.matrixWorld),t.position.copy(rd),sd.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(sd),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,r){Lc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Lc,e.coordinateSystem,e.reversedDepth);let a=this._frameExtents,l=r?r.z/a.x:1,c=r?r.w/a.y:1,f=r?r.x/a.x:0,u=r?r.y/a.y:0;e.coordinateSystem===Gr||e.reversedDepth?t.set(.5*l,0,0,.5*l+f,0,.5*c,0,.5*c+u,0,0,1,0,0,0,0,1):t.set(.5*l,0,0,.5*l+f,0,.5*c,0,.5*c+u,0,0,.5,.5,0,0,0,1),t.multiply(Lc)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ho=new j,uo=new bn,oi=new j,qs=class extends Qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Lt,this.projectionMatrix=new Lt,this.projectionMatrixInverse=new Lt,this.coordinateSystem=zn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ho,uo,oi),oi.x===1&&oi.y===1&&oi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ho,uo,oi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ho,uo,oi),oi.x===1&&oi.y===1&&oi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ho,uo,oi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Gi=new j,ad=new tt,od=new tt,_n=class extends qs{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Hr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(bs*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Hr*2*Math.atan(Math.tan(bs*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Gi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Gi.x,Gi.y).multiplyScalar(-e/Gi.z),Gi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Gi.x,Gi.y).multiplyScalar(-e/Gi.z)}getViewSize(e,t){return this.getViewBounds(e,ad,od),t.subVectors(od,ad)}setViewOffset(e,t,n,r,a,l){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=a,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(bs*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,a=-.5*r,l=this.view;if(this.view!==null&&this.view.enabled){let f=l.fullWidth,u=l.fullHeight;a+=l.offsetX*r/f,t-=l.offsetY*n/u,r*=l.width/f,n*=l.height/u}let c=this.filmOffset;c!==0&&(a+=e*c/this.getFilmWidth()),this.projectionMatrix.makePerspective(a,a+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var kc=class extends $s{constructor(){super(new _n(90,1,.5,500)),this.isPointLightShadow=!0}},Ys=class extends Xs{constructor(e,t,n=0,r=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=r,this.shadow=new kc}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},js=class extends qs{constructor(e=-1,t=1,n=1,r=-1,a=.1,l=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=a,this.far=l,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,a,l){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=a,this.view.height=l,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,a=n-e,l=n+e,c=r+t,f=r-t;if(this.view!==null&&this.view.enabled){let u=(this.right-this.left)/this.view.fullWidth/this.zoom,m=(this.top-this.bottom)/this.view.fullHeight/this.zoom;a+=u*this.view.offsetX,l=a+u*this.view.width,c-=m*this.view.offsetY,f=c-m*this.view.height}this.projectionMatrix.makeOrthographic(a,l,c,f,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},zc=class extends $s{constructor(){super(new js(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Zs=class extends Xs{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.shadow=new zc}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Ur=-90,Or=1,Yr=class extends Qt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new _n(Ur,Or,e,t);r.layers=this.layers,this.add(r);let a=new _n(Ur,Or,e,t);a.layers=this.layers,this.add(a);let l=new _n(Ur,Or,e,t);l.layers=this.layers,this.add(l);let c=new _n(Ur,Or,e,t);c.layers=this.layers,this.add(c);let f=new _n(Ur,Or,e,t);f.layers=this.layers,this.add(f);let u=new _n(Ur,Or,e,t);u.layers=this.layers,this.add(u)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,a,l,c,f]=t;for(let u of t)this.remove(u);if(e===zn)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),a.up.set(0,0,-1),a.lookAt(0,1,0),l.up.set(0,0,1),l.lookAt(0,-1,0),c.up.set(0,1,0),c.lookAt(0,0,1),f.up.set(0,1,0),f.lookAt(0,0,-1);else if(e===Gr)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),a.up.set(0,0,1),a.lookAt(0,1,0),l.up.set(0,0,-1),l.lookAt(0,-1,0),c.up.set(0,-1,0),c.lookAt(0,0,1),f.up.set(0,-1,0),f.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let u of t)this.add(u),u.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[a,l,c,f,u,m]=this.children,v=e.getRenderTarget(),g=e.getActiveCubeFace(),y=e.getActiveMipmapLevel(),M=e.xr.enabled;e.xr.enabled=!1;let A=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let S=!1;e.isWebGLRenderer===!0?S=e.state.buffers.depth.getReversed():S=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,1,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,2,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,3,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,f),e.setRenderTarget(n,4,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),n.texture.mipmapsAutoUpdate=A,e.setRenderTarget(n,5,r),S&&e.autoClear===!1&&e.clearDepth(),e.render(t,m),e.setRenderTarget(v,g,y),e.xr.enabled=M,n.texture.needsPMREMUpdate=!0}},$o=class extends _n{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var yh="\\[\\]\\.:\\/",Kv=new RegExp("["+yh+"]","g"),xh="[^"+yh+"]",Qv="[^"+yh.replace("\\.","")+"]",ey=/((?:WC+[\/:])*)/.source.replace("WC",xh),ty=/(WCOD+)?/.source.replace("WCOD",Qv),ny=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xh),iy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xh),ry=new RegExp("^"+ey+ty+ny+iy+"$"),sy=["material","materials","bones","map"],Gc=class{constructor(e,t,n){let r=n||zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,a=n.length;r!==a;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},zt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Kv,"")}static parseTrackName(e){let t=ry.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let a=n.nodeName.substring(r+1);sy.indexOf(a)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=a)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(a){for(let l=0;l<a.length;l++){let c=a[l];if(c.name===t||c.uuid===t)return c;let f=n(c.children);if(f)return f}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,a=n.length;r!==a;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,a=n.length;r!==a;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,a=n.length;r!==a;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,a=n.length;r!==a;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,a=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){et("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let u=t.objectIndex;switch(n){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let m=0;m<e.length;m++)if(e[m].name===u){u=m;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(u!==void 0){if(e[u]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[u]}}let l=e[r];if(l===void 0){let u=t.nodeName;it("PropertyBinding: Trying to update property for track: "+u+"."+r+" but it wasn't found.",e);return}let c=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?c=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(c=this.Versioning.MatrixWorldNeedsUpdate);let f=this.BindingType.Direct;if(a!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[a]!==void 0&&(a=e.morphTargetDictionary[a])}f=this.BindingType.ArrayElement,this.resolvedProperty=l,this.propertyIndex=a}else l.fromArray!==void 0&&l.toArray!==void 0?(f=this.BindingType.HasFromToArray,this.resolvedProperty=l):Array.isArray(l)?(f=this.BindingType.EntireArray,this.resolvedProperty=l):this.propertyName=r;this.getValue=this.GetterByBindingType[f],this.setValue=this.SetterByBindingTypeAndVersioning[f][c]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};zt.Composite=Gc;zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};zt.prototype.GetterByBindingType=[zt.prototype._getValue_direct,zt.prototype._getValue_array,zt.prototype._getValue_arrayElement,zt.prototype._getValue_toArray];zt.prototype.SetterByBindingTypeAndVersioning=[[zt.prototype._setValue_direct,zt.prototype._setValue_direct_setNeedsUpdate,zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_array,zt.prototype._setValue_array_setNeedsUpdate,zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_arrayElement,zt.prototype._setValue_arrayElement_setNeedsUpdate,zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_fromArray,zt.prototype._setValue_fromArray_setNeedsUpdate,zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var oE=new Float32Array(1);var ld=new Lt,Js=class{constructor(e,t,n=0,r=1/0){this.ray=new Hi(e,t),this.near=n,this.far=r,this.camera=null,this.layers=new Xr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):it("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return ld.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(ld),this}intersectObject(e,t=!0,n=[]){return Vc(e,this,n,t),n.sort(cd),n}intersectObjects(e,t=!0,n=[]){for(let r=0,a=e.length;r<a;r++)Vc(e[r],this,n,t);return n.sort(cd),n}};function cd(i,e){return i.distance-e.distance}function Vc(i,e,t,n){let r=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(r=!1),r===!0&&n===!0){let a=i.children;for(let l=0,c=a.length;l<c;l++)Vc(a[l],e,t,!0)}}var jr=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(yt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Hc=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let a=this.elements;return a[0]=e,a[2]=t,a[1]=n,a[3]=r,this}};var hd=new j,fo,Fc,Ks=class extends Qt{constructor(e=new j(0,0,1),t=new j(0,0,0),n=1,r=16776960,a=n*.2,l=a*.2){super(),this.type="ArrowHelper",fo===void 0&&(fo=new En,fo.setAttribute("position",new Xt([0,0,0,0,1,0],3)),Fc=new Do(.5,1,5,1),Fc.translate(0,-.5,0)),this.position.copy(t),this.line=new Io(fo,new Os({color:r,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Ot(Fc,new Ls({color:r,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,a,l)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{hd.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(hd,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var Qs=class extends Zn{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Sh(i,e,t,n){let r=ay(n);switch(t){case oh:return i*e;case el:return i*e/r.components*r.byteLength;case tl:return i*e/r.components*r.byteLength;case Ki:return i*e*2/r.components*r.byteLength;case nl:return i*e*2/r.components*r.byteLength;case lh:return i*e*3/r.components*r.byteLength;case Qn:return i*e*4/r.components*r.byteLength;case il:return i*e*4/r.components*r.byteLength;case na:case ia:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ra:case sa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case sl:case ol:return Math.max(i,16)*Math.max(e,8)/4;case rl:case al:return Math.max(i,8)*Math.max(e,8)/2;case ll:case cl:case ul:case dl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case hl:case aa:case fl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case pl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ml:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case gl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case _l:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case vl:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case yl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case xl:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Sl:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Ml:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case bl:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case wl:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case El:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Tl:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Al:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Cl:case Rl:case Pl:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Il:case Dl:return Math.ceil(i/4)*Math.ceil(e/4)*8;case oa:case Ll:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function ay(i){switch(i){case An:case ih:return{byteLength:1,components:1};case Qr:case rh:case Kn:return{byteLength:2,components:1};case Ko:case Qo:return{byteLength:2,components:4};case Jn:case Jo:case Vn:return{byteLength:4,components:1};case sh:case ah:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?et("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Mf(){let i=null,e=!1,t=null,n=null;function r(a,l){n=i.requestAnimationFrame(r),t(a,l)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(a){t=a},setContext:function(a){i=a}}}function ly(i){let e=new WeakMap;function t(c,f){let u=c.array,m=c.usage,v=u.byteLength,g=i.createBuffer();i.bindBuffer(f,g),i.bufferData(f,u,m),c.onUploadCallback();let y;if(u instanceof Float32Array)y=i.FLOAT;else if(typeof Float16Array<"u"&&u instanceof Float16Array)y=i.HALF_FLOAT;else if(u instanceof Uint16Array)c.isFloat16BufferAttribute?y=i.HALF_FLOAT:y=i.UNSIGNED_SHORT;else if(u instanceof Int16Array)y=i.SHORT;else if(u instanceof Uint32Array)y=i.UNSIGNED_INT;else if(u instanceof Int32Array)y=i.INT;else if(u instanceof Int8Array)y=i.BYTE;else if(u instanceof Uint8Array)y=i.UNSIGNED_BYTE;else if(u instanceof Uint8ClampedArray)y=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+u);return{buffer:g,type:y,bytesPerElement:u.BYTES_PER_ELEMENT,version:c.version,size:v}}function n(c,f,u){let m=f.array,v=f.updateRanges;if(i.bindBuffer(u,c),v.length===0)i.bufferSubData(u,0,m);else{v.sort((y,M)=>y.start-M.start);let g=0;for(let y=1;y<v.length;y++){let M=v[g],A=v[y];A.start<=M.start+M.count+1?M.count=Math.max(M.count,A.start+A.count-M.start):(++g,v[g]=A)}v.length=g+1;for(let y=0,M=v.length;y<M;y++){let A=v[y];i.bufferSubData(u,A.start*m.BYTES_PER_ELEMENT,m,A.start,A.count)}f.clearUpdateRanges()}f.onUploadCallback()}function r(c){return c.isInterleavedBufferAttribute&&(c=c.data),e.get(c)}function a(c){c.isInterleavedBufferAttribute&&(c=c.data);let f=e.get(c);f&&(i.deleteBuffer(f.buffer),e.delete(c))}function l(c,f){if(c.isInterleavedBufferAttribute&&(c=c.data),c.isGLBufferAttribute){let m=e.get(c);(!m||m.version<c.version)&&e.set(c,{buffer:c.buffer,type:c.type,bytesPerElement:c.elementSize,version:c.version});return}let u=e.get(c);if(u===void 0)e.set(c,t(c,f));else if(u.version<c.version){if(u.size!==c.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(u.buffer,c,f),u.version=c.version}}return{get:r,remove:a,update:l}}var cy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,hy=`#ifdef USE_ALPHAHASH
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
#endif`,uy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,dy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,fy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,py=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,my=`#ifdef USE_AOMAP
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
#endif`,gy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,_y=`#ifdef USE_BATCHING
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
#endif`,vy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,yy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,xy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Sy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,My=`#ifdef USE_IRIDESCENCE
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
#endif`,by=`#ifdef USE_BUMPMAP
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
#endif`,wy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Ey=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ty=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ay=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Cy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ry=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Py=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Iy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Dy=`#define PI 3.141592653589793
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
} // validated`,Ly=`vec3 transformedNormal = objectNormal;
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
#endif`,Fy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ny=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Uy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Oy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,By="gl_FragColor = linearToOutputTexel( gl_FragColor );",ky=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,zy=`#ifdef USE_ENVMAP
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
#endif`,Gy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Vy=`#ifdef USE_ENVMAP
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
#endif`,Hy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Wy=`#ifdef USE_ENVMAP
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
#endif`,Xy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,$y=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,qy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Yy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,jy=`#ifdef USE_GRADIENTMAP
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
}`,Zy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Jy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ky=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Qy=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,ex=`#ifdef USE_ENVMAP
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
#endif`,tx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,nx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ix=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,rx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,sx=`PhysicalMaterial material;
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
#endif`,ax=`uniform sampler2D dfgLUT;
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
}`,ox=`
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
#endif`,lx=`#if defined( RE_IndirectDiffuse )
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
#endif`,cx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,hx=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,ux=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,dx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,fx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,px=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,mx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,gx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,_x=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,vx=`#if defined( USE_POINTS_UV )
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
#endif`,yx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,xx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Sx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Mx=`#if defined( USE_MORPHCOLORS )
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
#endif`,bx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,wx=`#ifdef USE_MORPHTARGETS
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
#endif`,Ex=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Tx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Ax=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Cx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Rx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Px=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Ix=`#ifdef USE_NORMALMAP
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
#endif`,Dx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Lx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Fx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Nx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Ux=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Ox=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Bx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,kx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,zx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Gx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Vx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Hx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Wx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Xx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,$x=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,qx=`float getShadowMask() {
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
}`,Yx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,jx=`#ifdef USE_SKINNING
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
#endif`,Zx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Jx=`#ifdef USE_SKINNING
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
#endif`,Kx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Qx=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,eS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,nS=`#ifdef USE_TRANSMISSION
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
#endif`,iS=`#ifdef USE_TRANSMISSION
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
#endif`,rS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,aS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,oS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,lS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,cS=`uniform sampler2D t2D;
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
}`,hS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,uS=`uniform float backgroundBlurriness;
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
}`,dS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pS=`#include <common>
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
}`,mS=`#if DEPTH_PACKING == 3200
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
}`,gS=`#define DISTANCE
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
}`,_S=`#define DISTANCE
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
}`,vS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,yS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xS=`uniform float scale;
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
}`,SS=`uniform vec3 diffuse;
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
}`,MS=`#include <common>
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
}`,bS=`uniform vec3 diffuse;
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
}`,wS=`#define LAMBERT
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
}`,ES=`#define LAMBERT
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
}`,TS=`#define MATCAP
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
}`,AS=`#define MATCAP
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
}`,CS=`#define NORMAL
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
}`,RS=`#define NORMAL
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
}`,PS=`#define PHONG
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
}`,IS=`#define PHONG
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
}`,DS=`#define STANDARD
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
}`,LS=`#define STANDARD
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
}`,FS=`#define TOON
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
}`,NS=`#define TOON
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
}`,US=`uniform float size;
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
}`,OS=`uniform vec3 diffuse;
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
}`,BS=`#include <common>
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
}`,kS=`uniform vec3 color;
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
}`,zS=`uniform float rotation;
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
}`,GS=`uniform vec3 diffuse;
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
}`,_t={alphahash_fragment:cy,alphahash_pars_fragment:hy,alphamap_fragment:uy,alphamap_pars_fragment:dy,alphatest_fragment:fy,alphatest_pars_fragment:py,aomap_fragment:my,aomap_pars_fragment:gy,batching_pars_vertex:_y,batching_vertex:vy,begin_vertex:yy,beginnormal_vertex:xy,bsdfs:Sy,iridescence_fragment:My,bumpmap_pars_fragment:by,clipping_planes_fragment:wy,clipping_planes_pars_fragment:Ey,clipping_planes_pars_vertex:Ty,clipping_planes_vertex:Ay,color_fragment:Cy,color_pars_fragment:Ry,color_pars_vertex:Py,color_vertex:Iy,common:Dy,defaultnormal_vertex:Ly,displacementmap_pars_vertex:Fy,displacementmap_vertex:Ny,emissivemap_fragment:Uy,emissivemap_pars_fragment:Oy,colorspace_fragment:By,colorspace_pars_fragment:ky,envmap_fragment:zy,envmap_common_pars_fragment:Gy,envmap_pars_fragment:Vy,envmap_pars_vertex:Hy,envmap_physical_pars_fragment:ex,envmap_vertex:Wy,fog_vertex:Xy,fog_pars_vertex:$y,fog_fragment:qy,fog_pars_fragment:Yy,gradientmap_pars_fragment:jy,lightmap_pars_fragment:Zy,lights_lambert_fragment:Jy,lights_lambert_pars_fragment:Ky,lights_pars_begin:Qy,lights_toon_fragment:tx,lights_toon_pars_fragment:nx,lights_phong_fragment:ix,lights_phong_pars_fragment:rx,lights_physical_fragment:sx,lights_physical_pars_fragment:ax,lights_fragment_begin:ox,lights_fragment_maps:lx,lights_fragment_end:cx,lightprobes_pars_fragment:hx,logdepthbuf_fragment:ux,logdepthbuf_pars_fragment:dx,logdepthbuf_pars_vertex:fx,logdepthbuf_vertex:px,map_fragment:mx,map_pars_fragment:gx,map_particle_fragment:_x,map_particle_pars_fragment:vx,metalnessmap_fragment:yx,metalnessmap_pars_fragment:xx,morphinstance_vertex:Sx,morphcolor_vertex:Mx,morphnormal_vertex:bx,morphtarget_pars_vertex:wx,morphtarget_vertex:Ex,normal_fragment_begin:Tx,normal_fragment_maps:Ax,normal_pars_fragment:Cx,normal_pars_vertex:Rx,normal_vertex:Px,normalmap_pars_fragment:Ix,clearcoat_normal_fragment_begin:Dx,clearcoat_normal_fragment_maps:Lx,clearcoat_pars_fragment:Fx,iridescence_pars_fragment:Nx,opaque_fragment:Ux,packing:Ox,premultiplied_alpha_fragment:Bx,project_vertex:kx,dithering_fragment:zx,dithering_pars_fragment:Gx,roughnessmap_fragment:Vx,roughnessmap_pars_fragment:Hx,shadowmap_pars_fragment:Wx,shadowmap_pars_vertex:Xx,shadowmap_vertex:$x,shadowmask_pars_fragment:qx,skinbase_vertex:Yx,skinning_pars_vertex:jx,skinning_vertex:Zx,skinnormal_vertex:Jx,specularmap_fragment:Kx,specularmap_pars_fragment:Qx,tonemapping_fragment:eS,tonemapping_pars_fragment:tS,transmission_fragment:nS,transmission_pars_fragment:iS,uv_pars_fragment:rS,uv_pars_vertex:sS,uv_vertex:aS,worldpos_vertex:oS,background_vert:lS,background_frag:cS,backgroundCube_vert:hS,backgroundCube_frag:uS,cube_vert:dS,cube_frag:fS,depth_vert:pS,depth_frag:mS,distance_vert:gS,distance_frag:_S,equirect_vert:vS,equirect_frag:yS,linedashed_vert:xS,linedashed_frag:SS,meshbasic_vert:MS,meshbasic_frag:bS,meshlambert_vert:wS,meshlambert_frag:ES,meshmatcap_vert:TS,meshmatcap_frag:AS,meshnormal_vert:CS,meshnormal_frag:RS,meshphong_vert:PS,meshphong_frag:IS,meshphysical_vert:DS,meshphysical_frag:LS,meshtoon_vert:FS,meshtoon_frag:NS,points_vert:US,points_frag:OS,shadow_vert:BS,shadow_frag:kS,sprite_vert:zS,sprite_frag:GS},Be={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},_i={basic:{uniforms:vn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.fog]),vertexShader:_t.meshbasic_vert,fragmentShader:_t.meshbasic_frag},lambert:{uniforms:vn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:_t.meshlambert_vert,fragmentShader:_t.meshlambert_frag},phong:{uniforms:vn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_t.meshphong_vert,fragmentShader:_t.meshphong_frag},standard:{uniforms:vn([Be.common,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.roughnessmap,Be.metalnessmap,Be.fog,Be.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag},toon:{uniforms:vn([Be.common,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.gradientmap,Be.fog,Be.lights,{emissive:{value:new ht(0)}}]),vertexShader:_t.meshtoon_vert,fragmentShader:_t.meshtoon_frag},matcap:{uniforms:vn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,{matcap:{value:null}}]),vertexShader:_t.meshmatcap_vert,fragmentShader:_t.meshmatcap_frag},points:{uniforms:vn([Be.points,Be.fog]),vertexShader:_t.points_vert,fragmentShader:_t.points_frag},dashed:{uniforms:vn([Be.common,Be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_t.linedashed_vert,fragmentShader:_t.linedashed_frag},depth:{uniforms:vn([Be.common,Be.displacementmap]),vertexShader:_t.depth_vert,fragmentShader:_t.depth_frag},normal:{uniforms:vn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,{opacity:{value:1}}]),vertexShader:_t.meshnormal_vert,fragmentShader:_t.meshnormal_frag},sprite:{uniforms:vn([Be.sprite,Be.fog]),vertexShader:_t.sprite_vert,fragmentShader:_t.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_t.background_vert,fragmentShader:_t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:_t.backgroundCube_vert,fragmentShader:_t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_t.cube_vert,fragmentShader:_t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_t.equirect_vert,fragmentShader:_t.equirect_frag},distance:{uniforms:vn([Be.common,Be.displacementmap,{referencePosition:{value:new j},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_t.distance_vert,fragmentShader:_t.distance_frag},shadow:{uniforms:vn([Be.lights,Be.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:_t.shadow_vert,fragmentShader:_t.shadow_frag}};_i.physical={uniforms:vn([_i.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ct},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag};var Fl={r:0,b:0,g:0},VS=new Lt,bf=new ct;bf.set(-1,0,0,0,1,0,0,0,1);function HS(i,e,t,n,r,a){let l=new ht(0),c=r===!0?0:1,f,u,m=null,v=0,g=null;function y(P){let U=P.isScene===!0?P.background:null;if(U&&U.isTexture){let I=P.backgroundBlurriness>0;U=e.get(U,I)}return U}function M(P){let U=!1,I=y(P);I===null?S(l,c):I&&I.isColor&&(S(I,1),U=!0);let O=i.xr.getEnvironmentBlendMode();O==="additive"?t.buffers.color.setClear(0,0,0,1,a):O==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,a),(i.autoClear||U)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function A(P,U){let I=y(U);I&&I.isCubeTexture?(u===void 0&&(u=new Ot(new di(1,1,1),new fi({name:"BackgroundCubeMaterial",uniforms:yr(_i.backgroundCube.uniforms),vertexShader:_i.backgroundCube.vertexShader,fragmentShader:_i.backgroundCube.fragmentShader,side:dn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(O,N,w){this.matrixWorld.copyPosition(w.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(u)),u.material.uniforms.envMap.value=I,u.material.uniforms.backgroundBlurriness.value=U.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(VS.makeRotationFromEuler(U.backgroundRotation)).transpose(),I.isRenderTargetTexture===!1&&u.material.uniforms.backgroundRotation.value.premultiply(bf),u.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,(m!==I||v!==I.version||g!==i.toneMapping)&&(u.material.needsUpdate=!0,m=I,v=I.version,g=i.toneMapping),u.layers.enableAll(),P.unshift(u,u.geometry,u.material,0,0,null)):I&&I.isTexture&&(f===void 0&&(f=new Ot(new Xi(2,2),new fi({name:"BackgroundMaterial",uniforms:yr(_i.background.uniforms),vertexShader:_i.background.vertexShader,fragmentShader:_i.background.fragmentShader,side:Ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),f.geometry.deleteAttribute("normal"),Object.defineProperty(f.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(f)),f.material.uniforms.t2D.value=I,f.material.uniforms.backgroundIntensity.value=U.backgroundIntensity,f.material.toneMapped=St.getTransfer(I.colorSpace)!==Pt,I.matrixAutoUpdate===!0&&I.updateMatrix(),f.material.uniforms.uvTransform.value.copy(I.matrix),(m!==I||v!==I.version||g!==i.toneMapping)&&(f.material.needsUpdate=!0,m=I,v=I.version,g=i.toneMapping),f.layers.enableAll(),P.unshift(f,f.geometry,f.material,0,0,null))}function S(P,U){P.getRGB(Fl,vh(i)),t.buffers.color.setClear(Fl.r,Fl.g,Fl.b,U,a)}function _(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),f!==void 0&&(f.geometry.dispose(),f.material.dispose(),f=void 0)}return{getClearColor:function(){return l},setClearColor:function(P,U=1){l.set(P),c=U,S(l,c)},getClearAlpha:function(){return c},setClearAlpha:function(P){c=P,S(l,c)},render:M,addToRenderList:A,dispose:_}}function WS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=g(null),a=r,l=!1;function c(Y,Z,ee,z,ie){let G=!1,ne=v(Y,z,ee,Z);a!==ne&&(a=ne,u(a.object)),G=y(Y,z,ee,ie),G&&M(Y,z,ee,ie),ie!==null&&e.update(ie,i.ELEMENT_ARRAY_BUFFER),(G||l)&&(l=!1,I(Y,Z,ee,z),ie!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(ie).buffer))}function f(){return i.createVertexArray()}function u(Y){return i.bindVertexArray(Y)}function m(Y){return i.deleteVertexArray(Y)}function v(Y,Z,ee,z){let ie=z.wireframe===!0,G=n[Z.id];G===void 0&&(G={},n[Z.id]=G);let ne=Y.isInstancedMesh===!0?Y.id:0,Se=G[ne];Se===void 0&&(Se={},G[ne]=Se);let re=Se[ee.id];re===void 0&&(re={},Se[ee.id]=re);let H=re[ie];return H===void 0&&(H=g(f()),re[ie]=H),H}function g(Y){let Z=[],ee=[],z=[];for(let ie=0;ie<t;ie++)Z[ie]=0,ee[ie]=0,z[ie]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:Z,enabledAttributes:ee,attributeDivisors:z,object:Y,attributes:{},index:null}}function y(Y,Z,ee,z){let ie=a.attributes,G=Z.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=ie[re],We=G[re];if(We===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(We=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(We=Y.instanceColor)),ge===void 0||ge.attribute!==We||We&&ge.data!==We.data)return!0;ne++}return a.attributesNum!==ne||a.index!==z}function M(Y,Z,ee,z){let ie={},G=Z.attributes,ne=0,Se=ee.getAttributes();for(let re in Se)if(Se[re].location>=0){let ge=G[re];ge===void 0&&(re==="instanceMatrix"&&Y.instanceMatrix&&(ge=Y.instanceMatrix),re==="instanceColor"&&Y.instanceColor&&(ge=Y.instanceColor));let We={};We.attribute=ge,ge&&ge.data&&(We.data=ge.data),ie[re]=We,ne++}a.attributes=ie,a.attributesNum=ne,a.index=z}function A(){let Y=a.newAttributes;for(let Z=0,ee=Y.length;Z<ee;Z++)Y[Z]=0}function S(Y){_(Y,0)}function _(Y,Z){let ee=a.newAttributes,z=a.enabledAttributes,ie=a.attributeDivisors;ee[Y]=1,z[Y]===0&&(i.enableVertexAttribArray(Y),z[Y]=1),ie[Y]!==Z&&(i.vertexAttribDivisor(Y,Z),ie[Y]=Z)}function P(){let Y=a.newAttributes,Z=a.enabledAttributes;for(let ee=0,z=Z.length;ee<z;ee++)Z[ee]!==Y[ee]&&(i.disableVertexAttribArray(ee),Z[ee]=0)}function U(Y,Z,ee,z,ie,G,ne){ne===!0?i.vertexAttribIPointer(Y,Z,ee,ie,G):i.vertexAttribPointer(Y,Z,ee,z,ie,G)}function I(Y,Z,ee,z){A();let ie=z.attributes,G=ee.getAttributes(),ne=Z.defaultAttributeValues;for(let Se in G){let re=G[Se];if(re.location>=0){let H=ie[Se];if(H===void 0&&(Se==="instanceMatrix"&&Y.instanceMatrix&&(H=Y.instanceMatrix),Se==="instanceColor"&&Y.instanceColor&&(H=Y.instanceColor)),H!==void 0){let ge=H.normalized,We=H.itemSize,rt=e.get(H);if(rt===void 0)continue;let ue=rt.buffer,Fe=rt.type,Pe=rt.bytesPerElement,Ze=Fe===i.INT||Fe===i.UNSIGNED_INT||H.gpuType===Jo;if(H.isInterleavedBufferAttribute){let Ue=H.data,ot=Ue.isInterleavedBuffer===!0?Ue.stride:Ue.itemSize,Vt=H.offset;if(Ue.isInstancedInterleavedBuffer||Ue.isInstancedBufferAttribute){for(let Qe=0;Qe<re.locationSize;Qe++)_(re.location+Qe,Ue.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=Ue.meshPerAttribute*Ue.count)}else for(let Qe=0;Qe<re.locationSize;Qe++)S(re.location+Qe);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Qe=0;Qe<re.locationSize;Qe++)U(re.location+Qe,We/re.locationSize,Fe,ge,ot*Pe,(Vt+We/re.locationSize*Qe)*Pe,Ze)}else{if(H.isInstancedBufferAttribute){for(let Ue=0;Ue<re.locationSize;Ue++)_(re.location+Ue,H.meshPerAttribute);Y.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=H.meshPerAttribute*H.count)}else for(let Ue=0;Ue<re.locationSize;Ue++)S(re.location+Ue);i.bindBuffer(i.ARRAY_BUFFER,ue);for(let Ue=0;Ue<re.locationSize;Ue++)U(re.location+Ue,We/re.locationSize,Fe,ge,We*Pe,We/re.locationSize*Ue*Pe,Ze)}}else if(ne!==void 0){let ge=ne[Se];if(ge!==void 0)switch(ge.length){case 2:i.vertexAttrib2fv(re.location,ge);break;case 3:i.vertexAttrib3fv(re.location,ge);break;case 4:i.vertexAttrib4fv(re.location,ge);break;default:i.vertexAttrib1fv(re.location,ge)}}}}P()}function O(){X();for(let Y in n){let Z=n[Y];for(let ee in Z){let z=Z[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y]}}function N(Y){if(n[Y.id]===void 0)return;let Z=n[Y.id];for(let ee in Z){let z=Z[ee];for(let ie in z){let G=z[ie];for(let ne in G)m(G[ne].object),delete G[ne];delete z[ie]}}delete n[Y.id]}function w(Y){for(let Z in n){let ee=n[Z];for(let z in ee){let ie=ee[z];if(ie[Y.id]===void 0)continue;let G=ie[Y.id];for(let ne in G)m(G[ne].object),delete G[ne];delete ie[Y.id]}}}function D(Y){for(let Z in n){let ee=n[Z],z=Y.isInstancedMesh===!0?Y.id:0,ie=ee[z];if(ie!==void 0){for(let G in ie){let ne=ie[G];for(let Se in ne)m(ne[Se].object),delete ne[Se];delete ie[G]}delete ee[z],Object.keys(ee).length===0&&delete n[Z]}}}function X(){k(),l=!0,a!==r&&(a=r,u(a.object))}function k(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:c,reset:X,resetDefaultState:k,dispose:O,releaseStatesOfGeometry:N,releaseStatesOfObject:D,releaseStatesOfProgram:w,initAttributes:A,enableAttribute:S,disableUnusedAttributes:P}}function XS(i,e,t){let n;function r(f){n=f}function a(f,u){i.drawArrays(n,f,u),t.update(u,n,1)}function l(f,u,m){m!==0&&(i.drawArraysInstanced(n,f,u,m),t.update(u,n,m))}function c(f,u,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,f,0,u,0,m);let g=0;for(let y=0;y<m;y++)g+=u[y];t.update(g,n,1)}this.setMode=r,this.render=a,this.renderInstances=l,this.renderMultiDraw=c}function $S(i,e,t,n){let r;function a(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let w=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(w.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function l(w){return!(w!==Qn&&n.convert(w)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function c(w){let D=w===Kn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(w!==An&&w!==Vn&&!D&&n.convert(w)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function f(w){if(w==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";w="mediump"}return w==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let u=t.precision!==void 0?t.precision:"highp",m=f(u);m!==u&&(et("WebGLRenderer:",u,"not supported, using",m,"instead."),u=m);let v=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),g=t.logarithmicDepthBuffer===!0&&v===!1;t.reversedDepthBuffer===!0&&v===!1&&et("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&v===!0&&et("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let y=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),A=i.getParameter(i.MAX_TEXTURE_SIZE),S=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),_=i.getParameter(i.MAX_VERTEX_ATTRIBS),P=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),U=i.getParameter(i.MAX_VARYING_VECTORS),I=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),O=i.getParameter(i.MAX_SAMPLES),N=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:a,getMaxPrecision:f,textureFormatReadable:l,textureTypeReadable:c,precision:u,logarithmicDepthBuffer:g,reversedDepthBuffer:v,maxTextures:y,maxVertexTextures:M,maxTextureSize:A,maxCubemapSize:S,maxAttributes:_,maxVertexUniforms:P,maxVaryings:U,maxFragmentUniforms:I,maxSamples:O,samples:N}}function qS(i){let e=this,t=null,n=0,r=!1,a=!1,l=new Ln,c=new ct,f={value:null,needsUpdate:!1};this.uniform=f,this.numPlanes=0,this.numIntersection=0,this.init=function(v,g){let y=v.length!==0||g||n!==0||r;return r=g,n=v.length,y},this.beginShadows=function(){a=!0,m(null)},this.endShadows=function(){a=!1},this.setGlobalState=function(v,g){t=m(v,g,0)},this.setState=function(v,g,y){let M=v.clippingPlanes,A=v.clipIntersection,S=v.clipShadows,_=i.get(v);if(!r||M===null||M.length===0||a&&!S)a?m(null):u();else{let P=a?0:n,U=P*4,I=_.clippingState||null;f.value=I,I=m(M,g,U,y);for(let O=0;O!==U;++O)I[O]=t[O];_.clippingState=I,this.numIntersection=A?this.numPlanes:0,this.numPlanes+=P}};function u(){f.value!==t&&(f.value=t,f.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function m(v,g,y,M){let A=v!==null?v.length:0,S=null;if(A!==0){if(S=f.value,M!==!0||S===null){let _=y+A*4,P=g.matrixWorldInverse;c.getNormalMatrix(P),(S===null||S.length<_)&&(S=new Float32Array(_));for(let U=0,I=y;U!==A;++U,I+=4)l.copy(v[U]).applyMatrix4(P,c),l.normal.toArray(S,I),S[I+3]=l.constant}f.value=S,f.needsUpdate=!0}return e.numPlanes=A,e.numIntersection=0,S}}var ua=class extends Fn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new Bs(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new di(5,5,5),a=new fi({name:"CubemapFromEquirect",uniforms:yr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:dn,blending:mr});a.uniforms.tEquirect.value=t;let l=new Ot(r,a),c=t.minFilter;return t.minFilter===Pi&&(t.minFilter=Mn),new Yr(1,10,this).update(e,l),t.minFilter=c,l.geometry.dispose(),l.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let a=e.getRenderTarget();for(let l=0;l<6;l++)e.setRenderTarget(this,l),e.clear(t,n,r);e.setRenderTarget(a)}},ef=256,YS=3,jS=20,wf=256,Ef=16,ZS=3,JS=new j,KS=new ht,ns=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Yr(1,10,null),this._boxMesh=new Ot(new di(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,a={}){let{size:l=256,position:c=JS}=a,f=this._renderer;this._setSize(l);let u=this._allocateTarget(),m=this._getSourceTarget(!0);t>0&&(m.texture.mipmapsAutoUpdate=!1);let v=f.autoClear,g=f.autoClearColor,y=f.autoClearDepth,M=f.autoClearStencil,A=e.background;f.autoClear=!0,f.autoClearColor=!0,f.autoClearDepth=!0,f.autoClearStencil=!0,A===null&&(e.background=f.getClearColor(KS));let S=new Yr(n,r,m);return S.position.copy(c),S.update(f,e),f.autoClear=v,f.autoClearColor=g,f.autoClearDepth=y,f.autoClearStencil=M,e.background=A,t>0&&(m.texture.mipmapsAutoUpdate=!0,this._blur(u,t)),this._applyPMREM(u),u}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=rf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=nf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(ef,mh(e))}_fromTexture(e,t){e.mapping===_r||e.mapping===Kr?this._setSize(e.image.length===0?ef:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=tf(e,!1,!1),n=Math.log2(e)-YS;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=tf(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,a=this._cubeCamera;r.material=n,a.renderTarget=e,a.activeMipmapLevel=t;let l=e.width>>t;e.viewport.set(0,0,l,l),a.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===_r||e.mapping===Kr?(this._cubemapMaterial===null&&(this._cubemapMaterial=rf()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=nf()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=QS(),this._integrationMaterial=eM());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let a=this._integrationMaterial.uniforms;a.envMap.value=this._sourceTarget.texture,a.sourceLod.value=Math.log2(t/Ef);for(let l=0;l<=n;l++){let c=i.lodToRoughness(l,n);if(l>n-ZS)a.roughness.value=c,this._renderCube(e,l,this._integrationMaterial);else{let f=c>0?Math.log2(t)+.5*Math.log2(6/(wf*Math.pow(c,4)))+.5:0;r.roughness.value=c,r.lodBias.value=f,this._renderCube(e,l,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=tM());let n=this._blurMaterial,r=n.uniforms,a=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=a.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(a,0,n)}};function tf(i,e,t){return new ua(i,{minFilter:Pi,generateMipmaps:e,type:Kn,colorSpace:Ts,depthBuffer:t})}function da(i,e,t){return new fi({name:i,uniforms:e,vertexShader:_t.cube_vert,fragmentShader:t,side:dn,blending:mr,depthTest:!1,depthWrite:!1})}function QS(){return da("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${wf}u

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
	`)}function eM(){return da("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ef}},`

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
	`)}function tM(){return da("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${jS}
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
	`)}function nf(){return da("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function rf(){return da("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function nM(i){let e=new WeakMap,t=new WeakMap,n=null;function r(g,y=!1){return g==null?null:y?l(g):a(g)}function a(g){if(g&&g.isTexture){let y=g.mapping;if(y===Yo||y===jo)if(e.has(g)){let M=e.get(g).texture;return c(M,g.mapping)}else{let M=g.image;if(M&&M.height>0){let A=new ua(M.height);return A.fromEquirectangularTexture(i,g),e.set(g,A),g.addEventListener("dispose",u),c(A.texture,g.mapping)}else return null}}return g}function l(g){if(g&&g.isTexture&&g.isPMREMTexture!==!0){let y=g.mapping,M=y===Yo||y===jo,A=y===_r||y===Kr;if(M||A){let S=t.get(g),_=S!==void 0?S.texture.pmremVersion:0;if(g.isRenderTargetTexture&&g.pmremVersion!==_)return n===null&&(n=new ns(i)),S=M?n.fromEquirectangular(g,S):n.fromCubemap(g,S),S.texture.pmremVersion=g.pmremVersion,t.set(g,S),S.texture;if(S!==void 0)return S.texture;{let P=g.image;return M&&P&&P.height>0||A&&P&&f(P)?(n===null&&(n=new ns(i)),S=M?n.fromEquirectangular(g):n.fromCubemap(g),S.texture.pmremVersion=g.pmremVersion,t.set(g,S),g.addEventListener("dispose",m),S.texture):null}}}return g}function c(g,y){return y===Yo?g.mapping=_r:y===jo&&(g.mapping=Kr),g}function f(g){let y=0,M=6;for(let A=0;A<M;A++)g[A]!==void 0&&y++;return y===M}function u(g){let y=g.target;y.removeEventListener("dispose",u);let M=e.get(y);M!==void 0&&(e.delete(y),M.dispose())}function m(g){let y=g.target;y.removeEventListener("dispose",m);let M=t.get(y);M!==void 0&&(t.delete(y),M.dispose())}function v(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:v}}function iM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let r=t(n);return r===null&&Ms("WebGLRenderer: "+n+" extension not supported."),r}}}function rM(i,e,t,n){let r={},a=new WeakMap,l=new FinalizationRegistry(M=>delete r[M]);function c(M){f(M.target)}function f(M){M.index!==null&&e.remove(M.index);for(let S in M.attributes)e.remove(M.attributes[S]);M.removeEventListener("dispose",c),delete r[M.id],l.unregister(M);let A=a.get(M);A&&(e.remove(A),a.delete(M)),n.releaseStatesOfGeometry(M),M.isInstancedBufferGeometry===!0&&delete M._maxInstanceCount,t.memory.geometries--}function u(M,A){return r[A.id]!==void 0||(A.addEventListener("dispose",c),r[A.id]=new WeakRef(A),l.register(A,A.id,A),t.memory.geometries++),A}function m(M){let A=M.attributes;for(let S in A)e.update(A[S],i.ARRAY_BUFFER)}function v(M){let A=M.index,S=M.attributes.position,_=0;if(S===void 0)return;let P=A!==null?A.array.length:S.array.length/3-1,U=S.count>=65535?Ds:Is,I=new U(Math.ceil(P/3)*6,1),O=I.array;if(A!==null){let w=A.array;_=A.version;for(let D=0,X=0;D<P;D+=3){let k=w[D+0],Y=w[D+1],Z=w[D+2];O[X++]=k,O[X++]=Y,O[X++]=Y,O[X++]=Z,O[X++]=Z,O[X++]=k}}else{_=S.version;for(let w=0,D=0;w<P;w+=3){let X=w+0,k=w+1,Y=w+2;O[D++]=X,O[D++]=k,O[D++]=k,O[D++]=Y,O[D++]=Y,O[D++]=X}}I.version=_;let N=a.get(M);N&&e.remove(N),a.set(M,I)}function g(M){let A=a.get(M);if(A){let S=M.index;S!==null&&A.version<S.version&&v(M)}else v(M);return a.get(M)}function y(){for(let M in r){let A=r[M].deref();A!==void 0&&f(A)}}return{get:u,update:m,getWireframeAttribute:g,dispose:y}}function sM(i,e,t){let n;function r(v){n=v}let a,l;function c(v){a=v.type,l=v.bytesPerElement}function f(v,g){i.drawElements(n,g,a,v*l),t.update(g,n,1)}function u(v,g,y){y!==0&&(i.drawElementsInstanced(n,g,a,v*l,y),t.update(g,n,y))}function m(v,g,y){if(y===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,g,0,a,v,0,y);let A=0;for(let S=0;S<y;S++)A+=g[S];t.update(A,n,1)}this.setMode=r,this.setIndex=c,this.render=f,this.renderInstances=u,this.renderMultiDraw=m}function aM(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(a,l,c){switch(t.calls++,l){case i.TRIANGLES:t.triangles+=c*(a/3);break;case i.LINES:t.lines+=c*(a/2);break;case i.LINE_STRIP:t.lines+=c*(a-1);break;case i.LINE_LOOP:t.lines+=c*a;break;case i.POINTS:t.points+=c*a;break;default:it("WebGLInfo: Unknown draw mode:",l);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}function oM(i,e,t){let n=new WeakMap,r=new Gt;function a(l,c,f){let u=l.morphTargetInfluences,m=c.morphAttributes.position||c.morphAttributes.normal||c.morphAttributes.color,v=m!==void 0?m.length:0,g=n.get(c);if(g===void 0||g.count!==v){let X=function(){w.dispose(),n.delete(c),c.removeEventListener("dispose",X)};g!==void 0&&g.texture.dispose();let y=c.morphAttributes.position!==void 0,M=c.morphAttributes.normal!==void 0,A=c.morphAttributes.color!==void 0,S=c.morphAttributes.position||[],_=c.morphAttributes.normal||[],P=c.morphAttributes.color||[],U=0;y===!0&&(U=1),M===!0&&(U=2),A===!0&&(U=3);let I=c.attributes.position.count*U,O=1;I>e.maxTextureSize&&(O=Math.ceil(I/e.maxTextureSize),I=e.maxTextureSize);let N=new Float32Array(I*O*4*v),w=new Rs(N,I,O,v);w.type=Vn,w.needsUpdate=!0;let D=U*4;for(let k=0;k<v;k++){let Y=S[k],Z=_[k],ee=P[k],z=I*O*4*k;for(let ie=0;ie<Y.count;ie++){let G=ie*D;y===!0&&(r.fromBufferAttribute(Y,ie),N[z+G+0]=r.x,N[z+G+1]=r.y,N[z+G+2]=r.z,N[z+G+3]=0),M===!0&&(r.fromBufferAttribute(Z,ie),N[z+G+4]=r.x,N[z+G+5]=r.y,N[z+G+6]=r.z,N[z+G+7]=0),A===!0&&(r.fromBufferAttribute(ee,ie),N[z+G+8]=r.x,N[z+G+9]=r.y,N[z+G+10]=r.z,N[z+G+11]=ee.itemSize===4?r.w:1)}}g={count:v,texture:w,size:new tt(I,O)},n.set(c,g),c.addEventListener("dispose",X)}if(l.isInstancedMesh===!0&&l.morphTexture!==null)f.getUniforms().setValue(i,"morphTexture",l.morphTexture,t);else{let y=0;for(let A=0;A<u.length;A++)y+=u[A];let M=c.morphTargetsRelative?1:1-y;f.getUniforms().setValue(i,"morphTargetBaseInfluence",M),f.getUniforms().setValue(i,"morphTargetInfluences",u)}f.getUniforms().setValue(i,"morphTargetsTexture",g.texture,t),f.getUniforms().setValue(i,"morphTargetsTextureSize",g.size)}return{update:a}}function lM(i,e,t,n,r){let a=new WeakMap;function l(u){let m=r.render.frame,v=u.geometry,g=e.get(u,v);if(a.get(g)!==m&&(e.update(g),a.set(g,m)),u.isInstancedMesh&&(u.hasEventListener("dispose",f)===!1&&u.addEventListener("dispose",f),a.get(u)!==m&&(t.update(u.instanceMatrix,i.ARRAY_BUFFER),u.instanceColor!==null&&t.update(u.instanceColor,i.ARRAY_BUFFER),a.set(u,m))),u.isSkinnedMesh){let y=u.skeleton;a.get(y)!==m&&(y.update(),a.set(y,m))}return g}function c(){a=new WeakMap}function f(u){let m=u.target;m.removeEventListener("dispose",f),n.releaseStatesOfObject(m),t.remove(m.instanceMatrix),m.instanceColor!==null&&t.remove(m.instanceColor)}return{update:l,dispose:c}}var cM={[Zc]:"LINEAR_TONE_MAPPING",[Jc]:"REINHARD_TONE_MAPPING",[Kc]:"CINEON_TONE_MAPPING",[Qc]:"ACES_FILMIC_TONE_MAPPING",[th]:"AGX_TONE_MAPPING",[ea]:"NEUTRAL_TONE_MAPPING",[eh]:"CUSTOM_TONE_MAPPING"};function hM(i,e,t,n,r,a){let l=new Fn(e,t,{type:i,depthBuffer:r,stencilBuffer:a,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),c=null,f=null,u=null,m=new En;m.setAttribute("position",new Xt([-1,3,0,-1,-1,0,3,-1,0],3)),m.setAttribute("uv",new Xt([0,2,0,0,2,0],2));let v=new Lo({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),g=new Ot(m,v),y=new js(-1,1,1,-1,0,1),M=null,A=null,S=!1,_,P=null,U=[],I=!1;this.setSize=function(O,N){l.setSize(O,N),c!==null&&c.setSize(O,N),f!==null&&f.setSize(O,N);for(let w=0;w<U.length;w++){let D=U[w];D.setSize&&D.setSize(O,N)}},this.setEffects=function(O){U=O,I=U.length>0&&U[0].isRenderPass===!0;let N=l.width,w=l.height;U.length>0&&c===null&&(c=new Fn(N,w,{type:Kn,depthBuffer:!1,stencilBuffer:!1}),f=new Fn(N,w,{type:Kn,depthBuffer:!1,stencilBuffer:!1}));let D=r===!0&&U.some(X=>X.needsDepthTexture===!0);D!==(l.depthTexture!==null)&&(D===!0&&u===null&&(u=new Ci(N,w),a===!0&&(u.format=Ii,u.type=vr)),l.dispose(),l.depthTexture=D?u:null,l.resolveDepthBuffer=D,l.storeMultisampledDepthBuffer=D);for(let X=0;X<U.length;X++){let k=U[X];k.setSize&&k.setSize(N,w),D&&k.needsDepthTexture===!0&&k.setDepthTexture&&k.setDepthTexture(u)}},this.begin=function(O,N){if(S||O.toneMapping===mi&&U.length===0)return!1;if(P=N,N!==null){let w=N.width,D=N.height;(l.width!==w||l.height!==D)&&this.setSize(w,D)}return I===!1&&O.setRenderTarget(l),_=O.toneMapping,O.toneMapping=mi,!0},this.hasRenderPass=function(){return I},this.end=function(O,N){O.toneMapping=_,S=!0;let w=l,D=c;for(let X=0;X<U.length;X++){let k=U[X];k.enabled!==!1&&(k.render(O,D,w,N),k.needsSwap!==!1&&(w=D,D=D===c?f:c))}if(M!==O.outputColorSpace||A!==O.toneMapping){M=O.outputColorSpace,A=O.toneMapping,v.defines={},St.getTransfer(M)===Pt&&(v.defines.SRGB_TRANSFER="");let X=cM[A];X&&(v.defines[X]=""),v.needsUpdate=!0}v.uniforms.tDiffuse.value=w.texture,O.setRenderTarget(P),O.render(g,y),P=null,S=!1},this.isCompositing=function(){return S},this.dispose=function(){l.dispose(),c!==null&&c.dispose(),f!==null&&f.dispose(),m.dispose(),v.dispose()}}var Tf=new wn,Af=new Ci(1,1),Cf=new zs(1),Rf=new Rs,Pf=new Ao,If=new Bs,sf=[],af=[],of=new Float32Array(16),lf=new Float32Array(9),cf=new Float32Array(4);function is(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,a=sf[r];if(a===void 0&&(a=new Float32Array(r),sf[r]=a),e!==0){n.toArray(a,0);for(let l=1,c=0;l!==e;++l)c+=t,i[l].toArray(a,c)}return a}function en(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ol(i,e){let t=af[e];t===void 0&&(t=new Int32Array(e),af[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function uM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function dM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2fv(this.addr,e),tn(t,e)}}function fM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(en(t,e))return;i.uniform3fv(this.addr,e),tn(t,e)}}function pM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4fv(this.addr,e),tn(t,e)}}function mM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;cf.set(n),i.uniformMatrix2fv(this.addr,!1,cf),tn(t,n)}}function gM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;lf.set(n),i.uniformMatrix3fv(this.addr,!1,lf),tn(t,n)}}function _M(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;of.set(n),i.uniformMatrix4fv(this.addr,!1,of),tn(t,n)}}function vM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function yM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2iv(this.addr,e),tn(t,e)}}function xM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3iv(this.addr,e),tn(t,e)}}function SM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4iv(this.addr,e),tn(t,e)}}function MM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function bM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2uiv(this.addr,e),tn(t,e)}}function wM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3uiv(this.addr,e),tn(t,e)}}function EM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4uiv(this.addr,e),tn(t,e)}}function Bl(i){return i.version===0&&(i.compareFunction=uh,i.needsUpdate=!0),i}function TM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let a;this.type===i.SAMPLER_2D_SHADOW?a=Bl(Af):a=Tf,t.setTexture2D(e||a,r)}function AM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||Pf,r)}function CM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Bl(Cf):a=If,t.setTextureCube(e||a,r)}function RM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||Rf,r)}function PM(i){switch(i){case 5126:return uM;case 35664:return dM;case 35665:return fM;case 35666:return pM;case 35674:return mM;case 35675:return gM;case 35676:return _M;case 5124:case 35670:return vM;case 35667:case 35671:return yM;case 35668:case 35672:return xM;case 35669:case 35673:return SM;case 5125:return MM;case 36294:return bM;case 36295:return wM;case 36296:return EM;case 35678:case 36198:case 36298:case 36306:case 35682:return TM;case 35679:case 36299:case 36307:return AM;case 35680:case 36300:case 36308:case 36293:return CM;case 36289:case 36303:case 36311:case 36292:return RM}}function IM(i,e){i.uniform1fv(this.addr,e)}function DM(i,e){let t=is(e,this.size,2);i.uniform2fv(this.addr,t)}function LM(i,e){let t=is(e,this.size,3);i.uniform3fv(this.addr,t)}function FM(i,e){let t=is(e,this.size,4);i.uniform4fv(this.addr,t)}function NM(i,e){let t=is(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function UM(i,e){let t=is(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function OM(i,e){let t=is(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function BM(i,e){i.uniform1iv(this.addr,e)}function kM(i,e){i.uniform2iv(this.addr,e)}function zM(i,e){i.uniform3iv(this.addr,e)}function GM(i,e){i.uniform4iv(this.addr,e)}function VM(i,e){i.uniform1uiv(this.addr,e)}function HM(i,e){i.uniform2uiv(this.addr,e)}function WM(i,e){i.uniform3uiv(this.addr,e)}function XM(i,e){i.uniform4uiv(this.addr,e)}function $M(i,e,t){let n=this.cache,r=e.length,a=Ol(t,r);en(n,a)||(i.uniform1iv(this.addr,a),tn(n,a));let l;this.type===i.SAMPLER_2D_SHADOW?l=Bl(Af):l=Tf;for(let c=0;c!==r;++c)t.setTexture2D(e[c]||l,a[c])}function qM(i,e,t){let n=this.cache,r=e.length,a=Ol(t,r);en(n,a)||(i.uniform1iv(this.addr,a),tn(n,a));for(let l=0;l!==r;++l)t.setTexture3D(e[l]||Pf,a[l])}function YM(i,e,t){let n=this.cache,r=e.length,a=Ol(t,r);en(n,a)||(i.uniform1iv(this.addr,a),tn(n,a));let l;this.type===i.SAMPLER_CUBE_SHADOW?l=Bl(Cf):l=If;for(let c=0;c!==r;++c)t.setTextureCube(e[c]||l,a[c])}function jM(i,e,t){let n=this.cache,r=e.length,a=Ol(t,r);en(n,a)||(i.uniform1iv(this.addr,a),tn(n,a));for(let l=0;l!==r;++l)t.setTexture2DArray(e[l]||Rf,a[l])}function ZM(i){switch(i){case 5126:return IM;case 35664:return DM;case 35665:return LM;case 35666:return FM;case 35674:return NM;case 35675:return UM;case 35676:return OM;case 5124:case 35670:return BM;case 35667:case 35671:return kM;case 35668:case 35672:return zM;case 35669:case 35673:return GM;case 5125:return VM;case 36294:return HM;case 36295:return WM;case 36296:return XM;case 35678:case 36198:case 36298:case 36306:case 35682:return $M;case 35679:case 36299:case 36307:return qM;case 35680:case 36300:case 36308:case 36293:return YM;case 36289:case 36303:case 36311:case 36292:return jM}}var wh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=PM(t.type)}},Eh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=ZM(t.type)}},Th=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let a=0,l=r.length;a!==l;++a){let c=r[a];c.setValue(e,t[c.id],n)}}},Mh=/(\w+)(\])?(\[|\.)?/g;function hf(i,e){i.seq.push(e),i.map[e.id]=e}function JM(i,e,t){let n=i.name,r=n.length;for(Mh.lastIndex=0;;){let a=Mh.exec(n),l=Mh.lastIndex,c=a[1],f=a[2]==="]",u=a[3];if(f&&(c=c|0),u===void 0||u==="["&&l+2===r){hf(t,u===void 0?new wh(c,i,e):new Eh(c,i,e));break}else{let v=t.map[c];v===void 0&&(v=new Th(c),hf(t,v)),t=v}}}var ts=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let l=0;l<n;++l){let c=e.getActiveUniform(t,l),f=e.getUniformLocation(t,c.name);JM(c,f,this)}let r=[],a=[];for(let l of this.seq)l.type===e.SAMPLER_2D_SHADOW||l.type===e.SAMPLER_CUBE_SHADOW||l.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(l):a.push(l);r.length>0&&(this.seq=r.concat(a))}setValue(e,t,n,r){let a=this.map[t];a!==void 0&&a.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let a=0,l=t.length;a!==l;++a){let c=t[a],f=n[c.id];f.needsUpdate!==!1&&c.setValue(e,f.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,a=e.length;r!==a;++r){let l=e[r];l.id in t&&n.push(l)}return n}};function uf(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var KM=37297,QM=0;function eb(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),a=Math.min(e+6,t.length);for(let l=r;l<a;l++){let c=l+1;n.push(`${c===e?">":" "} ${c}: ${t[l]}`)}return n.join(`
`)}var df=new ct;function tb(i){St._getMatrix(df,St.workingColorSpace,i);let e=`mat3( ${df.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case As:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return et("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function ff(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),a=(i.getShaderInfoLog(e)||"").trim();if(n&&a==="")return"";let l=/ERROR: 0:(\d+)/.exec(a);if(l){let c=parseInt(l[1]);return t.toUpperCase()+`

`+a+`

`+eb(i.getShaderSource(e),c)}else return a}function nb(i,e){let t=tb(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ib={[Zc]:"Linear",[Jc]:"Reinhard",[Kc]:"Cineon",[Qc]:"ACESFilmic",[th]:"AgX",[ea]:"Neutral",[eh]:"Custom"};function rb(i,e){let t=ib[e];return t===void 0?(et("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Nl=new j;function sb(){St.getLuminanceCoefficients(Nl);let i=Nl.x.toFixed(4),e=Nl.y.toFixed(4),t=Nl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function ab(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ha).join(`
`)}function ob(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function lb(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let a=i.getActiveAttrib(e,r),l=a.name,c=1;a.type===i.FLOAT_MAT2&&(c=2),a.type===i.FLOAT_MAT3&&(c=3),a.type===i.FLOAT_MAT4&&(c=4),t[l]={type:a.type,location:i.getAttribLocation(e,l),locationSize:c}}return t}function ha(i){return i!==""}function pf(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function mf(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var cb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ah(i){return i.replace(cb,hb)}function hb(i,e){let t=_t[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Ah(t)}var ub=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function gf(i){return i.replace(ub,db)}function db(i,e,t,n){let r="";for(let a=parseInt(e);a<parseInt(t);a++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+a+" ]").replace(/UNROLLED_LOOP_INDEX/g,a);return r}function _f(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var fb={[pr]:"SHADOWMAP_TYPE_PCF",[Zr]:"SHADOWMAP_TYPE_VSM"};function pb(i){return fb[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var mb={[Kr]:"ENVMAP_MODE_REFRACTION"};function gb(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":mb[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var _b={[qo]:"ENVMAP_BLENDING_MULTIPLY",[Dd]:"ENVMAP_BLENDING_MIX",[Ld]:"ENVMAP_BLENDING_ADD"};function vb(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":_b[i.combine]||"ENVMAP_BLENDING_NONE"}function yb(i,e,t,n){let r=i.getContext(),a=t.defines,l=t.vertexShader,c=t.fragmentShader,f=pb(t),u=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",m=gb(t),v=vb(t),g=ab(t),y=ob(a),M=r.createProgram(),A,S,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(A=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,y].filter(ha).join(`
`),A.length>0&&(A+=`
`),S=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,y].filter(ha).join(`
`),S.length>0&&(S+=`
`)):(A=[_f(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,y,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+m:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ha).join(`
`),S=[_f(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,y,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.envMap?"#define "+m:"",t.envMap?"#define "+v:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+f:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==mi?"#define TONE_MAPPING":"",t.toneMapping!==mi?_t.tonemapping_pars_fragment:"",t.toneMapping!==mi?rb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",_t.colorspace_pars_fragment,nb("linearToOutputTexel",t.outputColorSpace),sb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ha).join(`
`)),l=Ah(l),l=pf(l,t),l=mf(l,t),c=Ah(c),c=pf(c,t),c=mf(c,t),l=gf(l),c=gf(c),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,A=[g,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+A,S=["#define varying in",t.glslVersion===dh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===dh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+S);let P=_+A+l,U=_+S+c,I=uf(r,r.VERTEX_SHADER,P),O=uf(r,r.FRAGMENT_SHADER,U);r.attachShader(M,I),r.attachShader(M,O),t.index0AttributeName!==void 0?r.bindAttribLocation(M,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(M,0,"position"),r.linkProgram(M);function N(k){if(i.debug.checkShaderErrors){let Y=r.getProgramInfoLog(M)||"",Z=r.getShaderInfoLog(I)||"",ee=r.getShaderInfoLog(O)||"",z=Y.trim(),ie=Z.trim(),G=ee.trim(),ne=!0,Se=!0;if(r.getProgramParameter(M,r.LINK_STATUS)===!1)if(ne=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,M,I,O);else{let re=ff(r,I,"vertex"),H=ff(r,O,"fragment");it("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(M,r.VALIDATE_STATUS)+`

Material Name: `+k.name+`
Material Type: `+k.type+`

Program Info Log: `+z+`
`+re+`
`+H)}else z!==""?et("WebGLProgram: Program Info Log:",z):(ie===""||G==="")&&(Se=!1);Se&&(k.diagnostics={runnable:ne,programLog:z,vertexShader:{log:ie,prefix:A},fragmentShader:{log:G,prefix:S}})}r.deleteShader(I),r.deleteShader(O),w=new ts(r,M),D=lb(r,M)}let w;this.getUniforms=function(){return w===void 0&&N(this),w};let D;this.getAttributes=function(){return D===void 0&&N(this),D};let X=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return X===!1&&(X=r.getProgramParameter(M,KM)),X},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(M),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=QM++,this.cacheKey=e,this.usedTimes=1,this.program=M,this.vertexShader=I,this.fragmentShader=O,this}var xb=0,Ch=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Rh(e),t.set(e,n)),n}},Rh=class{constructor(e){this.id=xb++,this.code=e,this.usedTimes=0}};function Sb(i){return i===Ki||i===aa||i===oa}function Mb(i,e,t,n,r,a){let l=new Xr,c=new Ch,f=new Set,u=[],m=new Map,v=n.logarithmicDepthBuffer,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function y(w){return f.add(w),w===0?"uv":`uv${w}`}function M(w,D,X,k,Y,Z){let ee=k.fog,z=Y.geometry,ie=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?k.environment:null,G=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap,ne=e.get(w.envMap||ie,G),Se=g[w.type],re=n.precision;w.precision!==null&&(re=n.getMaxPrecision(w.precision),re!==w.precision&&et("WebGLProgram.getParameters:",w.precision,"not supported, using",re,"instead."));let H=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,ge=H!==void 0?H.length:0,We=0;z.morphAttributes.position!==void 0&&(We=1),z.morphAttributes.normal!==void 0&&(We=2),z.morphAttributes.color!==void 0&&(We=3);let rt,ue,Fe,Pe;if(Se){let Oe=_i[Se];rt=Oe.vertexShader,ue=Oe.fragmentShader}else{rt=w.vertexShader,ue=w.fragmentShader;let Oe=c.getVertexShaderStage(w),Tt=c.getFragmentShaderStage(w);c.update(w,Oe,Tt),Fe=Oe.id,Pe=Tt.id}let Ze=i.getRenderTarget(),Ue=i.state.buffers.depth.getReversed(),ot=Y.isInstancedMesh===!0,Vt=Y.isBatchedMesh===!0,Qe=!!w.map,Et=!!w.matcap,Ct=!!ne,mt=Ct&&ne.isPMREMTexture===!0,Ht=!!w.aoMap,pt=!!w.lightMap,It=!!w.bumpMap&&w.wireframe===!1,Mt=!!w.normalMap,rn=!!w.displacementMap,De=!!w.emissiveMap,$e=!!w.metalnessMap,hn=!!w.roughnessMap,sn=w.anisotropy>0,W=w.clearcoat>0,yn=w.diffuseRoughness>0,Rt=w.dispersion>0,Ut=w.retroreflectivity>0,Le=w.iridescence>0,$t=w.sheen>0,Je=w.transmission>0,Ke=sn&&!!w.anisotropyMap,L=W&&!!w.clearcoatMap,T=W&&!!w.clearcoatNormalMap,J=W&&!!w.clearcoatRoughnessMap,ve=yn&&!!w.diffuseRoughnessMap,de=Le&&!!w.iridescenceMap,pe=Le&&!!w.iridescenceThicknessMap,Me=$t&&!!w.sheenColorMap,ae=$t&&!!w.sheenRoughnessMap,le=!!w.specularMap,Ce=!!w.specularColorMap,B=!!w.specularIntensityMap,he=Je&&!!w.transmissionMap,se=Je&&!!w.thicknessMap,Re=!!w.gradientMap,Ee=!!w.alphaMap,Ae=w.alphaTest>0,Xe=!!w.alphaHash,ut=!!w.extensions,we=mi;w.toneMapped&&(Ze===null||Ze.isXRRenderTarget===!0)&&(we=i.toneMapping);let qe=mt?ne.isCompressedCubeTexture?ne.image[0].mipmaps:ne.mipmaps:null,dt={shaderID:Se,shaderType:w.type,shaderName:w.name,vertexShader:rt,fragmentShader:ue,defines:w.defines,customVertexShaderID:Fe,customFragmentShaderID:Pe,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:re,batching:Vt,batchingColor:Vt&&Y._colorsTexture!==null,instancing:ot,instancingColor:ot&&Y.instanceColor!==null,instancingMorph:ot&&Y.morphTexture!==null,outputColorSpace:Ze===null?i.outputColorSpace:Ze.isXRRenderTarget===!0?Ze.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!w.alphaToCoverage,map:Qe,matcap:Et,envMap:Ct,envMapMode:Ct&&ne.mapping,envMapPMREM:mt,envMapMaxLod:mt?qe.length-1:null,envMapSize:mt?qe[0].width:null,aoMap:Ht,lightMap:pt,bumpMap:It,normalMap:Mt,displacementMap:rn,emissiveMap:De,normalMapObjectSpace:Mt&&w.normalMapType===Ud,normalMapTangentSpace:Mt&&w.normalMapType===la,packedNormalMap:Mt&&w.normalMapType===la&&Sb(w.normalMap.format),metalnessMap:$e,roughnessMap:hn,anisotropy:sn,anisotropyMap:Ke,clearcoat:W,clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:J,diffuseRoughness:yn,diffuseRoughnessMap:ve,dispersion:Rt,retroreflection:Ut,iridescence:Le,iridescenceMap:de,iridescenceThicknessMap:pe,sheen:$t,sheenColorMap:Me,sheenRoughnessMap:ae,specularMap:le,specularColorMap:Ce,specularIntensityMap:B,transmission:Je,transmissionMap:he,thicknessMap:se,gradientMap:Re,opaque:w.transparent===!1&&w.blending===Jr&&w.alphaToCoverage===!1,alphaMap:Ee,alphaTest:Ae,alphaHash:Xe,combine:w.combine,mapUv:Qe&&y(w.map.channel),aoMapUv:Ht&&y(w.aoMap.channel),lightMapUv:pt&&y(w.lightMap.channel),bumpMapUv:It&&y(w.bumpMap.channel),normalMapUv:Mt&&y(w.normalMap.channel),displacementMapUv:rn&&y(w.displacementMap.channel),emissiveMapUv:De&&y(w.emissiveMap.channel),metalnessMapUv:$e&&y(w.metalnessMap.channel),roughnessMapUv:hn&&y(w.roughnessMap.channel),anisotropyMapUv:Ke&&y(w.anisotropyMap.channel),clearcoatMapUv:L&&y(w.clearcoatMap.channel),clearcoatNormalMapUv:T&&y(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&y(w.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ve&&y(w.diffuseRoughnessMap.channel),iridescenceMapUv:de&&y(w.iridescenceMap.channel),iridescenceThicknessMapUv:pe&&y(w.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&y(w.sheenColorMap.channel),sheenRoughnessMapUv:ae&&y(w.sheenRoughnessMap.channel),specularMapUv:le&&y(w.specularMap.channel),specularColorMapUv:Ce&&y(w.specularColorMap.channel),specularIntensityMapUv:B&&y(w.specularIntensityMap.channel),transmissionMapUv:he&&y(w.transmissionMap.channel),thicknessMapUv:se&&y(w.thicknessMap.channel),alphaMapUv:Ee&&y(w.alphaMap.channel),vertexTangents:!!z.attributes.tangent&&(Mt||sn),vertexNormals:!!z.attributes.normal,vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,pointsUvs:Y.isPoints===!0&&!!z.attributes.uv&&(Qe||Ee),fog:!!ee,useFog:w.fog===!0,fogExp2:!!ee&&ee.isFogExp2,flatShading:w.wireframe===!1&&(w.flatShading===!0||z.attributes.normal===void 0&&Mt===!1&&(w.isMeshLambertMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isMeshPhysicalMaterial)),sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:v,reversedDepthBuffer:Ue,skinning:Y.isSkinnedMesh===!0,hasPositionAttribute:z.attributes.position!==void 0,morphTargets:z.morphAttributes.position!==void 0,morphNormals:z.morphAttributes.normal!==void 0,morphColors:z.morphAttributes.color!==void 0,morphTargetsCount:ge,morphTextureStride:We,numSunLights:D.sun.length,numDirLights:D.directional.length,numPointLights:D.point.length,numSpotLights:D.spot.length,numSpotLightMaps:D.spotLightMap.length,numRectAreaLights:D.rectArea.length,numHemiLights:D.hemi.length,numSunLightShadows:D.sunShadowMap.length,numDirLightShadows:D.directionalShadowMap.length,numPointLightShadows:D.pointShadowMap.length,numSpotLightShadows:D.spotShadowMap.length,numSpotLightShadowsWithMaps:D.numSpotLightShadowsWithMaps,numLightProbes:D.numLightProbes,numLightProbeGrids:Z.filter(Oe=>Oe.texture!==null).length,numClippingPlanes:a.numPlanes,numClipIntersection:a.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&X.length>0,shadowMapType:i.shadowMap.type,toneMapping:we,decodeVideoTexture:Qe&&w.map.isVideoTexture===!0&&St.getTransfer(w.map.colorSpace)===Pt,decodeVideoTextureEmissive:De&&w.emissiveMap.isVideoTexture===!0&&St.getTransfer(w.emissiveMap.colorSpace)===Pt,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===pi,flipSided:w.side===dn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:ut&&w.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ut&&w.extensions.multiDraw===!0||Vt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return dt.vertexUv1s=f.has(1),dt.vertexUv2s=f.has(2),dt.vertexUv3s=f.has(3),f.clear(),dt}function A(w){let D=[];if(w.shaderID?D.push(w.shaderID):(D.push(w.customVertexShaderID),D.push(w.customFragmentShaderID)),w.defines!==void 0)for(let X in w.defines)D.push(X),D.push(w.defines[X]);return w.isRawShaderMaterial===!1&&(S(D,w),_(D,w),D.push(i.outputColorSpace)),D.push(w.customProgramCacheKey),D.join()}function S(w,D){w.push(D.precision),w.push(D.outputColorSpace),w.push(D.envMapMode),w.push(D.envMapPMREM),w.push(D.envMapMaxLod),w.push(D.envMapSize),w.push(D.mapUv),w.push(D.alphaMapUv),w.push(D.lightMapUv),w.push(D.aoMapUv),w.push(D.bumpMapUv),w.push(D.normalMapUv),w.push(D.displacementMapUv),w.push(D.emissiveMapUv),w.push(D.metalnessMapUv),w.push(D.roughnessMapUv),w.push(D.anisotropyMapUv),w.push(D.clearcoatMapUv),w.push(D.clearcoatNormalMapUv),w.push(D.clearcoatRoughnessMapUv),w.push(D.diffuseRoughnessMapUv),w.push(D.iridescenceMapUv),w.push(D.iridescenceThicknessMapUv),w.push(D.sheenColorMapUv),w.push(D.sheenRoughnessMapUv),w.push(D.specularMapUv),w.push(D.specularColorMapUv),w.push(D.specularIntensityMapUv),w.push(D.transmissionMapUv),w.push(D.thicknessMapUv),w.push(D.combine),w.push(D.fogExp2),w.push(D.sizeAttenuation),w.push(D.morphTargetsCount),w.push(D.numSunLights),w.push(D.numDirLights),w.push(D.numPointLights),w.push(D.numSpotLights),w.push(D.numSpotLightMaps),w.push(D.numHemiLights),w.push(D.numRectAreaLights),w.push(D.numSunLightShadows),w.push(D.numDirLightShadows),w.push(D.numPointLightShadows),w.push(D.numSpotLightShadows),w.push(D.numSpotLightShadowsWithMaps),w.push(D.numLightProbes),w.push(D.numLightProbeGrids),w.push(D.shadowMapType),w.push(D.toneMapping),w.push(D.numClippingPlanes),w.push(D.numClipIntersection),w.push(D.depthPacking)}function _(w,D){l.disableAll(),D.instancing&&l.enable(0),D.instancingColor&&l.enable(1),D.instancingMorph&&l.enable(2),D.matcap&&l.enable(3),D.envMap&&l.enable(4),D.normalMapObjectSpace&&l.enable(5),D.normalMapTangentSpace&&l.enable(6),D.clearcoat&&l.enable(7),D.iridescence&&l.enable(8),D.alphaTest&&l.enable(9),D.vertexColors&&l.enable(10),D.vertexAlphas&&l.enable(11),D.vertexUv1s&&l.enable(12),D.vertexUv2s&&l.enable(13),D.vertexUv3s&&l.enable(14),D.vertexTangents&&l.enable(15),D.anisotropy&&l.enable(16),D.alphaHash&&l.enable(17),D.batching&&l.enable(18),D.dispersion&&l.enable(19),D.retroreflection&&l.enable(24),D.diffuseRoughness&&l.enable(25),D.batchingColor&&l.enable(20),D.gradientMap&&l.enable(21),D.packedNormalMap&&l.enable(22),D.vertexNormals&&l.enable(23),w.push(l.mask),l.disableAll(),D.fog&&l.enable(0),D.useFog&&l.enable(1),D.flatShading&&l.enable(2),D.logarithmicDepthBuffer&&l.enable(3),D.reversedDepthBuffer&&l.enable(4),D.skinning&&l.enable(5),D.morphTargets&&l.enable(6),D.morphNormals&&l.enable(7),D.morphColors&&l.enable(8),D.premultipliedAlpha&&l.enable(9),D.shadowMapEnabled&&l.enable(10),D.doubleSided&&l.enable(11),D.flipSided&&l.enable(12),D.useDepthPacking&&l.enable(13),D.dithering&&l.enable(14),D.transmission&&l.enable(15),D.sheen&&l.enable(16),D.opaque&&l.enable(17),D.pointsUvs&&l.enable(18),D.decodeVideoTexture&&l.enable(19),D.decodeVideoTextureEmissive&&l.enable(20),D.alphaToCoverage&&l.enable(21),D.numLightProbeGrids>0&&l.enable(22),D.hasPositionAttribute&&l.enable(23),w.push(l.mask)}function P(w){let D=g[w.type],X;if(D){let k=_i[D];X=Jd.clone(k.uniforms)}else X=w.uniforms;return X}function U(w,D){let X=m.get(D);return X!==void 0?++X.usedTimes:(X=new yb(i,D,w,r),u.push(X),m.set(D,X)),X}function I(w){if(--w.usedTimes===0){let D=u.indexOf(w);u[D]=u[u.length-1],u.pop(),m.delete(w.cacheKey),w.destroy()}}function O(w){c.remove(w)}function N(){c.dispose()}return{getParameters:M,getProgramCacheKey:A,getUniforms:P,acquireProgram:U,releaseProgram:I,releaseShaderCache:O,programs:u,dispose:N}}function bb(){let i=new WeakMap;function e(l){return i.has(l)}function t(l){let c=i.get(l);return c===void 0&&(c={},i.set(l,c)),c}function n(l){i.delete(l)}function r(l,c,f){i.get(l)[c]=f}function a(){i=new WeakMap}return{has:e,get:t,remove:n,update:r,dispose:a}}function wb(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function vf(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function yf(){let i=[],e=0,t=[],n=[],r=[];function a(){e=0,t.length=0,n.length=0,r.length=0}function l(g){let y=0;return g.isInstancedMesh&&(y+=2),g.isSkinnedMesh&&(y+=1),y}function c(g,y,M,A,S,_){let P=i[e];return P===void 0?(P={id:g.id,object:g,geometry:y,material:M,materialVariant:l(g),groupOrder:A,renderOrder:g.renderOrder,z:S,group:_},i[e]=P):(P.id=g.id,P.object=g,P.geometry=y,P.material=M,P.materialVariant=l(g),P.groupOrder=A,P.renderOrder=g.renderOrder,P.z=S,P.group=_),e++,P}function f(g,y,M,A,S,_,P){P.reversedDepth===!0&&(S=-S);let U=c(g,y,M,A,S,_);M.transmission>0?n.push(U):M.transparent===!0?r.push(U):t.push(U)}function u(g,y,M,A,S,_){let P=c(g,y,M,A,S,_);M.transmission>0?n.unshift(P):M.transparent===!0?r.unshift(P):t.unshift(P)}function m(g,y){t.length>1&&t.sort(g||wb),n.length>1&&n.sort(y||vf),r.length>1&&r.sort(y||vf)}function v(){for(let g=e,y=i.length;g<y;g++){let M=i[g];if(M.id===null)break;M.id=null,M.object=null,M.geometry=null,M.material=null,M.group=null}}return{opaque:t,transmissive:n,transparent:r,init:a,push:f,unshift:u,finish:v,sort:m}}function Eb(){let i=new WeakMap;function e(n,r){let a=i.get(n),l;return a===void 0?(l=new yf,i.set(n,[l])):r>=a.length?(l=new yf,a.push(l)):l=a[r],l}function t(){i=new WeakMap}return{get:e,dispose:t}}function Tb(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new j,color:new ht};break;case"SpotLight":t={position:new j,direction:new j,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new j,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new j,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new j,halfWidth:new j,halfHeight:new j};break}return i[e.id]=t,t}}}function Ab(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var Cb=0;function Rb(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Pb(i){let e=new Tb,t=Ab(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let u=0;u<9;u++)n.probe.push(new j);let r=new j,a=new Lt,l=new Lt;function c(u){let m=0,v=0,g=0;for(let Z=0;Z<9;Z++)n.probe[Z].set(0,0,0);let y=0,M=0,A=0,S=0,_=0,P=0,U=0,I=0,O=0,N=0,w=0,D=0,X=0,k=0;u.sort(Rb);for(let Z=0,ee=u.length;Z<ee;Z++){let z=u[Z],ie=z.color,G=z.intensity,ne=z.distance,Se=null;if(z.shadow&&z.shadow.map&&(z.shadow.map.texture.format===Ki?Se=z.shadow.map.texture:Se=z.shadow.map.depthTexture||z.shadow.map.texture),z.isAmbientLight)m+=ie.r*G,v+=ie.g*G,g+=ie.b*G;else if(z.isLightProbe){for(let re=0;re<9;re++)n.probe[re].addScaledVector(z.sh.coefficients[re],G);k++}else if(z.isSunLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize.copy(H.mapSize).multiply(H.getFrameExtents()),n.sunShadow[M]=ge,n.sunShadowMap[M]=Se;let We=H.getViewportCount();for(let rt=0;rt<We;rt++)n.sunShadowMatrix[A+rt]=H.getMatrix(rt),n.sunShadowCascade[A+rt]=H._cascadeData[rt];A+=We,M++}n.sun[y]=re,y++}else if(z.isDirectionalLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.directionalShadow[S]=ge,n.directionalShadowMap[S]=Se,n.directionalShadowMatrix[S]=z.shadow.matrix,O++}n.directional[S]=re,S++}else if(z.isSpotLight){let re=e.get(z);re.position.setFromMatrixPosition(z.matrixWorld),re.color.copy(ie).multiplyScalar(G),re.distance=ne,re.coneCos=Math.cos(z.angle),re.penumbraCos=Math.cos(z.angle*(1-z.penumbra)),re.decay=z.decay,n.spot[P]=re;let H=z.shadow;if(z.map&&(n.spotLightMap[D]=z.map,D++,H.updateMatrices(z),z.castShadow&&X++),n.spotLightMatrix[P]=H.matrix,z.castShadow){let ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,n.spotShadow[P]=ge,n.spotShadowMap[P]=Se,w++}P++}else if(z.isRectAreaLight){let re=e.get(z);re.color.copy(ie).multiplyScalar(G),re.halfWidth.set(z.width*.5,0,0),re.halfHeight.set(0,z.height*.5,0),n.rectArea[U]=re,U++}else if(z.isPointLight){let re=e.get(z);if(re.color.copy(z.color).multiplyScalar(z.intensity),re.distance=z.distance,re.decay=z.decay,z.castShadow){let H=z.shadow,ge=t.get(z);ge.shadowIntensity=H.intensity,ge.shadowBias=H.bias,ge.shadowNormalBias=H.normalBias,ge.shadowRadius=H.radius,ge.shadowMapSize=H.mapSize,ge.shadowCameraNear=H.camera.near,ge.shadowCameraFar=H.camera.far,n.pointShadow[_]=ge,n.pointShadowMap[_]=Se,n.pointShadowMatrix[_]=z.shadow.matrix,N++}n.point[_]=re,_++}else if(z.isHemisphereLight){let re=e.get(z);re.skyColor.copy(z.color).multiplyScalar(G),re.groundColor.copy(z.groundColor).multiplyScalar(G),n.hemi[I]=re,I++}}U>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Be.LTC_FLOAT_1,n.rectAreaLTC2=Be.LTC_FLOAT_2):(n.rectAreaLTC1=Be.LTC_HALF_1,n.rectAreaLTC2=Be.LTC_HALF_2)),n.ambient[0]=m,n.ambient[1]=v,n.ambient[2]=g;let Y=n.hash;(Y.sunLength!==y||Y.directionalLength!==S||Y.pointLength!==_||Y.spotLength!==P||Y.rectAreaLength!==U||Y.hemiLength!==I||Y.numSunShadows!==M||Y.numDirectionalShadows!==O||Y.numPointShadows!==N||Y.numSpotShadows!==w||Y.numSpotMaps!==D||Y.numLightProbes!==k)&&(n.sun.length=y,n.directional.length=S,n.spot.length=P,n.rectArea.length=U,n.point.length=_,n.hemi.length=I,n.sunShadow.length=M,n.sunShadowMap.length=M,n.sunShadowMatrix.length=A,n.sunShadowCascade.length=A,n.directionalShadow.length=O,n.directionalShadowMap.length=O,n.directionalShadowMatrix.length=O,n.pointShadow.length=N,n.pointShadowMap.length=N,n.pointShadowMatrix.length=N,n.spotShadow.length=w,n.spotShadowMap.length=w,n.spotLightMatrix.length=w+D-X,n.spotLightMap.length=D,n.numSpotLightShadowsWithMaps=X,n.numLightProbes=k,Y.sunLength=y,Y.directionalLength=S,Y.pointLength=_,Y.spotLength=P,Y.rectAreaLength=U,Y.hemiLength=I,Y.numSunShadows=M,Y.numDirectionalShadows=O,Y.numPointShadows=N,Y.numSpotShadows=w,Y.numSpotMaps=D,Y.numLightProbes=k,n.version=Cb++)}function f(u,m){let v=0,g=0,y=0,M=0,A=0,S=0,_=m.matrixWorldInverse;for(let P=0,U=u.length;P<U;P++){let I=u[P];if(I.isSunLight){let O=n.sun[v];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(_),v++}else if(I.isDirectionalLight){let O=n.directional[g];O.direction.setFromMatrixPosition(I.matrixWorld),r.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(r),O.direction.transformDirection(_),g++}else if(I.isSpotLight){let O=n.spot[M];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(_),O.direction.setFromMatrixPosition(I.matrixWorld),r.setFromMatrixPosition(I.target.matrixWorld),O.direction.sub(r),O.direction.transformDirection(_),M++}else if(I.isRectAreaLight){let O=n.rectArea[A];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(_),l.identity(),a.copy(I.matrixWorld),a.premultiply(_),l.extractRotation(a),O.halfWidth.set(I.width*.5,0,0),O.halfHeight.set(0,I.height*.5,0),O.halfWidth.applyMatrix4(l),O.halfHeight.applyMatrix4(l),A++}else if(I.isPointLight){let O=n.point[y];O.position.setFromMatrixPosition(I.matrixWorld),O.position.applyMatrix4(_),y++}else if(I.isHemisphereLight){let O=n.hemi[S];O.direction.setFromMatrixPosition(I.matrixWorld),O.direction.transformDirection(_),S++}}}return{setup:c,setupView:f,state:n}}function xf(i){let e=new Pb(i),t=[],n=[],r=[];function a(v){m.camera=v,t.length=0,n.length=0,r.length=0}function l(v){v.isLightProbeGrid?r.push(v):t.push(v)}function c(v){n.push(v)}function f(){e.setup(t),r.sort((v,g)=>v.priority-g.priority||v.id-g.id)}function u(v){e.setupView(t,v)}let m={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:a,state:m,setupLights:f,setupLightsView:u,pushLight:l,pushShadow:c}}function Ib(i){let e=new WeakMap;function t(r,a=0){let l=e.get(r),c;return l===void 0?(c=new xf(i),e.set(r,[c])):a>=l.length?(c=new xf(i),l.push(c)):c=l[a],c}function n(){e=new WeakMap}return{get:t,dispose:n}}var Db=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Lb=`uniform sampler2D shadow_pass;
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
}`,Fb=[new j(1,0,0),new j(-1,0,0),new j(0,1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1)],Nb=[new j(0,-1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1),new j(0,-1,0),new j(0,-1,0)],Sf=new Lt,ca=new j,bh=new j;function Ub(i,e,t){let n=new Wi,r=new tt,a=new tt,l=new Gt,c=new Fo,f=new No,u={},m=t.maxTextureSize,v={[Ji]:dn,[dn]:Ji,[pi]:pi},g=new fi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:Db,fragmentShader:Lb}),y=g.clone();y.defines.HORIZONTAL_PASS=1;let M=new En;M.setAttribute("position",new Tn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let A=new Ot(M,g),S=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=pr;let _=this.type;this.render=function(N,w,D){if(S.enabled===!1||S.autoUpdate===!1&&S.needsUpdate===!1||N.length===0)return;this.type===fd&&(et("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=pr);let X=i.getRenderTarget(),k=i.getActiveCubeFace(),Y=i.getActiveMipmapLevel(),Z=i.state;Z.setBlending(mr),Z.buffers.depth.getReversed()===!0?Z.buffers.color.setClear(0,0,0,0):Z.buffers.color.setClear(1,1,1,1),Z.buffers.depth.setTest(!0),Z.setScissorTest(!1);let ee=_!==this.type;ee&&w.traverse(function(z){z.material&&(Array.isArray(z.material)?z.material.forEach(ie=>ie.needsUpdate=!0):z.material.needsUpdate=!0)});for(let z=0,ie=N.length;z<ie;z++){let G=N[z],ne=G.shadow;if(ne===void 0){et("WebGLShadowMap:",G,"has no shadow.");continue}if(ne.autoUpdate===!1&&ne.needsUpdate===!1)continue;r.copy(ne.mapSize);let Se=ne.getFrameExtents();r.multiply(Se),a.copy(ne.mapSize),(r.x>m||r.y>m)&&(r.x>m&&(a.x=Math.floor(m/Se.x),r.x=a.x*Se.x,ne.mapSize.x=a.x),r.y>m&&(a.y=Math.floor(m/Se.y),r.y=a.y*Se.y,ne.mapSize.y=a.y));let re=i.state.buffers.depth.getReversed();if(ne.camera._reversedDepth=re,ne.map===null||ee===!0){if(ne.map!==null&&(ne.map.depthTexture!==null&&(ne.map.depthTexture.dispose(),ne.map.depthTexture=null),ne.map.dispose()),this.type===Zr){if(G.isPointLight){et("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}ne.map=new Fn(r.x,r.y,{format:Ki,type:Kn,minFilter:Mn,magFilter:Mn,generateMipmaps:!1}),ne.map.texture.name=G.name+".shadowMap",ne.map.depthTexture=new Ci(r.x,r.y,Vn),ne.map.depthTexture.name=G.name+".shadowMapDepth",ne.map.depthTexture.format=Ti,ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn}else G.isPointLight?(ne.map=new ua(r.x),ne.map.depthTexture=new zs(r.x,Jn)):(ne.map=new Fn(r.x,r.y),ne.map.depthTexture=new Ci(r.x,r.y,Jn)),ne.map.depthTexture.name=G.name+".shadowMap",ne.map.depthTexture.format=Ti,this.type===pr?(ne.map.depthTexture.compareFunction=re?hh:ch,ne.map.depthTexture.minFilter=Mn,ne.map.depthTexture.magFilter=Mn):(ne.map.depthTexture.compareFunction=null,ne.map.depthTexture.minFilter=cn,ne.map.depthTexture.magFilter=cn);ne.camera.updateProjectionMatrix()}ne.map.isWebGLCubeRenderTarget!==!0&&(ne.map.width!==r.x||ne.map.height!==r.y)&&ne.map.setSize(r.x,r.y);let H=ne.map.isWebGLCubeRenderTarget?6:ne.getViewportCount();G.isPointLight!==!0&&ne.updateMatrices(G,D);let ge=(ne.camera.layers.mask&4294967294)!==0?ne.camera.layers:D.layers;for(let We=0;We<H;We++){let rt=ne.getCamera(We);if(G.isPointLight){let ue=ne.camera,Fe=ne.matrix,Pe=G.distance||ue.far;Pe!==ue.far&&(ue.far=Pe,ue.updateProjectionMatrix()),ca.setFromMatrixPosition(G.matrixWorld),ue.position.copy(ca),bh.copy(ue.position),bh.add(Fb[We]),ue.up.copy(Nb[We]),ue.lookAt(bh),ue.updateMatrixWorld(),Fe.makeTranslation(-ca.x,-ca.y,-ca.z),Sf.multiplyMatrices(ue.projectionMatrix,ue.matrixWorldInverse),ne._frustum.setFromProjectionMatrix(Sf,ue.coordinateSystem,ue.reversedDepth)}if(ne.map.isWebGLCubeRenderTarget)i.setRenderTarget(ne.map,We),i.clear();else{We===0&&(i.setRenderTarget(ne.map),i.clear());let ue=ne.getViewport(We);l.set(a.x*ue.x,a.y*ue.y,a.x*ue.z,a.y*ue.w),Z.viewport(l)}n=ne.getFrustum(We),I(w,D,rt,G,ge,this.type)}ne.isPointLightShadow!==!0&&this.type===Zr&&P(ne,D),ne.needsUpdate=!1}_=this.type,S.needsUpdate=!1,i.setRenderTarget(X,k,Y)};function P(N,w){let D=e.update(A);g.defines.VSM_SAMPLES!==N.blurSamples&&(g.defines.VSM_SAMPLES=N.blurSamples,y.defines.VSM_SAMPLES=N.blurSamples,g.needsUpdate=!0,y.needsUpdate=!0),N.mapPass===null?N.mapPass=new Fn(r.x,r.y,{format:Ki,type:Kn}):(N.mapPass.width!==N.map.width||N.mapPass.height!==N.map.height)&&N.mapPass.setSize(N.map.width,N.map.height),g.uniforms.shadow_pass.value=N.map.depthTexture,g.uniforms.resolution.value.set(N.map.width,N.map.height),g.uniforms.radius.value=N.radius,i.setRenderTarget(N.mapPass),i.clear(),i.renderBufferDirect(w,null,D,g,A,null),y.uniforms.shadow_pass.value=N.mapPass.texture,y.uniforms.resolution.value.set(N.map.width,N.map.height),y.uniforms.radius.value=N.radius,i.setRenderTarget(N.map),i.clear(),i.renderBufferDirect(w,null,D,y,A,null)}function U(N,w,D,X){let k=null,Y=D.isPointLight===!0?N.customDistanceMaterial:N.customDepthMaterial;if(Y!==void 0)k=Y;else if(k=D.isPointLight===!0?f:c,i.localClippingEnabled&&w.clipShadows===!0&&Array.isArray(w.clippingPlanes)&&w.clippingPlanes.length!==0||w.displacementMap&&w.displacementScale!==0||w.alphaMap&&w.alphaTest>0||w.map&&w.alphaTest>0||w.alphaToCoverage===!0){let Z=k.uuid,ee=w.uuid,z=u[Z];z===void 0&&(z={},u[Z]=z);let ie=z[ee];ie===void 0&&(ie=k.clone(),z[ee]=ie,w.addEventListener("dispose",O)),k=ie}if(k.visible=w.visible,k.wireframe=w.wireframe,X===Zr?k.side=w.shadowSide!==null?w.shadowSide:w.side:k.side=w.shadowSide!==null?w.shadowSide:v[w.side],k.alphaMap=w.alphaMap,k.alphaTest=w.alphaToCoverage===!0?.5:w.alphaTest,k.map=w.map,k.clipShadows=w.clipShadows,k.clippingPlanes=w.clippingPlanes,k.clipIntersection=w.clipIntersection,k.displacementMap=w.displacementMap,k.displacementScale=w.displacementScale,k.displacementBias=w.displacementBias,k.wireframeLinewidth=w.wireframeLinewidth,k.linewidth=w.linewidth,D.isPointLight===!0&&k.isMeshDistanceMaterial===!0){let Z=i.properties.get(k);Z.light=D}return k}function I(N,w,D,X,k,Y){if(N.visible===!1)return;if(N.layers.test(k)&&(N.isMesh||N.isLine||N.isPoints)&&(N.castShadow||N.receiveShadow&&Y===Zr)&&(!N.frustumCulled||N.intersectsFrustum(n))){N.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,N.matrixWorld);let z=e.update(N),ie=N.material;if(Array.isArray(ie)){let G=z.groups;for(let ne=0,Se=G.length;ne<Se;ne++){let re=G[ne],H=ie[re.materialIndex];if(H&&H.visible){let ge=U(N,H,X,Y);N.onBeforeShadow(i,N,w,D,z,ge,re),i.renderBufferDirect(D,null,z,ge,N,re),N.onAfterShadow(i,N,w,D,z,ge,re)}}}else if(ie.visible){let G=U(N,ie,X,Y);N.onBeforeShadow(i,N,w,D,z,G,null),i.renderBufferDirect(D,null,z,G,N,null),N.onAfterShadow(i,N,w,D,z,G,null)}}let ee=N.children;for(let z=0,ie=ee.length;z<ie;z++)I(ee[z],w,D,X,k,Y)}function O(N){N.target.removeEventListener("dispose",O);for(let D in u){let X=u[D],k=N.target.uuid;k in X&&(X[k].dispose(),delete X[k])}}}function Ob(i,e){function t(){let B=!1,he=new Gt,se=null,Re=new Gt(0,0,0,0);return{setMask:function(Ee){se!==Ee&&!B&&(i.colorMask(Ee,Ee,Ee,Ee),se=Ee)},setLocked:function(Ee){B=Ee},setClear:function(Ee,Ae,Xe,ut,we){we===!0&&(Ee*=ut,Ae*=ut,Xe*=ut),he.set(Ee,Ae,Xe,ut),Re.equals(he)===!1&&(i.clearColor(Ee,Ae,Xe,ut),Re.copy(he))},reset:function(){B=!1,se=null,Re.set(-1,0,0,0)}}}function n(){let B=!1,he=!1,se=null,Re=null,Ee=null;return{setReversed:function(Ae){if(he!==Ae){let Xe=e.get("EXT_clip_control");Ae?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),he=Ae;let ut=Ee;Ee=null,this.setClear(ut)}},getReversed:function(){return he},setTest:function(Ae){Ae?Ue(i.DEPTH_TEST):ot(i.DEPTH_TEST)},setMask:function(Ae){se!==Ae&&!B&&(i.depthMask(Ae),se=Ae)},setFunc:function(Ae){if(he&&(Ae=qd[Ae]),Re!==Ae){switch(Ae){case go:i.depthFunc(i.NEVER);break;case _o:i.depthFunc(i.ALWAYS);break;case vo:i.depthFunc(i.LESS);break;case kr:i.depthFunc(i.LEQUAL);break;case yo:i.depthFunc(i.EQUAL);break;case xo:i.depthFunc(i.GEQUAL);break;case So:i.depthFunc(i.GREATER);break;case Mo:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ae}},setLocked:function(Ae){B=Ae},setClear:function(Ae){Ee!==Ae&&(Ee=Ae,he&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){B=!1,se=null,Re=null,Ee=null,he=!1}}}function r(){let B=!1,he=null,se=null,Re=null,Ee=null,Ae=null,Xe=null,ut=null,we=null;return{setTest:function(qe){B||(qe?Ue(i.STENCIL_TEST):ot(i.STENCIL_TEST))},setMask:function(qe){he!==qe&&!B&&(i.stencilMask(qe),he=qe)},setFunc:function(qe,dt,Oe){(se!==qe||Re!==dt||Ee!==Oe)&&(i.stencilFunc(qe,dt,Oe),se=qe,Re=dt,Ee=Oe)},setOp:function(qe,dt,Oe){(Ae!==qe||Xe!==dt||ut!==Oe)&&(i.stencilOp(qe,dt,Oe),Ae=qe,Xe=dt,ut=Oe)},setLocked:function(qe){B=qe},setClear:function(qe){we!==qe&&(i.clearStencil(qe),we=qe)},reset:function(){B=!1,he=null,se=null,Re=null,Ee=null,Ae=null,Xe=null,ut=null,we=null}}}let a=new t,l=new n,c=new r,f={},u=new WeakMap,m={},v={},g={},y=new WeakMap,M=[],A=null,S=!1,_=null,P=null,U=null,I=null,O=null,N=null,w=null,D=new ht(0,0,0),X=0,k=!1,Y=null,Z=null,ee=null,z=null,ie=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),ne=!1,Se=0,re=i.getParameter(i.VERSION);re.indexOf("WebGL")!==-1?(Se=parseFloat(/^WebGL (\d)/.exec(re)[1]),ne=Se>=1):re.indexOf("OpenGL ES")!==-1&&(Se=parseFloat(/^OpenGL ES (\d)/.exec(re)[1]),ne=Se>=2);let H=null,ge={},We=i.getParameter(i.SCISSOR_BOX),rt=i.getParameter(i.VIEWPORT),ue=new Gt().fromArray(We),Fe=new Gt().fromArray(rt);function Pe(B,he,se,Re){let Ee=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(B,Ae),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xe=0;Xe<se;Xe++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(he,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,Ee):i.texImage2D(he+Xe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Ee);return Ae}let Ze={};Ze[i.TEXTURE_2D]=Pe(i.TEXTURE_2D,i.TEXTURE_2D,1),Ze[i.TEXTURE_CUBE_MAP]=Pe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ze[i.TEXTURE_2D_ARRAY]=Pe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ze[i.TEXTURE_3D]=Pe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),a.setClear(0,0,0,1),l.setClear(1),c.setClear(0),Ue(i.DEPTH_TEST),l.setFunc(kr),It(!1),Mt(Wc),Ue(i.CULL_FACE),Ht(mr);function Ue(B){m[B]!==!0&&(i.enable(B),m[B]=!0)}function ot(B){m[B]!==!1&&(i.disable(B),m[B]=!1)}function Vt(B,he){return g[B]!==he?(i.bindFramebuffer(B,he),g[B]=he,B===i.DRAW_FRAMEBUFFER&&(g[i.FRAMEBUFFER]=he),B===i.FRAMEBUFFER&&(g[i.DRAW_FRAMEBUFFER]=he),!0):!1}function Qe(B,he){let se=M,Re=!1;if(B){se=y.get(he),se===void 0&&(se=[],y.set(he,se));let Ee=B.textures;if(se.length!==Ee.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Xe=Ee.length;Ae<Xe;Ae++)se[Ae]=i.COLOR_ATTACHMENT0+Ae;se.length=Ee.length,Re=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,Re=!0);Re&&i.drawBuffers(se)}function Et(B){return A!==B?(i.useProgram(B),A=B,!0):!1}let Ct={[gr]:i.FUNC_ADD,[md]:i.FUNC_SUBTRACT,[gd]:i.FUNC_REVERSE_SUBTRACT};Ct[_d]=i.MIN,Ct[vd]=i.MAX;let mt={[yd]:i.ZERO,[xd]:i.ONE,[Sd]:i.SRC_COLOR,[Yc]:i.SRC_ALPHA,[Ad]:i.SRC_ALPHA_SATURATE,[Ed]:i.DST_COLOR,[bd]:i.DST_ALPHA,[Md]:i.ONE_MINUS_SRC_COLOR,[jc]:i.ONE_MINUS_SRC_ALPHA,[Td]:i.ONE_MINUS_DST_COLOR,[wd]:i.ONE_MINUS_DST_ALPHA,[Cd]:i.CONSTANT_COLOR,[Rd]:i.ONE_MINUS_CONSTANT_COLOR,[Pd]:i.CONSTANT_ALPHA,[Id]:i.ONE_MINUS_CONSTANT_ALPHA};function Ht(B,he,se,Re,Ee,Ae,Xe,ut,we,qe){if(B===mr){S===!0&&(ot(i.BLEND),S=!1);return}if(S===!1&&(Ue(i.BLEND),S=!0),B!==pd){if(B!==_||qe!==k){if((P!==gr||O!==gr)&&(i.blendEquation(i.FUNC_ADD),P=gr,O=gr),qe)switch(B){case Jr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Xc:i.blendFunc(i.ONE,i.ONE);break;case $c:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case qc:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:it("WebGLState: Invalid blending: ",B);break}else switch(B){case Jr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Xc:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case $c:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case qc:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",B);break}U=null,I=null,N=null,w=null,D.set(0,0,0),X=0,_=B,k=qe}return}Ee=Ee||he,Ae=Ae||se,Xe=Xe||Re,(he!==P||Ee!==O)&&(i.blendEquationSeparate(Ct[he],Ct[Ee]),P=he,O=Ee),(se!==U||Re!==I||Ae!==N||Xe!==w)&&(i.blendFuncSeparate(mt[se],mt[Re],mt[Ae],mt[Xe]),U=se,I=Re,N=Ae,w=Xe),(ut.equals(D)===!1||we!==X)&&(i.blendColor(ut.r,ut.g,ut.b,we),D.copy(ut),X=we),_=B,k=!1}function pt(B,he){B.side===pi?ot(i.CULL_FACE):Ue(i.CULL_FACE);let se=B.side===dn;he&&(se=!se),It(se),B.blending===Jr&&B.transparent===!1?Ht(mr):Ht(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),l.setFunc(B.depthFunc),l.setTest(B.depthTest),l.setMask(B.depthWrite),a.setMask(B.colorWrite);let Re=B.stencilWrite;c.setTest(Re),Re&&(c.setMask(B.stencilWriteMask),c.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),c.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),De(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Ue(i.SAMPLE_ALPHA_TO_COVERAGE):ot(i.SAMPLE_ALPHA_TO_COVERAGE)}function It(B){Y!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),Y=B)}function Mt(B){B!==ud?(Ue(i.CULL_FACE),B!==Z&&(B===Wc?i.cullFace(i.BACK):B===dd?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):ot(i.CULL_FACE),Z=B}function rn(B){B!==ee&&(ne&&i.lineWidth(B),ee=B)}function De(B,he,se){B?(Ue(i.POLYGON_OFFSET_FILL),(z!==he||ie!==se)&&(z=he,ie=se,l.getReversed()&&(he=-he,se=-se),i.polygonOffset(he,se))):ot(i.POLYGON_OFFSET_FILL)}function $e(B){B?Ue(i.SCISSOR_TEST):ot(i.SCISSOR_TEST)}function hn(B){B===void 0&&(B=i.TEXTURE0+G-1),H!==B&&(i.activeTexture(B),H=B)}function sn(B,he,se){se===void 0&&(H===null?se=i.TEXTURE0+G-1:se=H);let Re=ge[se];Re===void 0&&(Re={type:void 0,texture:void 0},ge[se]=Re),(Re.type!==B||Re.texture!==he)&&(H!==se&&(i.activeTexture(se),H=se),i.bindTexture(B,he||Ze[B]),Re.type=B,Re.texture=he)}function W(){let B=ge[H];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function yn(){try{i.compressedTexImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function Rt(){try{i.compressedTexImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function Ut(){try{i.texSubImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function Le(){try{i.texSubImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function $t(){try{i.compressedTexSubImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function Je(){try{i.compressedTexSubImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function Ke(){try{i.texStorage2D(...arguments)}catch(B){it("WebGLState:",B)}}function L(){try{i.texStorage3D(...arguments)}catch(B){it("WebGLState:",B)}}function T(){try{i.texImage2D(...arguments)}catch(B){it("WebGLState:",B)}}function J(){try{i.texImage3D(...arguments)}catch(B){it("WebGLState:",B)}}function ve(B){return v[B]!==void 0?v[B]:i.getParameter(B)}function de(B,he){v[B]!==he&&(i.pixelStorei(B,he),v[B]=he)}function pe(B){ue.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),ue.copy(B))}function Me(B){Fe.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),Fe.copy(B))}function ae(B,he){let se=u.get(he);se===void 0&&(se=new WeakMap,u.set(he,se));let Re=se.get(B);Re===void 0&&(Re=i.getUniformBlockIndex(he,B.name),i.uniformBlockBinding(he,Re,Re),se.set(B,Re))}function le(B,he,se){let Ee=u.get(he).get(B);f[Ee]!==se&&(i.bindBufferBase(i.UNIFORM_BUFFER,Ee,se),f[Ee]=se)}function Ce(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),l.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),m={},v={},H=null,ge={},g={},f={},y=new WeakMap,M=[],A=null,S=!1,_=null,P=null,U=null,I=null,O=null,N=null,w=null,D=new ht(0,0,0),X=0,k=!1,Y=null,Z=null,ee=null,z=null,ie=null,ue.set(0,0,i.canvas.width,i.canvas.height),Fe.set(0,0,i.canvas.width,i.canvas.height),a.reset(),l.reset(),c.reset()}return{buffers:{color:a,depth:l,stencil:c},enable:Ue,disable:ot,bindFramebuffer:Vt,drawBuffers:Qe,useProgram:Et,setBlending:Ht,setMaterial:pt,setFlipSided:It,setCullFace:Mt,setLineWidth:rn,setPolygonOffset:De,setScissorTest:$e,activeTexture:hn,bindTexture:sn,unbindTexture:W,compressedTexImage2D:yn,compressedTexImage3D:Rt,texImage2D:T,texImage3D:J,pixelStorei:de,getParameter:ve,updateUBOMapping:ae,uniformBlockBinding:le,texStorage2D:Ke,texStorage3D:L,texSubImage2D:Ut,texSubImage3D:Le,compressedTexSubImage2D:$t,compressedTexSubImage3D:Je,scissor:pe,viewport:Me,reset:Ce}}function Bb(i,e,t,n,r,a,l){let c=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,f=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),u=new tt,m=new WeakMap,v=new Set,g,y=new WeakMap,M=new Set,A=new FinalizationRegistry(L=>M.delete(L)),S=!1;try{S=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(L,T){return S?new OffscreenCanvas(L,T):Cs("canvas")}function P(L,T,J){let ve=1,de=Ke(L);if((de.width>J||de.height>J)&&(ve=J/Math.max(de.width,de.height)),ve<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let pe=Math.floor(ve*de.width),Me=Math.floor(ve*de.height);g===void 0&&(g=_(pe,Me));let ae=T?_(pe,Me):g;return ae.width=pe,ae.height=Me,ae.getContext("2d").drawImage(L,0,0,pe,Me),et("WebGLRenderer: Texture has been resized from ("+de.width+"x"+de.height+") to ("+pe+"x"+Me+")."),ae}else return"data"in L&&et("WebGLRenderer: Image in DataTexture is too big ("+de.width+"x"+de.height+")."),L;return L}function U(L){return L.generateMipmaps}function I(L){i.generateMipmap(L)}function O(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function N(L,T,J,ve,de,pe=!1){if(L!==null){if(i[L]!==void 0)return i[L];et("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let Me;ve&&(Me=e.get("EXT_texture_norm16"),Me||et("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ae=T;if(T===i.RED&&(J===i.FLOAT&&(ae=i.R32F),J===i.HALF_FLOAT&&(ae=i.R16F),J===i.UNSIGNED_BYTE&&(ae=i.R8),J===i.UNSIGNED_SHORT&&Me&&(ae=Me.R16_EXT),J===i.SHORT&&Me&&(ae=Me.R16_SNORM_EXT)),T===i.RED_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.R8UI),J===i.UNSIGNED_SHORT&&(ae=i.R16UI),J===i.UNSIGNED_INT&&(ae=i.R32UI),J===i.BYTE&&(ae=i.R8I),J===i.SHORT&&(ae=i.R16I),J===i.INT&&(ae=i.R32I)),T===i.RG&&(J===i.FLOAT&&(ae=i.RG32F),J===i.HALF_FLOAT&&(ae=i.RG16F),J===i.UNSIGNED_BYTE&&(ae=i.RG8),J===i.UNSIGNED_SHORT&&Me&&(ae=Me.RG16_EXT),J===i.SHORT&&Me&&(ae=Me.RG16_SNORM_EXT)),T===i.RG_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.RG8UI),J===i.UNSIGNED_SHORT&&(ae=i.RG16UI),J===i.UNSIGNED_INT&&(ae=i.RG32UI),J===i.BYTE&&(ae=i.RG8I),J===i.SHORT&&(ae=i.RG16I),J===i.INT&&(ae=i.RG32I)),T===i.RGB_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.RGB8UI),J===i.UNSIGNED_SHORT&&(ae=i.RGB16UI),J===i.UNSIGNED_INT&&(ae=i.RGB32UI),J===i.BYTE&&(ae=i.RGB8I),J===i.SHORT&&(ae=i.RGB16I),J===i.INT&&(ae=i.RGB32I)),T===i.RGBA_INTEGER&&(J===i.UNSIGNED_BYTE&&(ae=i.RGBA8UI),J===i.UNSIGNED_SHORT&&(ae=i.RGBA16UI),J===i.UNSIGNED_INT&&(ae=i.RGBA32UI),J===i.BYTE&&(ae=i.RGBA8I),J===i.SHORT&&(ae=i.RGBA16I),J===i.INT&&(ae=i.RGBA32I)),T===i.RGB&&(J===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGB16_EXT),J===i.SHORT&&Me&&(ae=Me.RGB16_SNORM_EXT),J===i.UNSIGNED_INT_5_9_9_9_REV&&(ae=i.RGB9_E5),J===i.UNSIGNED_INT_10F_11F_11F_REV&&(ae=i.R11F_G11F_B10F)),T===i.RGBA){let le=pe?As:St.getTransfer(de);J===i.FLOAT&&(ae=i.RGBA32F),J===i.HALF_FLOAT&&(ae=i.RGBA16F),J===i.UNSIGNED_BYTE&&(ae=le===Pt?i.SRGB8_ALPHA8:i.RGBA8),J===i.UNSIGNED_SHORT&&Me&&(ae=Me.RGBA16_EXT),J===i.SHORT&&Me&&(ae=Me.RGBA16_SNORM_EXT),J===i.UNSIGNED_SHORT_4_4_4_4&&(ae=i.RGBA4),J===i.UNSIGNED_SHORT_5_5_5_1&&(ae=i.RGB5_A1)}return(ae===i.R16F||ae===i.R32F||ae===i.RG16F||ae===i.RG32F||ae===i.RGBA16F||ae===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ae}function w(L,T){let J;return L?T===null||T===Jn||T===vr?J=i.DEPTH24_STENCIL8:T===Vn?J=i.DEPTH32F_STENCIL8:T===Qr&&(J=i.DEPTH24_STENCIL8,et("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Jn||T===vr?J=i.DEPTH_COMPONENT24:T===Vn?J=i.DEPTH_COMPONENT32F:T===Qr&&(J=i.DEPTH_COMPONENT16),J}function D(L,T){return U(L)===!0||L.isFramebufferTexture&&L.minFilter!==cn&&L.minFilter!==Mn?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?T.mipmaps.length:1}function X(L){let T=new WeakRef(L);n.get(L).__ref=T,M.add(T),A.register(L,T,T)}function k(L){let T=n.get(L).__ref;T!==void 0&&(M.delete(T),A.unregister(T))}function Y(L){ee(L.target)}function Z(L){z(L.target)}function ee(L){L.removeEventListener("dispose",Y),k(L),G(L),L.isVideoTexture&&m.delete(L),L.isHTMLTexture&&v.delete(L)}function z(L){L.removeEventListener("dispose",Z),k(L),Se(L)}function ie(){for(let L of M){let T=L.deref();T!==void 0&&(T.isRenderTarget===!0?z(T):ee(T))}M.clear(),v.clear()}function G(L){let T=n.get(L);if(T.__webglInit===void 0)return;let J=L.source,ve=y.get(J);if(ve){let de=ve[T.__cacheKey];de.usedTimes--,de.usedTimes===0&&ne(L),Object.keys(ve).length===0&&y.delete(J)}n.remove(L)}function ne(L){let T=n.get(L);i.deleteTexture(T.__webglTexture);let J=L.source,ve=y.get(J);delete ve[T.__cacheKey],l.memory.textures--}function Se(L){let T=n.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let J=L.depthTexture;if(J&&J.renderTarget===L&&ee(J),L.isWebGLCubeRenderTarget)for(let de=0;de<6;de++){if(Array.isArray(T.__webglFramebuffer[de]))for(let pe=0;pe<T.__webglFramebuffer[de].length;pe++)i.deleteFramebuffer(T.__webglFramebuffer[de][pe]);else i.deleteFramebuffer(T.__webglFramebuffer[de]);T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer[de])}else{if(Array.isArray(T.__webglFramebuffer))for(let de=0;de<T.__webglFramebuffer.length;de++)i.deleteFramebuffer(T.__webglFramebuffer[de]);else i.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&i.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let de=0;de<T.__webglColorRenderbuffer.length;de++)T.__webglColorRenderbuffer[de]&&i.deleteRenderbuffer(T.__webglColorRenderbuffer[de]);T.__webglDepthRenderbuffer&&i.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ve=L.textures;for(let de=0,pe=ve.length;de<pe;de++){let Me=n.get(ve[de]);Me.__webglTexture&&(i.deleteTexture(Me.__webglTexture),l.memory.textures--),n.remove(ve[de])}n.remove(L)}let re=0;function H(){re=0}function ge(){return re}function We(L){re=L}function rt(){let L=re;return L>=r.maxTextures&&et("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+r.maxTextures),re+=1,L}function ue(L){let T=[];return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.join()}function Fe(L,T){let J=n.get(L);if(L.isVideoTexture&&$t(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&J.__version!==L.version){let ve=L.image;if(ve===null)et("WebGLRenderer: Texture marked for update but no image data found.");else if(ve.complete===!1)et("WebGLRenderer: Texture marked for update but image is incomplete");else{pt(J,L,T);return}}else L.isExternalTexture&&(J.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,J.__webglTexture,i.TEXTURE0+T)}function Pe(L,T){let J=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&J.__version!==L.version){pt(J,L,T);return}else L.isExternalTexture&&(J.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,J.__webglTexture,i.TEXTURE0+T)}function Ze(L,T){let J=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&J.__version!==L.version){pt(J,L,T);return}t.bindTexture(i.TEXTURE_3D,J.__webglTexture,i.TEXTURE0+T)}function Ue(L,T){let J=n.get(L);if(L.version>0&&J.__version!==L.version){It(J,L,T);return}t.bindTexture(i.TEXTURE_CUBE_MAP,J.__webglTexture,i.TEXTURE0+T)}let ot={[zr]:i.REPEAT,[li]:i.CLAMP_TO_EDGE,[bo]:i.MIRRORED_REPEAT},Vt={[cn]:i.NEAREST,[Fd]:i.NEAREST_MIPMAP_NEAREST,[ta]:i.NEAREST_MIPMAP_LINEAR,[Mn]:i.LINEAR,[Zo]:i.LINEAR_MIPMAP_NEAREST,[Pi]:i.LINEAR_MIPMAP_LINEAR},Qe={[Bd]:i.NEVER,[uh]:i.ALWAYS,[kd]:i.LESS,[ch]:i.LEQUAL,[zd]:i.EQUAL,[hh]:i.GEQUAL,[Gd]:i.GREATER,[Vd]:i.NOTEQUAL};function Et(L,T){if(T.type===Vn&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===Mn||T.magFilter===Zo||T.magFilter===ta||T.magFilter===Pi||T.minFilter===Mn||T.minFilter===Zo||T.minFilter===ta||T.minFilter===Pi)&&et("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,ot[T.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,ot[T.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,ot[T.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,Vt[T.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,Vt[T.minFilter]),T.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Qe[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===cn||T.minFilter!==ta&&T.minFilter!==Pi||T.type===Vn&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let J=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,r.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function Ct(L,T){let J=!1;L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",Y),X(T));let ve=T.source,de=y.get(ve);de===void 0&&(de={},y.set(ve,de));let pe=ue(T);if(pe!==L.__cacheKey){de[pe]===void 0&&(de[pe]={texture:i.createTexture(),usedTimes:0},l.memory.textures++,J=!0),de[pe].usedTimes++;let Me=de[L.__cacheKey];Me!==void 0&&(de[L.__cacheKey].usedTimes--,Me.usedTimes===0&&ne(T)),L.__cacheKey=pe,L.__webglTexture=de[pe].texture}return J}function mt(L,T,J){return Math.floor(Math.floor(L/J)/T)}function Ht(L,T,J,ve){let pe=L.updateRanges;if(pe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,T.width,T.height,J,ve,T.data);else{pe.sort((B,he)=>B.start-he.start);let Me=0;for(let B=1;B<pe.length;B++){let he=pe[Me],se=pe[B],Re=he.start+he.count,Ee=mt(se.start,T.width,4),Ae=mt(he.start,T.width,4);se.start<=Re+1&&Ee===Ae&&mt(se.start+se.count-1,T.width,4)===Ee?he.count=Math.max(he.count,se.start+se.count-he.start):(++Me,pe[Me]=se)}pe.length=Me+1;let ae=t.getParameter(i.UNPACK_ROW_LENGTH),le=t.getParameter(i.UNPACK_SKIP_PIXELS),Ce=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,T.width);for(let B=0,he=pe.length;B<he;B++){let se=pe[B],Re=Math.floor(se.start/4),Ee=Math.ceil(se.count/4),Ae=Re%T.width,Xe=Math.floor(Re/T.width),ut=Ee,we=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Xe,ut,we,J,ve,T.data)}L.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ae),t.pixelStorei(i.UNPACK_SKIP_PIXELS,le),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ce)}}function pt(L,T,J){let ve=i.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ve=i.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ve=i.TEXTURE_3D);let de=Ct(L,T),pe=T.source;t.bindTexture(ve,L.__webglTexture,i.TEXTURE0+J);let Me=n.get(pe);if(pe.version!==Me.__version||de===!0){if(t.activeTexture(i.TEXTURE0+J),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let we=St.getPrimaries(St.workingColorSpace),qe=T.colorSpace===Di?null:St.getPrimaries(T.colorSpace),dt=T.colorSpace===Di||we===qe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,dt)}t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment);let le=P(T.image,!1,r.maxTextureSize);le=Je(T,le);let Ce=a.convert(T.format,T.colorSpace),B=a.convert(T.type),he=N(T.internalFormat,Ce,B,T.normalized,T.colorSpace,T.isVideoTexture);Et(ve,T);let se,Re=T.mipmaps,Ee=T.isVideoTexture!==!0,Ae=Me.__version===void 0||de===!0,Xe=pe.dataReady,ut=D(T,le);if(T.isDepthTexture)he=w(T.format===Ii,T.type),Ae&&(Ee?t.texStorage2D(i.TEXTURE_2D,1,he,le.width,le.height):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Ce,B,null));else if(T.isDataTexture)if(Re.length>0){Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Re[0].width,Re[0].height);for(let we=0,qe=Re.length;we<qe;we++)se=Re[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Ce,B,se.data);T.generateMipmaps=!1}else Ee?(Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height),Xe&&Ht(T,le,Ce,B)):t.texImage2D(i.TEXTURE_2D,0,he,le.width,le.height,0,Ce,B,le.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){Ee&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,Re[0].width,Re[0].height,le.depth);for(let we=0,qe=Re.length;we<qe;we++)if(se=Re[we],T.format!==Qn)if(Ce!==null)if(Ee){if(Xe)if(T.layerUpdates.size>0){let dt=Sh(se.width,se.height,T.format,T.type);for(let Oe of T.layerUpdates){let Tt=se.data.subarray(Oe*dt/se.data.BYTES_PER_ELEMENT,(Oe+1)*dt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,Oe,se.width,se.height,1,Ce,Tt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Ce,se.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,se.data,0,0);else et("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ee?Xe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,se.width,se.height,le.depth,Ce,B,se.data):t.texImage3D(i.TEXTURE_2D_ARRAY,we,he,se.width,se.height,le.depth,0,Ce,B,se.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{Ee&&Ae&&t.texStorage2D(i.TEXTURE_2D,ut,he,Re[0].width,Re[0].height);for(let we=0,qe=Re.length;we<qe;we++)se=Re[we],T.format!==Qn?Ce!==null?Ee?Xe&&t.compressedTexSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,se.data):t.compressedTexImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,se.data):et("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,se.width,se.height,Ce,B,se.data):t.texImage2D(i.TEXTURE_2D,we,he,se.width,se.height,0,Ce,B,se.data)}else if(T.isDataArrayTexture)if(Ee){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ut,he,le.width,le.height,le.depth),Xe)if(T.layerUpdates.size>0){let we=Sh(le.width,le.height,T.format,T.type);for(let qe of T.layerUpdates){let dt=le.data.subarray(qe*we/le.data.BYTES_PER_ELEMENT,(qe+1)*we/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,qe,le.width,le.height,1,Ce,B,dt)}T.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,Ce,B,le.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,he,le.width,le.height,le.depth,0,Ce,B,le.data);else if(T.isData3DTexture)Ee?(Ae&&t.texStorage3D(i.TEXTURE_3D,ut,he,le.width,le.height,le.depth),Xe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,Ce,B,le.data)):t.texImage3D(i.TEXTURE_3D,0,he,le.width,le.height,le.depth,0,Ce,B,le.data);else if(T.isFramebufferTexture){if(Ae)if(Ee)t.texStorage2D(i.TEXTURE_2D,ut,he,le.width,le.height);else{let we=le.width,qe=le.height;for(let dt=0;dt<ut;dt++)t.texImage2D(i.TEXTURE_2D,dt,he,we,qe,0,Ce,B,null),we>>=1,qe>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in i){let we=i.canvas;if(we.hasAttribute("layoutsubtree")||we.setAttribute("layoutsubtree","true"),le.parentNode!==we){we.appendChild(le),v.add(T),we.onpaint=qe=>{let dt=qe.changedElements;for(let Oe of v)dt.includes(Oe.image)&&(Oe.needsUpdate=!0)},we.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,le);else{let dt=i.RGBA,Oe=i.RGBA,Tt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,dt,Oe,Tt,le)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(Ee&&Ae){let we=Ke(Re[0]);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}for(let we=0,qe=Re.length;we<qe;we++)se=Re[we],Ee?Xe&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,Ce,B,se):t.texImage2D(i.TEXTURE_2D,we,he,Ce,B,se);T.generateMipmaps=!1}else if(Ee){if(Ae){let we=Ke(le);t.texStorage2D(i.TEXTURE_2D,ut,he,we.width,we.height)}Xe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Ce,B,le)}else t.texImage2D(i.TEXTURE_2D,0,he,Ce,B,le);U(T)&&T.mipmapsAutoUpdate===!0&&I(ve),Me.__version=pe.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function It(L,T,J){if(T.image.length!==6)return;let ve=Ct(L,T),de=T.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+J);let pe=n.get(de);if(de.version!==pe.__version||ve===!0){t.activeTexture(i.TEXTURE0+J);let Me=St.getPrimaries(St.workingColorSpace),ae=T.colorSpace===Di?null:St.getPrimaries(T.colorSpace),le=T.colorSpace===Di||Me===ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,le);let Ce=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,he=[];for(let Oe=0;Oe<6;Oe++)!Ce&&!B?he[Oe]=P(T.image[Oe],!0,r.maxCubemapSize):he[Oe]=B?T.image[Oe].image:T.image[Oe],he[Oe]=Je(T,he[Oe]);let se=he[0],Re=a.convert(T.format,T.colorSpace),Ee=a.convert(T.type),Ae=N(T.internalFormat,Re,Ee,T.normalized,T.colorSpace),Xe=T.isVideoTexture!==!0,ut=pe.__version===void 0||ve===!0,we=de.dataReady,qe=D(T,se);Et(i.TEXTURE_CUBE_MAP,T);let dt;if(T.isDepthTexture){if(Ae=w(T.format===Ii,T.type),ut)if(Xe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,se.width,se.height);else for(let Oe=0;Oe<6;Oe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,se.width,se.height,0,Re,Ee,null)}else if(Ce){Xe&&ut&&t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ae,se.width,se.height);for(let Oe=0;Oe<6;Oe++){dt=he[Oe].mipmaps;for(let Tt=0;Tt<dt.length;Tt++){let Bt=dt[Tt];T.format!==Qn?Re!==null?Xe?we&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Bt.width,Bt.height,Re,Bt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Bt.width,Bt.height,0,Bt.data):et("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,0,0,Bt.width,Bt.height,Re,Ee,Bt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt,Ae,Bt.width,Bt.height,0,Re,Ee,Bt.data)}}}else{if(dt=T.mipmaps,Xe&&ut){dt.length>0&&qe++;let Oe=Ke(he[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ae,Oe.width,Oe.height)}for(let Oe=0;Oe<6;Oe++)if(B){Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,he[Oe].width,he[Oe].height,Re,Ee,he[Oe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,he[Oe].width,he[Oe].height,0,Re,Ee,he[Oe].data);for(let Tt=0;Tt<dt.length;Tt++){let vi=dt[Tt].image[Oe].image;Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,vi.width,vi.height,Re,Ee,vi.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,vi.width,vi.height,0,Re,Ee,vi.data)}}else{Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,0,0,Re,Ee,he[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,0,Ae,Re,Ee,he[Oe]);for(let Tt=0;Tt<dt.length;Tt++){let Bt=dt[Tt];Xe?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,0,0,Re,Ee,Bt.image[Oe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Oe,Tt+1,Ae,Re,Ee,Bt.image[Oe])}}}U(T)&&T.mipmapsAutoUpdate===!0&&I(i.TEXTURE_CUBE_MAP),pe.__version=de.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Mt(L,T,J,ve,de,pe){let Me=a.convert(J.format,J.colorSpace),ae=a.convert(J.type),le=N(J.internalFormat,Me,ae,J.normalized,J.colorSpace),Ce=n.get(T),B=n.get(J);if(B.__renderTarget=T,!Ce.__hasExternalTextures){let he=Math.max(1,T.width>>pe),se=Math.max(1,T.height>>pe);de===i.TEXTURE_3D||de===i.TEXTURE_2D_ARRAY?t.texImage3D(de,pe,le,he,se,T.depth,0,Me,ae,null):t.texImage2D(de,pe,le,he,se,0,Me,ae,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),Le(T)?c.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,de,B.__webglTexture,0,Ut(T)):(de===i.TEXTURE_2D||de>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&de<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ve,de,B.__webglTexture,pe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(L,T,J){if(i.bindRenderbuffer(i.RENDERBUFFER,L),T.depthBuffer){let ve=T.depthTexture,de=ve&&ve.isDepthTexture?ve.type:null,pe=w(T.stencilBuffer,de),Me=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Le(T)?c.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):J?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),pe,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,pe,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Me,i.RENDERBUFFER,L)}else{let ve=T.textures;for(let de=0;de<ve.length;de++){let pe=ve[de],Me=a.convert(pe.format,pe.colorSpace),ae=a.convert(pe.type),le=N(pe.internalFormat,Me,ae,pe.normalized,pe.colorSpace);Le(T)?c.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(T),le,T.width,T.height):J?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(T),le,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,le,T.width,T.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function De(L,T,J){let ve=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let de=n.get(T.depthTexture);de.__renderTarget=T;let pe=ve?T.depthTexture.image[0]:T.depthTexture.image;(!de.__webglTexture||pe.width!==T.width||pe.height!==T.height)&&(pe.width=T.width,pe.height=T.height,T.depthTexture.needsUpdate=!0),ve?Ue(T.depthTexture,0):Fe(T.depthTexture,0);let Me=de.__webglTexture,ae=Ut(T),le=ve?i.TEXTURE_CUBE_MAP_POSITIVE_X+J:i.TEXTURE_2D,Ce=T.depthTexture.format===Ii?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(T.depthTexture.format===Ti)Le(T)?c.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Ce,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Ce,le,Me,0);else if(T.depthTexture.format===Ii)Le(T)?c.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Ce,le,Me,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Ce,le,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function $e(L){let T=n.get(L),J=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==L.depthTexture){let ve=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ve){let de=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ve.removeEventListener("dispose",de)};ve.addEventListener("dispose",de),T.__depthDisposeCallback=de}T.__boundDepthTexture=ve}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)if(J)for(let ve=0;ve<6;ve++)De(T.__webglFramebuffer[ve],L,ve);else L.texture.mipmaps.length>0?De(T.__webglFramebuffer[0],L,0):De(T.__webglFramebuffer,L,0);else if(J){T.__webglDepthbuffer=[];for(let ve=0;ve<6;ve++)if(t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[ve]),T.__webglDepthbuffer[ve]===void 0)T.__webglDepthbuffer[ve]=i.createRenderbuffer(),rn(T.__webglDepthbuffer[ve],L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer[ve];i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=i.createRenderbuffer(),rn(T.__webglDepthbuffer,L,!1);else{let de=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=T.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,pe),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,pe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function hn(L,T,J){let ve=n.get(L);T!==void 0&&Mt(ve.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),J!==void 0&&$e(L)}function sn(L){let T=L.texture,J=n.get(L),ve=n.get(T);L.addEventListener("dispose",Z),X(L);let de=L.textures,pe=L.isWebGLCubeRenderTarget===!0,Me=de.length>1;if(Me||(ve.__webglTexture===void 0&&(ve.__webglTexture=i.createTexture()),ve.__version=T.version,l.memory.textures++),pe){J.__webglFramebuffer=[];for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0){J.__webglFramebuffer[ae]=[];for(let le=0;le<T.mipmaps.length;le++)J.__webglFramebuffer[ae][le]=i.createFramebuffer()}else J.__webglFramebuffer[ae]=i.createFramebuffer()}else{if(T.mipmaps.length>0){J.__webglFramebuffer=[];for(let ae=0;ae<T.mipmaps.length;ae++)J.__webglFramebuffer[ae]=i.createFramebuffer()}else J.__webglFramebuffer=i.createFramebuffer();if(Me)for(let ae=0,le=de.length;ae<le;ae++){let Ce=n.get(de[ae]);Ce.__webglTexture===void 0&&(Ce.__webglTexture=i.createTexture(),l.memory.textures++)}if(L.samples>0&&Le(L)===!1){J.__webglMultisampledFramebuffer=i.createFramebuffer(),J.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let ae=0;ae<de.length;ae++){let le=de[ae];J.__webglColorRenderbuffer[ae]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,J.__webglColorRenderbuffer[ae]);let Ce=a.convert(le.format,le.colorSpace),B=a.convert(le.type),he=N(le.internalFormat,Ce,B,le.normalized,le.colorSpace,L.isXRRenderTarget===!0),se=Ut(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,se,he,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,J.__webglColorRenderbuffer[ae])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(J.__webglDepthRenderbuffer=i.createRenderbuffer(),rn(J.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(pe){t.bindTexture(i.TEXTURE_CUBE_MAP,ve.__webglTexture),Et(i.TEXTURE_CUBE_MAP,T);for(let ae=0;ae<6;ae++)if(T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(J.__webglFramebuffer[ae][le],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,le);else Mt(J.__webglFramebuffer[ae],L,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0);U(T)?I(i.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let ae=0,le=de.length;ae<le;ae++){let Ce=de[ae],B=n.get(Ce),he=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(he=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(he,B.__webglTexture),Et(he,Ce),Mt(J.__webglFramebuffer,L,Ce,i.COLOR_ATTACHMENT0+ae,he,0),U(Ce)&&I(he)}t.unbindTexture()}else{let ae=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ae=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,ve.__webglTexture),Et(ae,T),T.mipmaps.length>0)for(let le=0;le<T.mipmaps.length;le++)Mt(J.__webglFramebuffer[le],L,T,i.COLOR_ATTACHMENT0,ae,le);else Mt(J.__webglFramebuffer,L,T,i.COLOR_ATTACHMENT0,ae,0);U(T)?I(ae):T.mipmaps.length>0&&i.texParameteri(ae,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&$e(L)}function W(L){let T=L.textures;for(let J=0,ve=T.length;J<ve;J++){let de=T[J];if(U(de)&&de.mipmapsAutoUpdate===!0){let pe=O(L),Me=n.get(de).__webglTexture;t.bindTexture(pe,Me),I(pe),t.unbindTexture()}}}let yn=[];function Rt(L){if(L.samples>0){if(Le(L)===!1){let T=L.textures,J=L.width,ve=L.height,de=i.COLOR_BUFFER_BIT,pe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=n.get(L),ae=T.length>1;if(ae)for(let Ce=0;Ce<T.length;Ce++)t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let Ce=0;Ce<T.length;Ce++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(de|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(de|=i.STENCIL_BUFFER_BIT)),ae){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Ce]);let B=n.get(T[Ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,J,ve,0,0,J,ve,de,i.NEAREST),f===!0&&(yn.length=0,yn.push(i.COLOR_ATTACHMENT0+Ce),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&yn.push(pe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,yn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ae)for(let Ce=0;Ce<T.length;Ce++){t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,Me.__webglColorRenderbuffer[Ce]);let B=n.get(T[Ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&f){let T=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[T])}}}function Ut(L){return Math.min(r.maxSamples,L.samples)}function Le(L){let T=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function $t(L){let T=l.render.frame;m.get(L)!==T&&(m.set(L,T),L.update())}function Je(L,T){let J=L.colorSpace,ve=L.format,de=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||J!==Ts&&J!==Di&&(St.getTransfer(J)===Pt?(ve!==Qn||de!==An)&&et("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",J)),T}function Ke(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(u.width=L.naturalWidth||L.width,u.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(u.width=L.displayWidth,u.height=L.displayHeight):(u.width=L.width,u.height=L.height),u}this.allocateTextureUnit=rt,this.resetTextureUnits=H,this.getTextureUnits=ge,this.setTextureUnits=We,this.setTexture2D=Fe,this.setTexture2DArray=Pe,this.setTexture3D=Ze,this.setTextureCube=Ue,this.rebindTextures=hn,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=Rt,this.setupDepthRenderbuffer=$e,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=Le,this.dispose=ie}function kb(i,e){function t(n,r=Di){let a,l=St.getTransfer(r);if(n===An)return i.UNSIGNED_BYTE;if(n===Ko)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Qo)return i.UNSIGNED_SHORT_5_5_5_1;if(n===sh)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===ah)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ih)return i.BYTE;if(n===rh)return i.SHORT;if(n===Qr)return i.UNSIGNED_SHORT;if(n===Jo)return i.INT;if(n===Jn)return i.UNSIGNED_INT;if(n===Vn)return i.FLOAT;if(n===Kn)return i.HALF_FLOAT;if(n===oh)return i.ALPHA;if(n===lh)return i.RGB;if(n===Qn)return i.RGBA;if(n===Ti)return i.DEPTH_COMPONENT;if(n===Ii)return i.DEPTH_STENCIL;if(n===el)return i.RED;if(n===tl)return i.RED_INTEGER;if(n===Ki)return i.RG;if(n===nl)return i.RG_INTEGER;if(n===il)return i.RGBA_INTEGER;if(n===na||n===ia||n===ra||n===sa)if(l===Pt)if(a=e.get("WEBGL_compressed_texture_s3tc_srgb"),a!==null){if(n===na)return a.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ia)return a.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ra)return a.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===sa)return a.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(a=e.get("WEBGL_compressed_texture_s3tc"),a!==null){if(n===na)return a.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ia)return a.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ra)return a.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===sa)return a.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===rl||n===sl||n===al||n===ol)if(a=e.get("WEBGL_compressed_texture_pvrtc"),a!==null){if(n===rl)return a.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===sl)return a.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===al)return a.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ol)return a.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ll||n===cl||n===hl||n===ul||n===dl||n===aa||n===fl)if(a=e.get("WEBGL_compressed_texture_etc"),a!==null){if(n===ll||n===cl)return l===Pt?a.COMPRESSED_SRGB8_ETC2:a.COMPRESSED_RGB8_ETC2;if(n===hl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:a.COMPRESSED_RGBA8_ETC2_EAC;if(n===ul)return a.COMPRESSED_R11_EAC;if(n===dl)return a.COMPRESSED_SIGNED_R11_EAC;if(n===aa)return a.COMPRESSED_RG11_EAC;if(n===fl)return a.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===pl||n===ml||n===gl||n===_l||n===vl||n===yl||n===xl||n===Sl||n===Ml||n===bl||n===wl||n===El||n===Tl||n===Al)if(a=e.get("WEBGL_compressed_texture_astc"),a!==null){if(n===pl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:a.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ml)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:a.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===gl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:a.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===_l)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:a.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===vl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:a.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===yl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:a.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===xl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:a.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Sl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:a.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ml)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:a.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===bl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:a.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===wl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:a.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===El)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:a.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Tl)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:a.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Al)return l===Pt?a.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:a.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Cl||n===Rl||n===Pl)if(a=e.get("EXT_texture_compression_bptc"),a!==null){if(n===Cl)return l===Pt?a.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:a.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Rl)return a.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Pl)return a.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Il||n===Dl||n===oa||n===Ll)if(a=e.get("EXT_texture_compression_rgtc"),a!==null){if(n===Il)return a.COMPRESSED_RED_RGTC1_EXT;if(n===Dl)return a.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===oa)return a.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Ll)return a.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===vr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var zb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Gb=`
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

}`,Ph=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Gs(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new fi({vertexShader:zb,fragmentShader:Gb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ot(new Xi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ih=class extends Zn{constructor(e,t){super();let n=this,r=null,a=1,l=null,c="local-floor",f=1,u=null,m=null,v=null,g=null,y=null,M=null,A=typeof XRWebGLBinding<"u",S=new Ph,_={},P=t.getContextAttributes(),U=null,I=null,O=[],N=[],w=new tt,D=null,X=null,k=new _n;k.viewport=new Gt;let Y=new _n;Y.viewport=new Gt;let Z=[k,Y],ee=new $o,z=null,ie=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new $r,O[ue]=Fe),Fe.getTargetRaySpace()},this.getControllerGrip=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new $r,O[ue]=Fe),Fe.getGripSpace()},this.getHand=function(ue){let Fe=O[ue];return Fe===void 0&&(Fe=new $r,O[ue]=Fe),Fe.getHandSpace()};function G(ue){let Fe=N.indexOf(ue.inputSource);if(Fe===-1)return;let Pe=O[Fe];Pe!==void 0&&(Pe.update(ue.inputSource,ue.frame,u||l),Pe.dispatchEvent({type:ue.type,data:ue.inputSource}))}function ne(){r.removeEventListener("select",G),r.removeEventListener("selectstart",G),r.removeEventListener("selectend",G),r.removeEventListener("squeeze",G),r.removeEventListener("squeezestart",G),r.removeEventListener("squeezeend",G),r.removeEventListener("end",ne),r.removeEventListener("inputsourceschange",Se);for(let ue=0;ue<O.length;ue++){let Fe=N[ue];Fe!==null&&(N[ue]=null,O[ue].disconnect(Fe))}z=null,ie=null,S.reset();for(let ue in _)delete _[ue];if(e.setRenderTarget(U),y=null,g=null,v=null,r=null,I=null,rt.stop(),n.isPresenting=!1,e.setPixelRatio(D),e.setSize(w.width,w.height,!1),X!==null){let ue=X.camera;ue.fov=X.fov,ue.zoom=X.zoom,ue.updateProjectionMatrix(),X=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ue){a=ue,n.isPresenting===!0&&et("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ue){c=ue,n.isPresenting===!0&&et("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return u||l},this.setReferenceSpace=function(ue){u=ue},this.getBaseLayer=function(){return g!==null?g:y},this.getBinding=function(){return v===null&&A&&(v=new XRWebGLBinding(r,t)),v},this.getFrame=function(){return M},this.getSession=function(){return r},this.setSession=async function(ue){if(r=ue,r!==null){if(U=e.getRenderTarget(),r.addEventListener("select",G),r.addEventListener("selectstart",G),r.addEventListener("selectend",G),r.addEventListener("squeeze",G),r.addEventListener("squeezestart",G),r.addEventListener("squeezeend",G),r.addEventListener("end",ne),r.addEventListener("inputsourceschange",Se),P.xrCompatible!==!0&&await t.makeXRCompatible(),D=e.getPixelRatio(),e.getSize(w),A&&"createProjectionLayer"in XRWebGLBinding.prototype){let Pe=null,Ze=null,Ue=null;P.depth&&(Ue=P.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Pe=P.stencil?Ii:Ti,Ze=P.stencil?vr:Jn);let ot={colorFormat:t.RGBA8,depthFormat:Ue,scaleFactor:a};v=this.getBinding(),g=v.createProjectionLayer(ot),r.updateRenderState({layers:[g]}),e.setPixelRatio(1),e.setSize(g.textureWidth,g.textureHeight,!1),I=new Fn(g.textureWidth,g.textureHeight,{format:Qn,type:An,depthTexture:new Ci(g.textureWidth,g.textureHeight,Ze,void 0,void 0,void 0,void 0,void 0,void 0,Pe),stencilBuffer:P.stencil,colorSpace:e.outputColorSpace,samples:P.antialias?4:0,resolveDepthBuffer:g.ignoreDepthValues===!1,resolveStencilBuffer:g.ignoreDepthValues===!1,storeMultisampledDepthBuffer:g.ignoreDepthValues===!1,storeMultisampledStencilBuffer:g.ignoreDepthValues===!1})}else{let Pe={antialias:P.antialias,alpha:!0,depth:P.depth,stencil:P.stencil,framebufferScaleFactor:a};y=new XRWebGLLayer(r,t,Pe),r.updateRenderState({baseLayer:y}),e.setPixelRatio(1),e.setSize(y.framebufferWidth,y.framebufferHeight,!1),I=new Fn(y.framebufferWidth,y.framebufferHeight,{format:Qn,type:An,colorSpace:e.outputColorSpace,stencilBuffer:P.stencil,resolveDepthBuffer:y.ignoreDepthValues===!1,resolveStencilBuffer:y.ignoreDepthValues===!1,storeMultisampledDepthBuffer:y.ignoreDepthValues===!1,storeMultisampledStencilBuffer:y.ignoreDepthValues===!1})}I.isXRRenderTarget=!0,this.setFoveation(f),u=null,l=await r.requestReferenceSpace(c),rt.setContext(r),rt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return S.getDepthTexture()};function Se(ue){for(let Fe=0;Fe<ue.removed.length;Fe++){let Pe=ue.removed[Fe],Ze=N.indexOf(Pe);Ze>=0&&(N[Ze]=null,O[Ze].disconnect(Pe))}for(let Fe=0;Fe<ue.added.length;Fe++){let Pe=ue.added[Fe],Ze=N.indexOf(Pe);if(Ze===-1){for(let ot=0;ot<O.length;ot++)if(ot>=N.length){N.push(Pe),Ze=ot;break}else if(N[ot]===null){N[ot]=Pe,Ze=ot;break}if(Ze===-1)break}let Ue=O[Ze];Ue&&Ue.connect(Pe)}}function re(ue,Fe){Fe===null?ue.matrixWorld.copy(ue.matrix):ue.matrixWorld.multiplyMatrices(Fe.matrixWorld,ue.matrix),ue.matrixWorldInverse.copy(ue.matrixWorld).invert()}this.updateCamera=function(ue){if(r===null)return;let Fe=ue.near,Pe=ue.far;S.texture!==null&&(S.depthNear>0&&(Fe=S.depthNear),S.depthFar>0&&(Pe=S.depthFar)),ee.near=Y.near=k.near=Fe,ee.far=Y.far=k.far=Pe,(z!==ee.near||ie!==ee.far)&&(r.updateRenderState({depthNear:ee.near,depthFar:ee.far}),z=ee.near,ie=ee.far),ee.layers.mask=ue.layers.mask|6,k.layers.mask=ee.layers.mask&-5,Y.layers.mask=ee.layers.mask&-3;let Ze=ue.parent,Ue=ee.cameras;re(ee,Ze);for(let ot=0;ot<Ue.length;ot++)re(Ue[ot],Ze);ee.projectionMatrix.copy(k.projectionMatrix),ee.projectionMatrixInverse.copy(k.projectionMatrixInverse),X===null&&ue.isPerspectiveCamera&&(X={camera:ue,fov:ue.fov,zoom:ue.zoom}),H(ue,ee,Ze)};function H(ue,Fe,Pe){Pe===null?ue.matrix.copy(Fe.matrixWorld):(ue.matrix.copy(Pe.matrixWorld),ue.matrix.invert(),ue.matrix.multiply(Fe.matrixWorld)),ue.matrix.decompose(ue.position,ue.quaternion,ue.scale),ue.updateMatrixWorld(!0),ue.projectionMatrix.copy(Fe.projectionMatrix),ue.projectionMatrixInverse.copy(Fe.projectionMatrixInverse),ue.isPerspectiveCamera&&(ue.fov=Hr*2*Math.atan(1/ue.projectionMatrix.elements[5]),ue.zoom=1)}this.getCamera=function(){return ee},this.getFoveation=function(){if(!(g===null&&y===null))return f},this.setFoveation=function(ue){f=ue,g!==null&&(g.fixedFoveation=ue),y!==null&&y.fixedFoveation!==void 0&&(y.fixedFoveation=ue)},this.hasDepthSensing=function(){return S.texture!==null},this.getDepthSensingMesh=function(){return S.getMesh(ee)},this.getCameraTexture=function(ue){return _[ue]};let ge=null;function We(ue,Fe){if(m=Fe.getViewerPose(u||l),M=Fe,m!==null){let Pe=m.views;y!==null&&(e.setRenderTargetFramebuffer(I,y.framebuffer),e.setRenderTarget(I));let Ze=!1;Pe.length!==ee.cameras.length&&(ee.cameras.length=0,Ze=!0);for(let Qe=0;Qe<Pe.length;Qe++){let Et=Pe[Qe],Ct=null;if(y!==null)Ct=y.getViewport(Et);else{let Ht=v.getViewSubImage(g,Et);Ct=Ht.viewport,Qe===0&&(e.setRenderTargetTextures(I,Ht.colorTexture,Ht.depthStencilTexture),e.setRenderTarget(I))}let mt=Z[Qe];mt===void 0&&(mt=new _n,mt.layers.enable(Qe),mt.viewport=new Gt,Z[Qe]=mt),mt.matrix.fromArray(Et.transform.matrix),mt.matrix.decompose(mt.position,mt.quaternion,mt.scale),mt.projectionMatrix.fromArray(Et.projectionMatrix),mt.projectionMatrixInverse.copy(mt.projectionMatrix).invert(),mt.viewport.set(Ct.x,Ct.y,Ct.width,Ct.height),Qe===0&&(ee.matrix.copy(mt.matrix),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale)),Ze===!0&&ee.cameras.push(mt)}let Ue=r.enabledFeatures;if(Ue&&Ue.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&A){v=n.getBinding();let Qe=v.getDepthInformation(Pe[0]);Qe&&Qe.isValid&&Qe.texture&&S.init(Qe,r.renderState)}if(Ue&&Ue.includes("camera-access")&&A){e.state.unbindTexture(),v=n.getBinding();for(let Qe=0;Qe<Pe.length;Qe++){let Et=Pe[Qe].camera;if(Et){let Ct=_[Et];Ct||(Ct=new Gs,_[Et]=Ct);let mt=v.getCameraImage(Et);Ct.sourceTexture=mt}}}}for(let Pe=0;Pe<O.length;Pe++){let Ze=N[Pe],Ue=O[Pe];Ze!==null&&Ue!==void 0&&Ue.update(Ze,Fe,u||l)}ge&&ge(ue,Fe),Fe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Fe}),M=null}let rt=new Mf;rt.setAnimationLoop(We),this.setAnimationLoop=function(ue){ge=ue},this.dispose=function(){}}},Vb=new Lt,Df=new ct;Df.set(-1,0,0,0,1,0,0,0,1);function Hb(i,e){function t(S,_){S.matrixAutoUpdate===!0&&S.updateMatrix(),_.value.copy(S.matrix)}function n(S,_){_.color.getRGB(S.fogColor.value,vh(i)),_.isFog?(S.fogNear.value=_.near,S.fogFar.value=_.far):_.isFogExp2&&(S.fogDensity.value=_.density)}function r(S,_,P,U,I){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?a(S,_):_.isMeshLambertMaterial?(a(S,_),_.envMap&&(S.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(a(S,_),v(S,_)):_.isMeshPhongMaterial?(a(S,_),m(S,_),_.envMap&&(S.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(a(S,_),g(S,_),_.isMeshPhysicalMaterial&&y(S,_,I)):_.isMeshMatcapMaterial?(a(S,_),M(S,_)):_.isMeshDepthMaterial?a(S,_):_.isMeshDistanceMaterial?(a(S,_),A(S,_)):_.isMeshNormalMaterial?a(S,_):_.isLineBasicMaterial?(l(S,_),_.isLineDashedMaterial&&c(S,_)):_.isPointsMaterial?f(S,_,P,U):_.isSpriteMaterial?u(S,_):_.isShadowMaterial?(S.color.value.copy(_.color),S.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function a(S,_){S.opacity.value=_.opacity,_.color&&S.diffuse.value.copy(_.color),_.emissive&&S.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(S.map.value=_.map,t(_.map,S.mapTransform)),_.alphaMap&&(S.alphaMap.value=_.alphaMap,t(_.alphaMap,S.alphaMapTransform)),_.bumpMap&&(S.bumpMap.value=_.bumpMap,t(_.bumpMap,S.bumpMapTransform),S.bumpScale.value=_.bumpScale,_.side===dn&&(S.bumpScale.value*=-1)),_.normalMap&&(S.normalMap.value=_.normalMap,t(_.normalMap,S.normalMapTransform),S.normalScale.value.copy(_.normalScale),_.side===dn&&S.normalScale.value.negate()),_.displacementMap&&(S.displacementMap.value=_.displacementMap,t(_.displacementMap,S.displacementMapTransform),S.displacementScale.value=_.displacementScale,S.displacementBias.value=_.displacementBias),_.emissiveMap&&(S.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,S.emissiveMapTransform)),_.specularMap&&(S.specularMap.value=_.specularMap,t(_.specularMap,S.specularMapTransform)),_.alphaTest>0&&(S.alphaTest.value=_.alphaTest);let P=e.get(_),U=P.envMap,I=P.envMapRotation;U&&(S.envMap.value=U,S.envMapRotation.value.setFromMatrix4(Vb.makeRotationFromEuler(I)).transpose(),U.isCubeTexture&&U.isRenderTargetTexture===!1&&S.envMapRotation.value.premultiply(Df),S.reflectivity.value=_.reflectivity,S.ior.value=_.ior,S.refractionRatio.value=_.refractionRatio),_.lightMap&&(S.lightMap.value=_.lightMap,S.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,S.lightMapTransform)),_.aoMap&&(S.aoMap.value=_.aoMap,S.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,S.aoMapTransform))}function l(S,_){S.diffuse.value.copy(_.color),S.opacity.value=_.opacity,_.map&&(S.map.value=_.map,t(_.map,S.mapTransform))}function c(S,_){S.dashSize.value=_.dashSize,S.totalSize.value=_.dashSize+_.gapSize,S.scale.value=_.scale}function f(S,_,P,U){S.diffuse.value.copy(_.color),S.opacity.value=_.opacity,S.size.value=_.size*P,S.scale.value=U*.5,_.map&&(S.map.value=_.map,t(_.map,S.uvTransform)),_.alphaMap&&(S.alphaMap.value=_.alphaMap,t(_.alphaMap,S.alphaMapTransform)),_.alphaTest>0&&(S.alphaTest.value=_.alphaTest)}function u(S,_){S.diffuse.value.copy(_.color),S.opacity.value=_.opacity,S.rotation.value=_.rotation,_.map&&(S.map.value=_.map,t(_.map,S.mapTransform)),_.alphaMap&&(S.alphaMap.value=_.alphaMap,t(_.alphaMap,S.alphaMapTransform)),_.alphaTest>0&&(S.alphaTest.value=_.alphaTest)}function m(S,_){S.specular.value.copy(_.specular),S.shininess.value=Math.max(_.shininess,1e-4)}function v(S,_){_.gradientMap&&(S.gradientMap.value=_.gradientMap)}function g(S,_){S.metalness.value=_.metalness,_.metalnessMap&&(S.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,S.metalnessMapTransform)),S.roughness.value=_.roughness,_.roughnessMap&&(S.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,S.roughnessMapTransform)),_.envMap&&(S.envMapIntensity.value=_.envMapIntensity)}function y(S,_,P){S.ior.value=_.ior,_.diffuseRoughness>0&&(S.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(S.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,S.diffuseRoughnessMapTransform))),_.sheen>0&&(S.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),S.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(S.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,S.sheenColorMapTransform)),_.sheenRoughnessMap&&(S.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,S.sheenRoughnessMapTransform))),_.clearcoat>0&&(S.clearcoat.value=_.clearcoat,S.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(S.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,S.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(S.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,S.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(S.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,S.clearcoatNormalMapTransform),S.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===dn&&S.clearcoatNormalScale.value.negate())),_.dispersion>0&&(S.dispersion.value=_.dispersion),_.retroreflectivity>0&&(S.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(S.iridescence.value=_.iridescence,S.iridescenceIOR.value=_.iridescenceIOR,S.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,S.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(S.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,S.iridescenceMapTransform)),_.iridescenceThicknessMap&&(S.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,S.iridescenceThicknessMapTransform))),_.transmission>0&&(S.transmission.value=_.transmission,S.transmissionSamplerMap.value=P.texture,S.transmissionSamplerSize.value.set(P.width,P.height),_.transmissionMap&&(S.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,S.transmissionMapTransform)),S.thickness.value=_.thickness,_.thicknessMap&&(S.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,S.thicknessMapTransform)),S.attenuationDistance.value=_.attenuationDistance,S.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(S.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(S.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,S.anisotropyMapTransform))),S.specularIntensity.value=_.specularIntensity,S.specularColor.value.copy(_.specularColor),_.specularColorMap&&(S.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,S.specularColorMapTransform)),_.specularIntensityMap&&(S.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,S.specularIntensityMapTransform))}function M(S,_){_.matcap&&(S.matcap.value=_.matcap)}function A(S,_){let P=e.get(_).light;S.referencePosition.value.setFromMatrixPosition(P.matrixWorld),S.nearDistance.value=P.shadow.camera.near,S.farDistance.value=P.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function Wb(i,e,t,n){let r={},a={};function l(P,U){let I=U.program;n.uniformBlockBinding(P,I,r[P.id])}function c(P,U){let I=r[P.id];I===void 0&&(M(P),I=f(P),r[P.id]=I,P.addEventListener("dispose",S));let O=U.program;n.updateUBOMapping(P,O);let N=e.render.frame;a[P.id]!==N&&(u(P),a[P.id]=N)}function f(P){let U=i.createBuffer(),I=P.__size,O=P.usage;return i.bindBuffer(i.UNIFORM_BUFFER,U),i.bufferData(i.UNIFORM_BUFFER,I,O),i.bindBuffer(i.UNIFORM_BUFFER,null),U}function u(P){let U=r[P.id],I=P.uniforms,O=P.__cache;i.bindBuffer(i.UNIFORM_BUFFER,U);for(let N=0,w=I.length;N<w;N++){let D=I[N];if(Array.isArray(D))for(let X=0,k=D.length;X<k;X++)m(D[X],N,X,O);else m(D,N,0,O)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(P,U,I,O){if(g(P,U,I,O)===!0){let N=P.__offset,w=P.value;if(Array.isArray(w)){let D=0;for(let X=0;X<w.length;X++){let k=w[X],Y=A(k,!0);v(k,P.__data,D),D+=Y.storage/Float32Array.BYTES_PER_ELEMENT}}else v(w,P.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,N,P.__data)}}function v(P,U,I){typeof P=="number"||typeof P=="boolean"?U[I]=P:P.isMatrix3?(U[I]=P.elements[0],U[I+1]=P.elements[1],U[I+2]=P.elements[2],U[I+3]=0,U[I+4]=P.elements[3],U[I+5]=P.elements[4],U[I+6]=P.elements[5],U[I+7]=0,U[I+8]=P.elements[6],U[I+9]=P.elements[7],U[I+10]=P.elements[8],U[I+11]=0):ArrayBuffer.isView(P)?U.set(P.subarray(0,U.length-I),I):P.toArray(U,I)}function g(P,U,I,O){let N=P.value,w=U+"_"+I;if(Array.isArray(N)){O[w]===void 0&&(O[w]=[]);let D=O[w],X=!1;for(let k=0;k<N.length;k++)y(N[k],D,k)===!0&&(X=!0);return X}return y(N,O,w)}function y(P,U,I){if(U[I]===void 0)return typeof P=="number"||typeof P=="boolean"?U[I]=P:ArrayBuffer.isView(P)?U[I]=P.slice():U[I]=P.clone(),!0;{let O=U[I];if(typeof P=="number"||typeof P=="boolean"){if(O!==P)return U[I]=P,!0}else{if(ArrayBuffer.isView(P))return!0;if(O.equals(P)===!1)return O.copy(P),!0}}return!1}function M(P){let U=P.uniforms,I=0,O=16;for(let w=0,D=U.length;w<D;w++){let X=Array.isArray(U[w])?U[w]:[U[w]];for(let k=0,Y=X.length;k<Y;k++){let Z=X[k],ee=Array.isArray(Z.value)?Z.value:[Z.value],z=Array.isArray(U[w])||Array.isArray(Z.value),ie=I;for(let ne=0,Se=ee.length;ne<Se;ne++){let re=ee[ne],H=A(re,z),ge=I%O,We=ge%H.boundary,rt=ge+We;I+=We,rt!==0&&O-rt<H.storage&&(I+=O-rt),ne===0&&(ie=I),I+=H.storage}let G=Z.type==="int"?Int32Array:Z.type==="uint"?Uint32Array:Float32Array;Z.__data=new G((I-ie)/Float32Array.BYTES_PER_ELEMENT),Z.__offset=ie}}let N=I%O;return N>0&&(I+=O-N),P.__size=I,P.__cache={},this}function A(P,U){let I={boundary:0,storage:0};return typeof P=="number"||typeof P=="boolean"?(I.boundary=4,I.storage=4):P.isVector2?(I.boundary=8,I.storage=8):P.isVector3||P.isColor?(I.boundary=16,I.storage=12):P.isVector4?(I.boundary=16,I.storage=16):P.isMatrix3?(I.boundary=16,I.storage=48):P.isMatrix4?(I.boundary=16,I.storage=64):P.isTexture?et("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(P)?(I.boundary=16,I.storage=P.byteLength):et("WebGLRenderer: Unsupported uniform value type.",P),U===!0&&(I.boundary=16,I.storage=Math.ceil(I.storage/16)*16),I}function S(P){let U=P.target;U.removeEventListener("dispose",S),i.deleteBuffer(r[U.id]),delete r[U.id],delete a[U.id]}function _(){for(let P in r)i.deleteBuffer(r[P]);r={},a={}}return{bind:l,update:c,dispose:_}}var Xb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),gi=null;function $b(){return gi===null&&(gi=new Fs(Xb,16,16,Ki,Kn),gi.name="DFG_LUT",gi.minFilter=Mn,gi.magFilter=Mn,gi.wrapS=li,gi.wrapT=li,gi.generateMipmaps=!1,gi.needsUpdate=!0),gi}var Ul=class{constructor(e={}){let{canvas:t=Wd(),context:n=null,depth:r=!0,stencil:a=!1,alpha:l=!1,antialias:c=!1,premultipliedAlpha:f=!0,preserveDrawingBuffer:u=!1,powerPreference:m="default",failIfMajorPerformanceCaveat:v=!1,reversedDepthBuffer:g=!1,outputBufferType:y=An}=e;this.isWebGLRenderer=!0;let M;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");M=n.getContextAttributes().alpha}else M=l;let A=y,S=new Set([il,nl,tl]),_=new Set([An,Jn,Qr,vr,Ko,Qo]),P=new Uint32Array(4),U=new Int32Array(4),I={textures:[],min:[],max:[],resolution:[]},O=null,N=null,w=[],D=[],X=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=mi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let k=this,Y=!1,Z=null,ee=null,z=null,ie=null;this._outputColorSpace=gn;let G=0,ne=0,Se=null,re=-1,H=null,ge=new Gt,We=new Gt,rt=null,ue=new ht(0),Fe=0,Pe=t.width,Ze=t.height,Ue=1,ot=null,Vt=null,Qe=new Gt(0,0,Pe,Ze),Et=new Gt(0,0,Pe,Ze),Ct=!1,mt=new Wi,Ht=new Co,pt=!1,It=!1,Mt=new Lt,rn=new j,De=new Gt,$e={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},hn=!1;function sn(){return Se===null?Ue:1}let W=n;function yn(R,V){return t.getContext(R,V)}let Rt,Ut,Le,$t,Je,Ke,L,T,J,ve,de,pe,Me,ae,le,Ce,B,he,se,Re,Ee,Ae,Xe;try{let R={alpha:!0,depth:r,stencil:a,antialias:c,premultipliedAlpha:f,preserveDrawingBuffer:u,powerPreference:m,failIfMajorPerformanceCaveat:v};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",qe,!1),t.addEventListener("webglcontextrestored",dt,!1),t.addEventListener("webglcontextcreationerror",Oe,!1),W===null){let V="webgl2";if(W=yn(V,R),W===null)throw yn(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ut()}catch(R){throw t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),it("WebGLRenderer: "+R.message),R}function ut(){Rt=new iM(W),Rt.init(),Ee=new kb(W,Rt),Ut=new $S(W,Rt,e,Ee),Le=new Ob(W,Rt),Ut.reversedDepthBuffer&&g&&Le.buffers.depth.setReversed(!0),ee=W.createFramebuffer(),z=W.createFramebuffer(),ie=W.createFramebuffer(),$t=new aM(W),Je=new bb,Ke=new Bb(W,Rt,Le,Je,Ut,Ee,$t),L=new nM(k),T=new ly(W),Ae=new WS(W,T),J=new rM(W,T,$t,Ae),ve=new lM(W,J,T,Ae,$t),he=new oM(W,Ut,Ke),le=new qS(Je),de=new Mb(k,L,Rt,Ut,Ae,le),pe=new Hb(k,Je),Me=new Eb,ae=new Ib(Rt),B=new HS(k,L,Le,ve,M,f),Ce=new Ub(k,ve,Ut),Xe=new Wb(W,$t,Ut,Le),se=new XS(W,Rt,$t),Re=new sM(W,Rt,$t),$t.programs=de.programs,k.capabilities=Ut,k.extensions=Rt,k.properties=Je,k.renderLists=Me,k.shadowMap=Ce,k.state=Le,k.info=$t}A!==An&&(X=new hM(A,t.width,t.height,c,r,a));let we=new Ih(k,W);this.xr=we,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let R=Rt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Rt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return Ue},this.setPixelRatio=function(R){R!==void 0&&(Ue=R,this.setSize(Pe,Ze,!1))},this.getSize=function(R){return R.set(Pe,Ze)},this.setSize=function(R,V,te=!0){if(we.isPresenting){et("WebGLRenderer: Can't change size while VR device is presenting.");return}Pe=R,Ze=V,t.width=Math.floor(R*Ue),t.height=Math.floor(V*Ue),te===!0&&(t.style.width=R+"px",t.style.height=V+"px"),X!==null&&X.setSize(t.width,t.height),this.setViewport(0,0,R,V)},this.getDrawingBufferSize=function(R){return R.set(Pe*Ue,Ze*Ue).floor()},this.setDrawingBufferSize=function(R,V,te){Pe=R,Ze=V,Ue=te,t.width=Math.floor(R*te),t.height=Math.floor(V*te),this.setViewport(0,0,R,V)},this.setEffects=function(R){if(A===An){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let V=0;V<R.length;V++)if(R[V].isOutputPass===!0){et("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}X.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(ge)},this.getViewport=function(R){return R.copy(Qe)},this.setViewport=function(R,V,te,K){R.isVector4?Qe.set(R.x,R.y,R.z,R.w):Qe.set(R,V,te,K),Le.viewport(ge.copy(Qe).multiplyScalar(sn()).round())},this.getScissor=function(R){return R.copy(Et)},this.setScissor=function(R,V,te,K){R.isVector4?Et.set(R.x,R.y,R.z,R.w):Et.set(R,V,te,K),Le.scissor(We.copy(Et).multiplyScalar(sn()).round())},this.getScissorTest=function(){return Ct},this.setScissorTest=function(R){Le.setScissorTest(Ct=R)},this.setOpaqueSort=function(R){ot=R},this.setTransparentSort=function(R){Vt=R},this.getClearColor=function(R){return R.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(R=!0,V=!0,te=!0){let K=0;if(R){let q=!1;if(Se!==null){let Ie=Se.texture.format;q=S.has(Ie)}if(q){let Ie=Se.texture.type,ze=_.has(Ie),Te=B.getClearColor(),Ne=B.getClearAlpha(),Ge=Te.r,st=Te.g,gt=Te.b;ze?(P[0]=Ge,P[1]=st,P[2]=gt,P[3]=Ne,W.clearBufferuiv(W.COLOR,0,P)):(U[0]=Ge,U[1]=st,U[2]=gt,U[3]=Ne,W.clearBufferiv(W.COLOR,0,U))}else K|=W.COLOR_BUFFER_BIT}V&&(K|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(K|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&W.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),Z=R},this.dispose=function(){t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",dt,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),B.dispose(),Me.dispose(),ae.dispose(),Ke.dispose(),Je.dispose(),L.dispose(),ve.dispose(),J.dispose(),Ae.dispose(),Xe.dispose(),de.dispose(),we.dispose(),we.removeEventListener("sessionstart",ss),we.removeEventListener("sessionend",yi),un.stop()};function qe(R){R.preventDefault(),fh("WebGLRenderer: Context Lost."),Y=!0}function dt(){fh("WebGLRenderer: Context Restored."),Y=!1;let R=$t.autoReset,V=Ce.enabled,te=Ce.autoUpdate,K=Ce.needsUpdate,q=Ce.type;ut(),$t.autoReset=R,Ce.enabled=V,Ce.autoUpdate=te,Ce.needsUpdate=K,Ce.type=q}function Oe(R){it("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function Tt(R){let V=R.target;V.removeEventListener("dispose",Tt),Bt(V)}function Bt(R){vi(R),Je.remove(R)}function vi(R){let V=Je.get(R).programs;V!==void 0&&(V.forEach(function(te){de.releaseProgram(te)}),R.isShaderMaterial&&de.releaseShaderCache(R))}this.renderBufferDirect=function(R,V,te,K,q,Ie){V===null&&(V=$e);let ze=q.isMesh&&q.matrixWorld.determinantAffine()<0,Te=Wl(R,V,te,K,q);Le.setMaterial(K,ze);let Ne=te.index,Ge=1;if(K.wireframe===!0){if(Ne=J.getWireframeAttribute(te),Ne===void 0)return;Ge=2}let st=te.drawRange,gt=te.attributes.position,Ve=st.start*Ge,lt=(st.start+st.count)*Ge;Ie!==null&&(Ve=Math.max(Ve,Ie.start*Ge),lt=Math.min(lt,(Ie.start+Ie.count)*Ge)),Ne!==null?(Ve=Math.max(Ve,0),lt=Math.min(lt,Ne.count)):gt!=null&&(Ve=Math.max(Ve,0),lt=Math.min(lt,gt.count));let Wt=lt-Ve;if(Wt<0||Wt===1/0)return;Ae.setup(q,K,Te,te,Ne);let ke,Dt=se;if(Ne!==null&&(ke=T.get(Ne),Dt=Re,Dt.setIndex(ke)),q.isMesh)K.wireframe===!0?(Le.setLineWidth(K.wireframeLinewidth*sn()),Dt.setMode(W.LINES)):Dt.setMode(W.TRIANGLES);else if(q.isLine){let jt=K.linewidth;jt===void 0&&(jt=1),Le.setLineWidth(jt*sn()),q.isLineSegments?Dt.setMode(W.LINES):q.isLineLoop?Dt.setMode(W.LINE_LOOP):Dt.setMode(W.LINE_STRIP)}else q.isPoints?Dt.setMode(W.POINTS):q.isSprite&&Dt.setMode(W.TRIANGLES);if(q.isBatchedMesh)if(Rt.get("WEBGL_multi_draw"))Dt.renderMultiDraw(q._multiDrawStarts,q._multiDrawCounts,q._multiDrawCount);else{let jt=q._multiDrawStarts,He=q._multiDrawCounts,an=q._multiDrawCount,wt=Ne?T.get(Ne).bytesPerElement:1,ti=Je.get(K).currentProgram.getUniforms();for(let on=0;on<an;on++)ti.setValue(W,"_gl_DrawID",on),Dt.render(jt[on]/wt,He[on])}else if(q.isInstancedMesh)Dt.renderInstances(Ve,Wt,q.count);else if(te.isInstancedBufferGeometry){let jt=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,He=Math.min(te.instanceCount,jt);Dt.renderInstances(Ve,Wt,He)}else Dt.render(Ve,Wt)};function ye(R,V,te,K){Z!==null&&R.isNodeMaterial&&Z.setObject(K,R),pt===!0&&le.setState(R,te,!1),R.transparent===!0&&R.side===pi&&R.forceSinglePass===!1?(R.side=dn,R.needsUpdate=!0,er(R,V,K),R.side=Ji,R.needsUpdate=!0,er(R,V,K),R.side=pi):er(R,V,K)}this.compile=function(R,V,te=null){te===null&&(te=R),Z!==null&&Z.renderStart(R,V,te),N=ae.get(te),N.init(V),D.push(N),te.traverseVisible(function(q){q.isLight&&q.layers.test(V.layers)&&(N.pushLight(q),q.castShadow&&N.pushShadow(q))}),R!==te&&R.traverseVisible(function(q){q.isLight&&q.layers.test(V.layers)&&(N.pushLight(q),q.castShadow&&N.pushShadow(q))}),N.setupLights(),Z!==null&&Z.updateLights(N.state.lightsArray),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),pt===!0&&le.setGlobalState(this.clippingPlanes,V),Z!==null&&Ce.render(N.state.shadowsArray,te,V);let K=new Set;return R.traverse(function(q){if(!(q.isMesh||q.isPoints||q.isLine||q.isSprite))return;let Ie=q.material;if(Ie)if(Array.isArray(Ie))for(let ze=0;ze<Ie.length;ze++){let Te=Ie[ze];ye(Te,te,V,q),K.add(Te)}else ye(Ie,te,V,q),K.add(Ie)}),N=D.pop(),Z!==null&&Z.renderEnd(),K},this.compileAsync=function(R,V,te=null){let K=this.compile(R,V,te);return new Promise(q=>{function Ie(){if(K.forEach(function(ze){let Ne=Je.get(ze).currentProgram;(Ne===void 0||Ne.isReady())&&K.delete(ze)}),K.size===0){q(R);return}setTimeout(Ie,10)}Rt.get("KHR_parallel_shader_compile")!==null?Ie():setTimeout(Ie,10)})};let _e=null;function ei(R){_e&&_e(R)}function ss(){un.stop()}function yi(){un.start()}let un=new Mf;un.setAnimationLoop(ei),typeof self<"u"&&un.setContext(self),this.setAnimationLoop=function(R){_e=R,we.setAnimationLoop(R),R===null?un.stop():un.start()},we.addEventListener("sessionstart",ss),we.addEventListener("sessionend",yi),this.render=function(R,V){if(V!==void 0&&V.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(Y===!0)return;Z!==null&&Z.renderStart(R,V);let te=we.enabled===!0&&we.isPresenting===!0,K=X!==null&&(Se===null||te)&&X.begin(k,Se);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),we.enabled===!0&&we.isPresenting===!0&&(X===null||X.isCompositing()===!1)&&(we.cameraAutoUpdate===!0&&we.updateCamera(V),V=we.getCamera()),R.isScene===!0&&R.onBeforeRender(k,R,V,Se),N=ae.get(R,D.length),N.init(V),N.state.textureUnits=Ke.getTextureUnits(),D.push(N),Mt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Ht.setFromArrayCamera(V):mt.setFromProjectionMatrix(Mt,zn,V.reversedDepth),It=this.localClippingEnabled,pt=le.init(this.clippingPlanes,It),O=Me.get(R,w.length),O.init(),w.push(O),this.info.render.frame++,we.enabled===!0&&we.isPresenting===!0){let ze=k.xr.getDepthSensingMesh();ze!==null&&as(ze,V,-1/0,k.sortObjects)}as(R,V,0,k.sortObjects),O.finish(),Z!==null&&Z.updateLights(N.state.lightsArray),k.sortObjects===!0&&O.sort(ot,Vt),hn=we.enabled===!1||we.isPresenting===!1||we.hasDepthSensing()===!1,hn&&B.addToRenderList(O,R),this.info.autoReset===!0&&this.info.reset(),pt===!0&&le.beginShadows();let q=N.state.shadowsArray;if(Ce.render(q,R,V),pt===!0&&le.endShadows(),(K&&X.hasRenderPass())===!1){let ze=O.opaque,Te=O.transmissive;if(N.setupLights(),V.isArrayCamera){let Ne=V.cameras;if(Te.length>0)for(let Ge=0,st=Ne.length;Ge<st;Ge++){let gt=Ne[Ge];Qi(ze,Te,R,gt)}hn&&B.render(R);for(let Ge=0,st=Ne.length;Ge<st;Ge++){let gt=Ne[Ge];Un(O,R,gt,gt.viewport)}}else Te.length>0&&Qi(ze,Te,R,V),hn&&B.render(R),Un(O,R,V)}Se!==null&&ne===0&&(Ke.updateMultisampleRenderTarget(Se),Ke.updateRenderTargetMipmap(Se)),K&&X.end(k),R.isScene===!0&&R.onAfterRender(k,R,V),Ae.resetDefaultState(),re=-1,H=null,D.pop(),D.length>0?(N=D[D.length-1],Ke.setTextureUnits(N.state.textureUnits),pt===!0&&le.setGlobalState(k.clippingPlanes,N.state.camera)):N=null,w.pop(),w.length>0?O=w[w.length-1]:O=null,Z!==null&&Z.renderEnd()};function as(R,V,te,K){if(R.visible===!1)return;if(R.layers.test(V.layers)){if(R.isGroup)te=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(V);else if(R.isLight)N.pushLight(R),R.castShadow&&N.pushShadow(R);else if(R.isSprite){let ze=V.isArrayCamera?Ht:mt;if(!R.frustumCulled||R.intersectsFrustum(ze)){K&&De.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Mt);let Te=ve.update(R),Ne=R.material;Ne.visible&&O.push(R,Te,Ne,te,De.z,null,V)}}else if(R.isMesh||R.isLine||R.isPoints){let ze=V.isArrayCamera?Ht:mt;if(!R.frustumCulled||R.intersectsFrustum(ze)){let Te=ve.update(R),Ne=R.material;if(K&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),De.copy(R.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),De.copy(Te.boundingSphere.center)),De.applyMatrix4(R.matrixWorld).applyMatrix4(Mt)),Array.isArray(Ne)){let Ge=Te.groups;for(let st=0,gt=Ge.length;st<gt;st++){let Ve=Ge[st],lt=Ne[Ve.materialIndex];lt&&lt.visible&&O.push(R,Te,lt,te,De.z,Ve,V)}}else Ne.visible&&O.push(R,Te,Ne,te,De.z,null,V)}}}let Ie=R.children;for(let ze=0,Te=Ie.length;ze<Te;ze++)as(Ie[ze],V,te,K)}function Un(R,V,te,K){let{opaque:q,transmissive:Ie,transparent:ze}=R;N.setupLightsView(te),pt===!0&&le.setGlobalState(k.clippingPlanes,te),K&&Le.viewport(ge.copy(K)),q.length>0&&xr(q,V,te),Ie.length>0&&xr(Ie,V,te),ze.length>0&&xr(ze,V,te),Le.buffers.depth.setTest(!0),Le.buffers.depth.setMask(!0),Le.buffers.color.setMask(!0),Le.setPolygonOffset(!1)}function Qi(R,V,te,K){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(N.state.transmissionRenderTarget[K.id]===void 0){let Ve=Rt.has("EXT_color_buffer_half_float")||Rt.has("EXT_color_buffer_float");N.state.transmissionRenderTarget[K.id]=new Fn(1,1,{generateMipmaps:!0,type:Ve?Kn:An,minFilter:Pi,samples:Math.max(4,Ut.samples),stencilBuffer:a,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ie=N.state.transmissionRenderTarget[K.id],ze=K.viewport||ge;Ie.setSize(ze.z*k.transmissionResolutionScale,ze.w*k.transmissionResolutionScale);let Te=k.getRenderTarget(),Ne=k.getActiveCubeFace(),Ge=k.getActiveMipmapLevel();k.setRenderTarget(Ie),k.getClearColor(ue),Fe=k.getClearAlpha(),Fe<1&&k.setClearColor(16777215,.5),k.clear(),hn&&B.render(te);let st=k.toneMapping;k.toneMapping=mi;let gt=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),N.setupLightsView(K),pt===!0&&le.setGlobalState(k.clippingPlanes,K),xr(R,te,K),Ke.updateMultisampleRenderTarget(Ie),Ke.updateRenderTargetMipmap(Ie),Rt.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let lt=0,Wt=V.length;lt<Wt;lt++){let ke=V[lt],{object:Dt,geometry:jt,material:He,group:an}=ke;if(He.side===pi&&Dt.layers.test(K.layers)){let wt=He.side;He.side=dn,He.needsUpdate=!0,_a(Dt,te,K,jt,He,an),He.side=wt,He.needsUpdate=!0,Ve=!0}}Ve===!0&&(Ke.updateMultisampleRenderTarget(Ie),Ke.updateRenderTargetMipmap(Ie))}k.setRenderTarget(Te,Ne,Ge),k.setClearColor(ue,Fe),gt!==void 0&&(K.viewport=gt),k.toneMapping=st}function xr(R,V,te){let K=V.isScene===!0?V.overrideMaterial:null;for(let q=0,Ie=R.length;q<Ie;q++){let ze=R[q],{object:Te,geometry:Ne,group:Ge}=ze,st=ze.material;st.allowOverride===!0&&K!==null&&(st=K),Te.layers.test(te.layers)&&_a(Te,V,te,Ne,st,Ge)}}function _a(R,V,te,K,q,Ie){Z!==null&&q.isNodeMaterial&&Z.setObject(R,q),R.onBeforeRender(k,V,te,K,q,Ie),R.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),q.onBeforeRender(k,V,te,K,R,Ie),q.transparent===!0&&q.side===pi&&q.forceSinglePass===!1?(q.side=dn,q.needsUpdate=!0,k.renderBufferDirect(te,V,K,q,R,Ie),q.side=Ji,q.needsUpdate=!0,k.renderBufferDirect(te,V,K,q,R,Ie),q.side=pi):k.renderBufferDirect(te,V,K,q,R,Ie),R.onAfterRender(k,V,te,K,q,Ie)}function On(R){let V=0;for(let te of R)te.texture!==null&&V++;return V}function er(R,V,te){V.isScene!==!0&&(V=$e);let K=Je.get(R),q=N.state.lights,Ie=N.state.shadowsArray,ze=q.state.version,Te=de.getParameters(R,q.state,Ie,V,te,N.state.lightProbeGridArray),Ne=de.getProgramCacheKey(Te),Ge=K.programs;K.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?V.environment:null,K.fog=V.fog;let st=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;K.envMap=L.get(R.envMap||K.environment,st),K.envMapRotation=K.environment!==null&&R.envMap===null?V.environmentRotation:R.envMapRotation,Ge===void 0&&(R.addEventListener("dispose",Tt),Ge=new Map,K.programs=Ge,K.programVariants=new Map);let gt=Ge.get(Ne);if(gt!==void 0){if(K.currentProgram===gt&&K.lightsStateVersion===ze)return Mr(R,Te),gt}else Te.uniforms=de.getUniforms(R),Z!==null&&R.isNodeMaterial&&Z.build(R,te,Te),R.onBeforeCompile(Te,k),gt=de.acquireProgram(Te,Ne),Ge.set(Ne,gt),K.uniforms=Te.uniforms;let Ve=K.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ve.clippingPlanes=le.uniform),Mr(R,Te),K.needsLights=$l(R),K.lightsStateVersion=ze,K.needsLights&&(Ve.ambientLightColor.value=q.state.ambient,Ve.lightProbe.value=q.state.probe,Ve.sunLights.value=q.state.sun,Ve.sunLightShadows.value=q.state.sunShadow,Ve.directionalLights.value=q.state.directional,Ve.directionalLightShadows.value=q.state.directionalShadow,Ve.spotLights.value=q.state.spot,Ve.spotLightShadows.value=q.state.spotShadow,Ve.rectAreaLights.value=q.state.rectArea,Ve.ltc_1.value=q.state.rectAreaLTC1,Ve.ltc_2.value=q.state.rectAreaLTC2,Ve.pointLights.value=q.state.point,Ve.pointLightShadows.value=q.state.pointShadow,Ve.hemisphereLights.value=q.state.hemi,Ve.sunShadowMatrix.value=q.state.sunShadowMatrix,Ve.sunShadowCascade.value=q.state.sunShadowCascade,Ve.directionalShadowMatrix.value=q.state.directionalShadowMatrix,Ve.spotLightMatrix.value=q.state.spotLightMatrix,Ve.spotLightMap.value=q.state.spotLightMap,Ve.pointShadowMatrix.value=q.state.pointShadowMatrix),K.numLightProbeGrids=On(N.state.lightProbeGridArray),K.currentProgram=gt,K.uniformsList=null,gt}function Sr(R,V,te,K,q){let Ie=Je.get(R),ze=Ie.currentProgram.id+","+K+","+q,Te=Ie.programVariants.get(ze);return Te===void 0?(Te=er(R,V,te),Ie.programVariants.set(ze,Te)):(Ie.currentProgram=Te,Ie.uniformsList=null,Ie.outputColorSpace=K,Ie.toneMapping=q),Te}function tr(R){if(R.uniformsList===null){let V=R.currentProgram.getUniforms();R.uniformsList=ts.seqWithValue(V.seq,R.uniforms)}return R.uniformsList}function Mr(R,V){let te=Je.get(R);te.outputColorSpace=V.outputColorSpace,te.batching=V.batching,te.batchingColor=V.batchingColor,te.instancing=V.instancing,te.instancingColor=V.instancingColor,te.instancingMorph=V.instancingMorph,te.skinning=V.skinning,te.morphTargets=V.morphTargets,te.morphNormals=V.morphNormals,te.morphColors=V.morphColors,te.morphTargetsCount=V.morphTargetsCount,te.numClippingPlanes=V.numClippingPlanes,te.numIntersection=V.numClipIntersection,te.vertexAlphas=V.vertexAlphas,te.vertexTangents=V.vertexTangents,te.toneMapping=V.toneMapping}function Wl(R,V,te,K,q){V.isScene!==!0&&(V=$e),Ke.resetTextureUnits();let Ie=V.fog,ze=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?V.environment:null,Te=Se===null?k.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:St.workingColorSpace,Ne=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ge=L.get(K.envMap||ze,Ne),st=K.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,gt=!!te.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),Ve=!!te.morphAttributes.position,lt=!!te.morphAttributes.normal,Wt=!!te.morphAttributes.color,ke=mi;K.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ke=k.toneMapping);let Dt=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,jt=Dt!==void 0?Dt.length:0,He=Je.get(K),an=N.state.lights;if(pt===!0&&(It===!0||R!==H)){let Ft=R===H&&K.id===re;le.setState(K,R,Ft)}let wt=!1,ti=!1;K.version===He.__version?He.needsLights&&He.lightsStateVersion!==an.state.version||q.isBatchedMesh&&He.batching===!1||!q.isBatchedMesh&&He.batching===!0||q.isBatchedMesh&&He.batchingColor===!0&&q._colorsTexture===null||q.isBatchedMesh&&He.batchingColor===!1&&q._colorsTexture!==null||q.isInstancedMesh&&He.instancing===!1||!q.isInstancedMesh&&He.instancing===!0||q.isSkinnedMesh&&He.skinning===!1||!q.isSkinnedMesh&&He.skinning===!0||q.isInstancedMesh&&He.instancingColor===!0&&q.instanceColor===null||q.isInstancedMesh&&He.instancingColor===!1&&q.instanceColor!==null||q.isInstancedMesh&&He.instancingMorph===!0&&q.morphTexture===null||q.isInstancedMesh&&He.instancingMorph===!1&&q.morphTexture!==null||He.envMap!==Ge||K.fog===!0&&He.fog!==Ie||He.numClippingPlanes!==void 0&&(He.numClippingPlanes!==le.numPlanes||He.numIntersection!==le.numIntersection)||He.vertexAlphas!==st||He.vertexTangents!==gt||He.morphTargets!==Ve||He.morphNormals!==lt||He.morphColors!==Wt||He.morphTargetsCount!==jt||He.numLightProbeGrids!==On(N.state.lightProbeGridArray)?wt=!0:(He.outputColorSpace!==Te||He.toneMapping!==ke)&&(ti=!0):(wt=!0,He.__version=K.version);let on=He.currentProgram;(wt===!0||ti===!0)&&(on=ti===!0?Sr(K,V,q,Te,ke):er(K,V,q),Z&&K.isNodeMaterial&&Z.onUpdateProgram(K,on,He));let Fi=!1,ni=!1,ii=!1,b=on.getUniforms(),ft=He.uniforms;if(Le.useProgram(on.program)&&(Fi=!0,ni=!0,ii=!0),K.id!==re&&(re=K.id,ni=!0),Fi||H!==R){Le.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),b.setValue(W,"projectionMatrix",R.projectionMatrix),b.setValue(W,"viewMatrix",R.matrixWorldInverse);let kt=b.map.cameraPosition;kt!==void 0&&kt.setValue(W,rn.setFromMatrixPosition(R.matrixWorld)),Ut.logarithmicDepthBuffer&&b.setValue(W,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&b.setValue(W,"isOrthographic",R.isOrthographicCamera===!0),H!==R&&(H=R,ni=!0,ii=!0)}if(He.needsLights&&(an.state.sunShadowMap.length>0&&b.setValue(W,"sunShadowMap",an.state.sunShadowMap,Ke),an.state.directionalShadowMap.length>0&&b.setValue(W,"directionalShadowMap",an.state.directionalShadowMap,Ke),an.state.spotShadowMap.length>0&&b.setValue(W,"spotShadowMap",an.state.spotShadowMap,Ke),an.state.pointShadowMap.length>0&&b.setValue(W,"pointShadowMap",an.state.pointShadowMap,Ke)),q.isSkinnedMesh){b.setOptional(W,q,"bindMatrix"),b.setOptional(W,q,"bindMatrixInverse");let Ft=q.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),b.setValue(W,"boneTexture",Ft.boneTexture,Ke))}q.isBatchedMesh&&(b.setOptional(W,q,"batchingTexture"),b.setValue(W,"batchingTexture",q._matricesTexture,Ke),b.setOptional(W,q,"batchingIdTexture"),b.setValue(W,"batchingIdTexture",q._indirectTexture,Ke),b.setOptional(W,q,"batchingColorTexture"),q._colorsTexture!==null&&b.setValue(W,"batchingColorTexture",q._colorsTexture,Ke));let Rn=te.morphAttributes;if((Rn.position!==void 0||Rn.normal!==void 0||Rn.color!==void 0)&&he.update(q,te,on),(ni||He.receiveShadow!==q.receiveShadow)&&(He.receiveShadow=q.receiveShadow,b.setValue(W,"receiveShadow",q.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&V.environment!==null&&(ft.envMapIntensity.value=V.environmentIntensity),ft.dfgLUT!==void 0&&(ft.dfgLUT.value=$b()),ni){if(b.setValue(W,"toneMappingExposure",k.toneMappingExposure),He.needsLights&&Xl(ft,ii),Ie&&K.fog===!0&&pe.refreshFogUniforms(ft,Ie),pe.refreshMaterialUniforms(ft,K,Ue,Ze,N.state.transmissionRenderTarget[R.id]),He.needsLights&&He.numLightProbeGrids>0){let Ft=I,kt=0;for(let Wn of N.state.lightProbeGridArray)Wn.texture!==null&&(Ft.textures[kt]=Wn.texture,Ft.min[kt]=Wn.boundingBox.min,Ft.max[kt]=Wn.boundingBox.max,Ft.resolution[kt]=Wn.resolution,kt++);for(let Wn in Ft)Ft[Wn].length=kt;ft.probesSH.value=Ft.textures,ft.probesMin.value=Ft.min,ft.probesMax.value=Ft.max,ft.probesResolution.value=Ft.resolution}ts.upload(W,tr(He),ft,Ke)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(ts.upload(W,tr(He),ft,Ke),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&b.setValue(W,"center",q.center),b.setValue(W,"modelViewMatrix",q.modelViewMatrix),b.setValue(W,"normalMatrix",q.normalMatrix),b.setValue(W,"modelMatrix",q.matrixWorld),K.uniformsGroups!==void 0){let Ft=K.uniformsGroups;for(let kt=0,Wn=Ft.length;kt<Wn;kt++){let va=Ft[kt];Xe.update(va,on),Xe.bind(va,on)}}return on}function Xl(R,V){R.ambientLightColor.needsUpdate=V,R.lightProbe.needsUpdate=V,R.sunLights.needsUpdate=V,R.sunLightShadows.needsUpdate=V,R.directionalLights.needsUpdate=V,R.directionalLightShadows.needsUpdate=V,R.pointLights.needsUpdate=V,R.pointLightShadows.needsUpdate=V,R.spotLights.needsUpdate=V,R.spotLightShadows.needsUpdate=V,R.rectAreaLights.needsUpdate=V,R.hemisphereLights.needsUpdate=V}function $l(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return ne},this.getRenderTarget=function(){return Se},this.setRenderTargetTextures=function(R,V,te){let K=Je.get(R);K.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Je.get(R.texture).__webglTexture=V,Je.get(R.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:te,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,V){let te=Je.get(R);te.__webglFramebuffer=V,te.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(R,V=0,te=0){Se=R,G=V,ne=te;let K=null,q=!1,Ie=!1;if(R){let Te=Je.get(R);if(Te.__useDefaultFramebuffer!==void 0){Le.bindFramebuffer(W.FRAMEBUFFER,Te.__webglFramebuffer),ge.copy(R.viewport),We.copy(R.scissor),rt=R.scissorTest,Le.viewport(ge),Le.scissor(We),Le.setScissorTest(rt),re=-1;return}else if(Te.__webglFramebuffer===void 0)Ke.setupRenderTarget(R);else if(Te.__hasExternalTextures)Ke.rebindTextures(R,Je.get(R.texture).__webglTexture,Je.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let st=R.depthTexture;if(Te.__boundDepthTexture!==st){if(st!==null&&Je.has(st)&&(R.width!==st.image.width||R.height!==st.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ke.setupDepthRenderbuffer(R)}}let Ne=R.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ie=!0);let Ge=Je.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Ge[V])?K=Ge[V][te]:K=Ge[V],q=!0):R.samples>0&&Ke.useMultisampledRTT(R)===!1?K=Je.get(R).__webglMultisampledFramebuffer:Array.isArray(Ge)?K=Ge[te]:K=Ge,ge.copy(R.viewport),We.copy(R.scissor),rt=R.scissorTest}else ge.copy(Qe).multiplyScalar(Ue).floor(),We.copy(Et).multiplyScalar(Ue).floor(),rt=Ct;if(te!==0&&(K=ee),Le.bindFramebuffer(W.FRAMEBUFFER,K)&&Le.drawBuffers(R,K),Le.viewport(ge),Le.scissor(We),Le.setScissorTest(rt),q){let Te=Je.get(R.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+V,Te.__webglTexture,te)}else if(Ie){let Te=V;for(let Ne=0;Ne<R.textures.length;Ne++){let Ge=Je.get(R.textures[Ne]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,te,Te)}}else if(R!==null&&te!==0){let Te=Je.get(R.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Te.__webglTexture,te)}re=-1};function os(R){let V=Je.get(R);return(V.__readFormat!==R.format||V.__readType!==R.type)&&(V.__readFormat=R.format,V.__readType=R.type,V.__formatReadable=Ut.textureFormatReadable(R.format),V.__typeReadable=Ut.textureTypeReadable(R.type)),V}this.readRenderTargetPixels=function(R,V,te,K,q,Ie,ze,Te=0){if(!(R&&R.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Je.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);try{let Ge=R.textures[Te],st=Ge.format,gt=Ge.type;R.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=os(Ge);if(Ve.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=R.width-K&&te>=0&&te<=R.height-q&&W.readPixels(V,te,K,q,Ee.convert(st),Ee.convert(gt),Ie)}finally{let Ge=Se!==null?Je.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(R,V,te,K,q,Ie,ze,Te=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Je.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&ze!==void 0&&(Ne=Ne[ze],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(V>=0&&V<=R.width-K&&te>=0&&te<=R.height-q){Le.bindFramebuffer(W.FRAMEBUFFER,Ne);let Ge=R.textures[Te],st=Ge.format,gt=Ge.type;R.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Te);let Ve=os(Ge);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let lt=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.bufferData(W.PIXEL_PACK_BUFFER,Ie.byteLength,W.STREAM_READ),W.readPixels(V,te,K,q,Ee.convert(st),Ee.convert(gt),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let Wt=Se!==null?Je.get(Se).__webglFramebuffer:null;Le.bindFramebuffer(W.FRAMEBUFFER,Wt);let ke=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await $d(W,ke,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,lt),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,Ie),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(lt),W.deleteSync(ke),Ie}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,V=null,te=0){let K=Math.pow(2,-te),q=Math.floor(R.image.width*K),Ie=Math.floor(R.image.height*K),ze=V!==null?V.x:0,Te=V!==null?V.y:0;Ke.setTexture2D(R,0),W.copyTexSubImage2D(W.TEXTURE_2D,te,0,0,ze,Te,q,Ie),Le.unbindTexture()},this.copyTextureToTexture=function(R,V,te=null,K=null,q=0,Ie=0){let ze,Te,Ne,Ge,st,gt,Ve,lt,Wt,ke=R.isCompressedTexture?R.mipmaps[Ie]:R.image;if(te!==null)ze=te.max.x-te.min.x,Te=te.max.y-te.min.y,Ne=te.isBox3?te.max.z-te.min.z:1,Ge=te.min.x,st=te.min.y,gt=te.isBox3?te.min.z:0;else{let b=Math.pow(2,-q);ze=Math.floor(ke.width*b),Te=Math.floor(ke.height*b),R.isDataArrayTexture?Ne=ke.depth:R.isData3DTexture?Ne=Math.floor(ke.depth*b):Ne=1,Ge=0,st=0,gt=0}K!==null?(Ve=K.x,lt=K.y,Wt=K.z):(Ve=0,lt=0,Wt=0);let Dt=Ee.convert(V.format),jt=Ee.convert(V.type),He;V.isData3DTexture?(Ke.setTexture3D(V,0),He=W.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Ke.setTexture2DArray(V,0),He=W.TEXTURE_2D_ARRAY):(Ke.setTexture2D(V,0),He=W.TEXTURE_2D),Le.activeTexture(W.TEXTURE0),Le.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,V.flipY),Le.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Le.pixelStorei(W.UNPACK_ALIGNMENT,V.unpackAlignment);let an=Le.getParameter(W.UNPACK_ROW_LENGTH),wt=Le.getParameter(W.UNPACK_IMAGE_HEIGHT),ti=Le.getParameter(W.UNPACK_SKIP_PIXELS),on=Le.getParameter(W.UNPACK_SKIP_ROWS),Fi=Le.getParameter(W.UNPACK_SKIP_IMAGES);Le.pixelStorei(W.UNPACK_ROW_LENGTH,ke.width),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,ke.height),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,Ge),Le.pixelStorei(W.UNPACK_SKIP_ROWS,st),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,gt);let ni=R.isDataArrayTexture||R.isData3DTexture,ii=V.isDataArrayTexture||V.isData3DTexture;if(R.isDepthTexture){let b=Je.get(R),ft=Je.get(V),Rn=Je.get(b.__renderTarget),Ft=Je.get(ft.__renderTarget);Le.bindFramebuffer(W.READ_FRAMEBUFFER,Rn.__webglFramebuffer),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let kt=0;kt<Ne;kt++)ni&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Je.get(R).__webglTexture,q,gt+kt),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Je.get(V).__webglTexture,Ie,Wt+kt)),W.blitFramebuffer(Ge,st,Ge+ze,st+Te,Ve,lt,Ve+ze,lt+Te,W.DEPTH_BUFFER_BIT,W.NEAREST);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if(q!==0||R.isRenderTargetTexture||Je.has(R)){let b=Je.get(R),ft=Je.get(V);Le.bindFramebuffer(W.READ_FRAMEBUFFER,z),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,ie);for(let Rn=0;Rn<Ne;Rn++)ni?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,b.__webglTexture,q,gt+Rn):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,b.__webglTexture,q),ii?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,ft.__webglTexture,Ie,Wt+Rn):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,ft.__webglTexture,Ie),q!==0?W.blitFramebuffer(Ge,st,Ge+ze,st+Te,Ve,lt,Ve+ze,lt+Te,W.COLOR_BUFFER_BIT,W.NEAREST):ii?W.copyTexSubImage3D(He,Ie,Ve,lt,Wt+Rn,Ge,st,ze,Te):W.copyTexSubImage2D(He,Ie,Ve,lt,Ge,st,ze,Te);Le.bindFramebuffer(W.READ_FRAMEBUFFER,null),Le.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else ii?R.isDataTexture||R.isData3DTexture?W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke.data):V.isCompressedArrayTexture?W.compressedTexSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,ke.data):W.texSubImage3D(He,Ie,Ve,lt,Wt,ze,Te,Ne,Dt,jt,ke):R.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke.data):R.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ke.width,ke.height,Dt,ke.data):W.texSubImage2D(W.TEXTURE_2D,Ie,Ve,lt,ze,Te,Dt,jt,ke);Le.pixelStorei(W.UNPACK_ROW_LENGTH,an),Le.pixelStorei(W.UNPACK_IMAGE_HEIGHT,wt),Le.pixelStorei(W.UNPACK_SKIP_PIXELS,ti),Le.pixelStorei(W.UNPACK_SKIP_ROWS,on),Le.pixelStorei(W.UNPACK_SKIP_IMAGES,Fi),Ie===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&W.generateMipmap(He),Le.unbindTexture()},this.initRenderTarget=function(R){Je.get(R).__webglFramebuffer===void 0&&Ke.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Ke.setTextureCube(R,0):R.isData3DTexture?Ke.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Ke.setTexture2DArray(R,0):Ke.setTexture2D(R,0),Le.unbindTexture()},this.resetState=function(){G=0,ne=0,Se=null,Le.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return zn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var Lf={type:"change"},Lh={type:"start"},Nf={type:"end"},kl=new Hi,Ff=new Ln,Yb=Math.cos(70*_h.DEG2RAD),nn=new j,Cn=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Dh=1e-6,zl=class extends Qs{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new j,this.cursor=new j,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ji.ROTATE,MIDDLE:ji.DOLLY,RIGHT:ji.PAN},this.touches={ONE:Zi.ROTATE,TWO:Zi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new j,this._lastQuaternion=new bn,this._lastTargetPosition=new j,this._quat=new bn().setFromUnitVectors(e.up,new j(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new jr,this._sphericalDelta=new jr,this._scale=1,this._panOffset=new j,this._rotateStart=new tt,this._rotateEnd=new tt,this._rotateDelta=new tt,this._panStart=new tt,this._panEnd=new tt,this._panDelta=new tt,this._dollyStart=new tt,this._dollyEnd=new tt,this._dollyDelta=new tt,this._dollyDirection=new j,this._mouse=new tt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Zb.bind(this),this._onPointerDown=jb.bind(this),this._onPointerUp=Jb.bind(this),this._onContextMenu=rw.bind(this),this._onMouseWheel=ew.bind(this),this._onKeyDown=tw.bind(this),this._onTouchStart=nw.bind(this),this._onTouchMove=iw.bind(this),this._onMouseDown=Kb.bind(this),this._onMouseMove=Qb.bind(this),this._interceptControlDown=sw.bind(this),this._interceptControlUp=aw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Lf),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;nn.copy(t).sub(this.target),nn.applyQuaternion(this._quat),this._spherical.setFromVector3(nn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=Cn:n>Math.PI&&(n-=Cn),r<-Math.PI?r+=Cn:r>Math.PI&&(r-=Cn),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let a=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let l=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),a=l!=this._spherical.radius}if(nn.setFromSpherical(this._spherical),nn.applyQuaternion(this._quatInverse),t.copy(this.target).add(nn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let l=null;if(this.object.isPerspectiveCamera){let c=nn.length();l=this._clampDistance(c*this._scale);let f=c-l;this.object.position.addScaledVector(this._dollyDirection,f),this.object.updateMatrixWorld(),a=!!f}else if(this.object.isOrthographicCamera){let c=new j(this._mouse.x,this._mouse.y,0);c.unproject(this.object);let f=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),a=f!==this.object.zoom;let u=new j(this._mouse.x,this._mouse.y,0);u.unproject(this.object),this.object.position.sub(u).add(c),this.object.updateMatrixWorld(),l=nn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;l!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(l).add(this.object.position):(kl.origin.copy(this.object.position),kl.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(kl.direction))<Yb?this.object.lookAt(this.target):(Ff.setFromNormalAndCoplanarPoint(this.object.up,this.target),kl.intersectPlane(Ff,this.target))))}else if(this.object.isOrthographicCamera){let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),l!==this.object.zoom&&(this.object.updateProjectionMatrix(),a=!0)}return this._scale=1,this._performCursorZoom=!1,a||this._lastPosition.distanceToSquared(this.object.position)>Dh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Dh||this._lastTargetPosition.distanceToSquared(this.target)>Dh?(this.dispatchEvent(Lf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Cn/60*this.autoRotateSpeed*e:Cn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){nn.setFromMatrixColumn(t,0),nn.multiplyScalar(-e),this._panOffset.add(nn)}_panUp(e,t){this.screenSpacePanning===!0?nn.setFromMatrixColumn(t,1):(nn.setFromMatrixColumn(t,0),nn.crossVectors(this.object.up,nn)),nn.multiplyScalar(e),this._panOffset.add(nn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;nn.copy(r).sub(this.target);let a=nn.length();a*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*a/n.clientHeight,this.object.matrix),this._panUp(2*t*a/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=e-n.left,a=t-n.top,l=n.width,c=n.height;this._mouse.x=r/l*2-1,this._mouse.y=-(a/c)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Cn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Cn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(n,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,a=Math.sqrt(n*n+r*r);this._dollyStart.set(0,a)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),r=.5*(e.pageX+n.x),a=.5*(e.pageY+n.y);this._rotateEnd.set(r,a)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Cn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Cn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,a=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,a),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let l=(e.pageX+t.x)*.5,c=(e.pageY+t.y)*.5;this._updateZoomParameters(l,c)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function jb(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Zb(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function Jb(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Nf),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Kb(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ji.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=At.DOLLY;break;case ji.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}break;case ji.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Lh)}function Qb(i){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function ew(i){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(i.preventDefault(),this.dispatchEvent(Lh),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Nf))}function tw(i){this.enabled!==!1&&this._handleKeyDown(i)}function nw(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Zi.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(i),this.state=At.TOUCH_ROTATE;break;case Zi.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(i),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case Zi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=At.TOUCH_DOLLY_PAN;break;case Zi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Lh)}function iw(i){switch(this._trackPointer(i),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=At.NONE}}function rw(i){this.enabled!==!1&&i.preventDefault()}function sw(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function aw(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var fa=new j;function Hn(i,e,t,n,r,a){let l=2*Math.PI*r/4,c=Math.max(a-2*r,0),f=Math.PI/4;fa.copy(e),fa[n]=0,fa.normalize();let u=.5*l/(l+c),m=1-fa.angleTo(i)/f;return Math.sign(fa[t])===1?m*u:c/(l+c)+u+u*(1-m)}var Gl=class i extends di{constructor(e=1,t=1,n=1,r=2,a=.1){let l=r*2+1;if(a=Math.min(e/2,t/2,n/2,a),super(1,1,1,l,l,l),this.type="RoundedBoxGeometry",this.parameters={width:e,height:t,depth:n,segments:r,radius:a},l===1)return;let c=this.toNonIndexed();this.index=null,this.attributes.position=c.attributes.position,this.attributes.normal=c.attributes.normal,this.attributes.uv=c.attributes.uv;let f=new j,u=new j,m=new j(e,t,n).divideScalar(2).subScalar(a),v=this.attributes.position.array,g=this.attributes.normal.array,y=this.attributes.uv.array,M=v.length/6,A=new j,S=.5/l;for(let _=0,P=0;_<v.length;_+=3,P+=2)switch(f.fromArray(v,_),u.copy(f),u.x-=Math.sign(u.x)*S,u.y-=Math.sign(u.y)*S,u.z-=Math.sign(u.z)*S,u.normalize(),v[_+0]=m.x*Math.sign(f.x)+u.x*a,v[_+1]=m.y*Math.sign(f.y)+u.y*a,v[_+2]=m.z*Math.sign(f.z)+u.z*a,g[_+0]=u.x,g[_+1]=u.y,g[_+2]=u.z,Math.floor(_/M)){case 0:A.set(1,0,0),y[P+0]=Hn(A,u,"z","y",a,n),y[P+1]=1-Hn(A,u,"y","z",a,t);break;case 1:A.set(-1,0,0),y[P+0]=1-Hn(A,u,"z","y",a,n),y[P+1]=1-Hn(A,u,"y","z",a,t);break;case 2:A.set(0,1,0),y[P+0]=1-Hn(A,u,"x","z",a,e),y[P+1]=Hn(A,u,"z","x",a,n);break;case 3:A.set(0,-1,0),y[P+0]=1-Hn(A,u,"x","z",a,e),y[P+1]=1-Hn(A,u,"z","x",a,n);break;case 4:A.set(0,0,1),y[P+0]=1-Hn(A,u,"x","y",a,e),y[P+1]=1-Hn(A,u,"y","x",a,t);break;case 5:A.set(0,0,-1),y[P+0]=Hn(A,u,"x","y",a,e),y[P+1]=1-Hn(A,u,"y","x",a,t);break}}static fromJSON(e){return new i(e.width,e.height,e.depth,e.segments,e.radius)}};var Vl=class extends dr{constructor(){super(),this.name="RoomEnvironment",this.position.y=-3.5;let e=new di;e.deleteAttribute("uv");let t=new Ri({side:dn}),n=new Ri,r=new Ys(16777215,900,28,2);r.position.set(.418,16.199,.3),this.add(r);let a=new Ot(e,t);a.position.set(-.757,13.219,.717),a.scale.set(31.713,28.305,28.591),this.add(a);let l=new Us(e,n,6),c=new Qt;c.position.set(-10.906,2.009,1.846),c.rotation.set(0,-.195,0),c.scale.set(2.328,7.905,4.651),c.updateMatrix(),l.setMatrixAt(0,c.matrix),c.position.set(-5.607,-.754,-.758),c.rotation.set(0,.994,0),c.scale.set(1.97,1.534,3.955),c.updateMatrix(),l.setMatrixAt(1,c.matrix),c.position.set(6.167,.857,7.803),c.rotation.set(0,.561,0),c.scale.set(3.927,6.285,3.687),c.updateMatrix(),l.setMatrixAt(2,c.matrix),c.position.set(-2.017,.018,6.124),c.rotation.set(0,.333,0),c.scale.set(2.002,4.566,2.064),c.updateMatrix(),l.setMatrixAt(3,c.matrix),c.position.set(2.291,-.756,-2.621),c.rotation.set(0,-.286,0),c.scale.set(1.546,1.552,1.496),c.updateMatrix(),l.setMatrixAt(4,c.matrix),c.position.set(-2.193,-.369,-5.547),c.rotation.set(0,.516,0),c.scale.set(3.875,3.487,2.986),c.updateMatrix(),l.setMatrixAt(5,c.matrix),this.add(l);let f=new Ot(e,rs(50));f.position.set(-16.116,14.37,8.208),f.scale.set(.1,2.428,2.739),this.add(f);let u=new Ot(e,rs(50));u.position.set(-16.109,18.021,-8.207),u.scale.set(.1,2.425,2.751),this.add(u);let m=new Ot(e,rs(17));m.position.set(14.904,12.198,-1.832),m.scale.set(.15,4.265,6.331),this.add(m);let v=new Ot(e,rs(43));v.position.set(-.462,8.89,14.52),v.scale.set(4.38,5.441,.088),this.add(v);let g=new Ot(e,rs(20));g.position.set(3.235,11.486,-12.541),g.scale.set(2.5,2,.1),this.add(g);let y=new Ot(e,rs(100));y.position.set(0,20,0),y.scale.set(1,.1,1),this.add(y)}dispose(){let e=new Set;this.traverse(t=>{t.isMesh&&(e.add(t.geometry),e.add(t.material))});for(let t of e)t.dispose()}};function rs(i){return new Hs({color:0,emissive:16777215,emissiveIntensity:i})}var Uf=14477040,ow=["#edf1f6","#cfd7e1"],lw=15113984,Bf=.5,cw=.3,hw=.05,[uw,dw,fw,pw,mw,gw]=[2,3,4,5,6,7],_w=3,Hl=class{constructor(e,t,n){let{scale:r}=t;Object.assign(this,{canvas:e,robot:t,scale:r,covered:n,follow:!0,robots:[]}),this.target=new j(0,0,t.height),this.aside=new j,this.renderer=new Ul({canvas:e,antialias:!0}),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),Object.assign(this,{frames:0,frameTime:0}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=pr,this.renderer.toneMapping=ea,this.scene=new dr,this.scene.background=new ht(Uf),this.scene.fog=new Ps(Uf,4*r,16*r),this.scene.environment=new ns(this.renderer).fromScene(new Vl,.04).texture,this.scene.environmentIntensity=.62,this.world=this.scene.add(new Gn).children.at(-1),this.camera=new _n(38,1,.01*r,60*r),this.camera.up.set(0,0,1),this.orbit=new zl(this.camera,e),Object.assign(this.orbit,{enableDamping:!0,enablePan:!1,minDistance:.3*r,maxDistance:6*r,maxPolarAngle:1.52}),this.resetCamera(),this.light=new Zs(16777215,2.8),this.light.castShadow=!0,this.light.shadow.mapSize.set(1024,1024),Object.assign(this.light.shadow.camera,{left:-r,right:r,top:r,bottom:-r,near:.1,far:6*r}),Object.assign(this.light.shadow,{radius:4,bias:-5e-4,normalBias:.01*r}),this.scene.add(this.light,this.light.target);let a=new ks(bw());a.colorSpace=gn,a.wrapS=a.wrapT=zr,a.anisotropy=this.renderer.capabilities.getMaxAnisotropy(),this.floor=new Ri({map:a,roughness:.95,envMapIntensity:.6}),this.uneven=Sw(this.floor),this.arrow=new Ks(new j(1,0,0),new j,.3*r,lw,.12*r,.09*r),this.arrow.visible=!1,this.world.add(this.arrow),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;if(!e||!t)return;this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.fov=38*Math.min(1.5,Math.max(1,1/this.camera.aspect));let{top:n,right:r,bottom:a}=this.covered();this.reach=Math.tan(this.camera.fov*Math.PI/360)*Math.min(e-r,t-n-a)/t,this.camera.setViewOffset(e,t,r/2,(a-n)/2,e,t)}resetCamera(e=1){this.camera.position.copy(this.target).add(new j(.75,-1.25,.6).multiplyScalar(e*this.scale)),this.zoom=1}setTerrain(e){this.ground?.traverse(r=>r.geometry?.dispose()),this.ground?.removeFromParent(),this.ground=new Gn;let t=80*this.scale,n=new Xi(t,t);if(Of(n,this.scale),this.plane=new Ot(n,this.floor),this.plane.receiveShadow=!0,this.ground.add(this.plane),e.grid){let{shape:[r,a],extent:l,lowest:c,span:f}=e.grid,u=new Xi(...l,a-1,r-1),m=u.attributes.position;for(let v=0;v<m.count;v++){let g=r-1-Math.floor(v/a);m.setZ(v,c+f*e.heights[g*a+v%a])}Of(u,this.scale),Mw(u),this.ground.add(Object.assign(new Ot(u,this.uneven),{receiveShadow:!0})),this.plane.position.z=c-.01*this.scale}this.world.add(this.ground)}setSlope(e){this.world.rotation.y=-e}setRobots(e,t){for(let n of this.robots)n.group.removeFromParent();this.robots=e.map((n,r)=>new Nh(n,t[r],this.robot));for(let n of this.robots)this.world.add(n.group)}record(){for(let e of this.robots)e.record()}draw(e,t){this.saveTime(t);for(let u of this.robots)u.place(e);let[n,r]=this.robots.map(u=>new j(...u.position(e))),{x:a,y:l}=n,c=this.world.localToWorld(n.clone());this.follow&&this.followRobots(n,r,t),this.orbit.target.copy(this.target),this.orbit.update(),this.light.target.position.copy(c),this.light.position.copy(c).add(new j(.7,-.7,2.2).multiplyScalar(this.scale));let f=2*Bf*this.scale;this.plane.position.setX(f*Math.round(a/f)).setY(f*Math.round(l/f)),this.arrow.visible&&(this.arrow.left-=t)<0&&(this.arrow.visible=!1),this.renderer.render(this.scene,this.camera)}followRobots(e,t,n){let{scale:r,target:a,camera:l}=this,c=t?t.clone().sub(e):new j;this.aside.lerp(c.clone().multiplyScalar(.5),Math.min(1,3*n));let f=this.world.localToWorld(e.clone().add(this.aside)).sub(a);f.z*=Math.min(1,4*n),a.add(f);let u=l.position.clone().add(f).sub(a),m=u.length()/this.zoom,v=t?(c.length()/2+cw*r)/this.reach:0,g=this.zoom+(Math.max(1,v/m)-this.zoom)*Math.min(1,3*n);l.position.copy(a).addScaledVector(u,g/this.zoom),this.zoom=g}saveTime(e){this.frameTime+=(Math.min(e,.2)-this.frameTime)/10;let t=this.renderer.getPixelRatio();++this.frames<30||this.frameTime<hw||t<.5||(this.frames=0,this.renderer.setPixelRatio(.7*t))}showPush(e,t){let{scale:n}=this,[r,a,l]=this.robots[e].position(1),c=new j(...t).normalize();this.arrow.position.set(r,a,l).addScaledVector(c,-.5*n),this.arrow.setDirection(c),Object.assign(this.arrow,{visible:!0,left:.5})}pick(e,t){let n=new Js,{width:r,height:a}=this.canvas.getBoundingClientRect();n.setFromCamera(new tt(2*e/r-1,1-2*t/a),this.camera);let[l]=n.intersectObjects(this.robots.map(u=>u.group));if(!l)return null;let c=this.robots.findIndex(u=>u.meshes.includes(l.object)),f=n.ray.direction.clone().applyQuaternion(this.world.quaternion.clone().invert()).setZ(0).normalize();return{index:c,direction:f.toArray()}}},Nh=class{constructor(e,t,n){this.simulation=e,this.group=new Gn,this.meshes=[];let{model:r}=e;this.bodies=Array.from({length:r.nbody},()=>this.group.add(new Gn).children.at(-1));for(let a=0;a<r.ngeom;a++){let l=r.geom_bodyid[a],c=l&&r.geom_group[a]<_w?vw(r,a):null;if(!c)continue;let f=new Ot(c,xw(r,a,t));f.position.fromArray(r.geom_pos,3*a),f.quaternion.copy(Fh(r.geom_quat,a)),f.castShadow=f.receiveShadow=!0,this.bodies[l].add(f),this.meshes.push(f)}for(let{site:a,colour:l}of t?[]:n.legs){let c=e.mujoco.mj_name2id(r,e.mujoco.mjtObj.mjOBJ_SITE.value,a),f=new Ot(new fr(1.06*n.foot_radius,32,16),kf(new ht(l)));f.position.fromArray(r.site_pos,3*c),f.castShadow=!0,this.bodies[r.site_bodyid[c]].add(f),this.meshes.push(f)}this.record()}record(){let{xpos:e,xquat:t}=this.simulation.data;this.before=this.now??{xpos:e.slice(),xquat:t.slice()},this.now={xpos:e.slice(),xquat:t.slice()}}place(e){this.bodies.forEach((t,n)=>{t.position.fromArray(this.before.xpos,3*n).lerp(new j().fromArray(this.now.xpos,3*n),e),t.quaternion.copy(Fh(this.before.xquat,n)).slerp(Fh(this.now.xquat,n),e)})}position(e){let t=3*this.simulation.base;return[0,1,2].map(n=>(1-e)*this.before.xpos[t+n]+e*this.now.xpos[t+n])}},Fh=(i,e)=>new bn(i[4*e+1],i[4*e+2],i[4*e+3],i[4*e]);function vw(i,e){let[t,n,r]=i.geom_size.slice(3*e,3*e+3);switch(i.geom_type[e]){case uw:return new fr(t,32,16);case dw:return new Vs(t,2*n,8,24).rotateX(Math.PI/2);case fw:return new fr(1,32,16).scale(t,n,r);case pw:return new qr(t,t,2*n,32).rotateX(Math.PI/2);case mw:return new Gl(2*t,2*n,2*r,4,.2*Math.min(t,n,r));case gw:return yw(i,i.geom_dataid[e]);default:return null}}function yw(i,e){let{mesh_vert:t,mesh_vertadr:n,mesh_vertnum:r,mesh_face:a,mesh_faceadr:l,mesh_facenum:c}=i,f=new En,u=n[e],m=l[e];return f.setAttribute("position",new Tn(t.slice(3*u,3*(u+r[e])),3)),f.setIndex(Array.from(a.slice(3*m,3*(m+c[e])))),f.computeVertexNormals(),f}function xw(i,e,t){let n=i.geom_matid[e],[r,a,l]=n>=0?i.mat_rgba.slice(4*n,4*n+3):i.geom_rgba.slice(4*e,4*e+3),c=new ht().setRGB(r,a,l,gn);return t&&c.lerp(new ht(t.colour),t.share),kf(c)}var kf=i=>new Ri({color:i,roughness:.5,metalness:.05});function Sw(i){let e=Object.assign(i.clone(),{vertexColors:!0,flatShading:!0});return e.onBeforeCompile=t=>{t.fragmentShader=t.fragmentShader.replace("#include <normal_fragment_begin>",`#include <normal_fragment_begin>
      diffuseColor.rgb *= 1.0 - 0.5 * min(1.0, 16.0 * (1.0 - dot(normal, (viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz)));`)},e}function Mw(i){let{position:e}=i.attributes,t=new Float32Array(3*e.count);i.computeBoundingBox();let{min:{z:n},max:{z:r}}=i.boundingBox;for(let a=0;a<e.count;a++){let l=(r-e.getZ(a))/(r-n),c=1-.2*l;t.set([c*(1-.06*l),c*(1-.02*l),c],3*a)}i.setAttribute("color",new Tn(t,3))}function Of(i,e){let{position:t,uv:n}=i.attributes,r=2*Bf*e;for(let a=0;a<t.count;a++)n.setXY(a,t.getX(a)/r,t.getY(a)/r)}function bw(){let i=document.createElement("canvas"),e=256,t=e/2;i.width=i.height=e;let n=i.getContext("2d");for(let[r,a]of ow.entries())n.fillStyle=a,n.fillRect(0,r*t,t,t),n.fillRect(t,(1-r)*t,t,t);return i}var pa=class{constructor({name:e,xml:t,heights:n}){if(Object.assign(this,{name:e,xml:t,grid:n??null,heights:null}),n){let r=new Uint16Array(Uint8Array.from(atob(n.data),a=>a.charCodeAt(0)).buffer);this.heights=Float32Array.from(r,a=>a/65535)}}highest(e,t,n){if(!this.grid)return 0;let{shape:[r,a],extent:l,lowest:c,span:f}=this.grid,u=g=>(g+l[0]/2)/l[0]*(a-1),m=g=>(g+l[1]/2)/l[1]*(r-1),v=-1/0;for(let g=Math.max(0,Math.floor(m(t-n)));g<=Math.min(r-1,Math.ceil(m(t+n)));g++)for(let y=Math.max(0,Math.floor(u(e-n)));y<=Math.min(a-1,Math.ceil(u(e+n)));y++)v=Math.max(v,this.heights[g*a+y]);return v===-1/0?0:c+f*v}};var Uh=2*Math.PI,ww="gait_swing",ma=class{constructor(e,t,n){Object.assign(this,{simulation:e,graph:t,control:n}),this.amplitude=this.frequency=1,this.reset()}reset(e,t=this.control.command_rate.map(()=>0)){this.simulation.reset(e),this.command=Float64Array.from(t),this.requested=[...t],this.memory={last_action:new Float32Array(this.simulation.play.length),gait_phase:Float32Array.of(0),observation_history:new Float32Array(this.graph.inputs.observation_history?.length??0).fill(NaN)},this.time=0}inputs(){let{simulation:e}=this;return{projected_gravity:e.projectedGravity(),angular_velocity:e.reading("angular_velocity_b"),joint_position:e.reading("joint_position"),joint_velocity:e.reading("joint_velocity"),command:this.command,...this.memory}}step(){let{simulation:e,graph:t,memory:n,frequency:r}=this,a=t.run(this.inputs(),{[ww]:this.amplitude});if(a.action&&n.last_action.set(a.action),a.next_observation_history&&n.observation_history.set(a.next_observation_history),a.next_gait_phase){let l=(a.next_gait_phase[0]-n.gait_phase[0]+Uh)%Uh;n.gait_phase[0]=r===1?a.next_gait_phase[0]:(n.gait_phase[0]+r*l)%Uh}e.step(a.joint_target),this.control.command_rate.forEach((l,c)=>{let f=this.requested[c]-this.command[c],u=l*this.control.timestep;this.command[c]=Math.abs(f)<=u?this.requested[c]:this.command[c]+Math.sign(f)*u}),this.time+=this.control.timestep}};var Oh=.56,Ew=1.5,Tw=.3,Aw=1.2,Bh={seconds:3,share:.25,slowest:.1},ga=class{constructor(e,t){Object.assign(this,{mujoco:e,content:t,scale:t.robot.scale,walkers:[]}),this.terrains=t.terrains.map(n=>new pa(n)),this.settings=this.standard(),this.compare=!1,this.learned=null,this.request=t.control.command_rate.map(()=>0),this.rebuild()}standard(){return{terrain:this.content.terrain,slope:0,friction:null,payload:0,amplitude:1,frequency:1}}get terrain(){return this.terrains.find(({name:e})=>e===this.settings.terrain)}rebuild(){for(let{simulation:a}of this.walkers)a.delete();let{mujoco:e,content:t,terrain:n}=this,r=[this.learned??new Ui(t.policy)];this.compare&&t.gait&&r.push(new Ui(t.gait)),this.walkers=r.map(a=>new ma(new ps(e,n,t.robot),a,t.control)),this.reset()}reset(){this.apply();let{height:e}=this.content.robot;this.walkers.forEach((t,n)=>{let r=this.walkers.length>1?(n-.5)*Oh*this.scale:0,a=[...this.content.robot.start];a[1]=r,a[2]=e+this.terrain.highest(0,r,.2*this.scale),t.reset(a),Object.assign(t,{travelled:0,falls:0,returned:0}),this.begin(t)}),this.time=0}begin(e){Object.assign(e,{downFor:0,speed:0,rate:0,left:0,stuck:!1}),this.watch(e)}watch(e){e.watched={from:e.simulation.position(),seconds:0,commanded:0}}apply(){let{slope:e,friction:t,payload:n,amplitude:r,frequency:a}=this.settings;for(let l of this.walkers)Object.assign(l,{amplitude:r,frequency:a}),l.simulation.setSlope(e),l.simulation.setPayload(n),t!==null&&l.simulation.setFriction(t)}step(){let{timestep:e,lateral:t}=this.content.control;this.time+=e;for(let n of this.walkers){let{simulation:r}=n;n.requested=[...this.request],n.step();let[a,l]=r.reading("linear_velocity_b"),[,,c]=r.reading("angular_velocity_b"),f=e/Tw;n.speed+=f*(a-n.speed),n.rate+=f*(c-n.rate),n.left+=f*(l-n.left),n.travelled+=Math.hypot(n.speed,t?n.left:0)*e,n.downFor=r.fallen()?n.downFor+e:0,this.watchProgress(n),n.downFor>Ew&&this.standUp(n)}this.keepTogether()}watchProgress(e){let{watched:t}=e,{timestep:n}=this.content.control;if(t.seconds+=n,t.commanded+=Math.hypot(e.command[0],e.command[2]??0)*n,t.seconds<Bh.seconds)return;let[r,a]=e.simulation.position(),l=Math.hypot(r-t.from[0],a-t.from[1]),c=t.commanded>Bh.slowest*this.scale*t.seconds;e.stuck=c&&l<Bh.share*t.commanded,this.watch(e)}keepTogether(){let[e,t]=this.walkers;if(!t)return;let[n,r]=e.simulation.position(),[a,l]=t.simulation.position(),c=e.simulation.yaw();Math.hypot(a-n,l-r)<Aw*this.scale||(t.returned+=1,this.place(t,n-Oh*this.scale*Math.sin(c),r+Oh*this.scale*Math.cos(c),c))}standUp(e){let{simulation:t}=e,[n,r]=t.position();e.falls+=1,this.place(e,n,r,t.yaw())}place(e,t,n,r){let a=[...this.content.robot.start];Number.isFinite(t+n+r)&&([a[0],a[1],a[3],a[6]]=[t,n,Math.cos(r/2),Math.sin(r/2)],a[2]=this.content.robot.height+this.terrain.highest(t,n,.2*this.scale)),e.reset(a),this.begin(e)}contacts(e=0){return Array.from(this.walkers[e].simulation.reading("foot_force"),t=>t>this.content.robot.contact)}};function zf(i,e){let{start:t,command:n,steps:r,end:a}=e.reference,l=new pa(e.terrains.find(({heights:m})=>!m)),c=new ps(i,l,e.robot),f=new ma(c,new Ui(e.policy),e.control);f.reset(t,n);let u=r;return m=>{for(;m>0&&u>0;m--,u--)f.step();if(u)return null;let[v,g]=[c.position(),a].map(([M,A])=>Math.hypot(M,A)),y={seconds:r*e.control.timestep,speed:n[0],here:v,there:g};return c.delete(),y}}var Cw=.8,Rw=.25,Pw=.1,Iw=4,Dw={colour:13983232,share:.72},Li=i=>document.getElementById(i);function Lw(){let i=Li("panel").getBoundingClientRect(),e=Li("hud").getBoundingClientRect();if(i.left>innerWidth/2)return{top:0,right:innerWidth-i.left,bottom:innerHeight-e.top};let t=i.width?i:Li("stick").getBoundingClientRect();return{top:e.bottom,right:0,bottom:innerHeight-t.top}}var zh=class{constructor(e,t,n,r){this.walk=new ga(e,t),Object.assign(this,{language:hc(),paused:!1,slow:!1,throttle:0,turn:0,left:0,checked:null}),this.view=new Hl(Li("view"),t.robot,Lw),this.feet=new Ba(Li("feet"),t.robot.legs,t.control.timestep),this.controls=new Oa(this),this.learning=new Va(this,n,r),this.check=zf(e,t),this.due=0,this.redraw(),this.controls.translate(),this.controls.steer(Cw,0)}redraw(){let{walk:e,view:t,feet:n}=this;t.setTerrain(e.terrain),t.setSlope(e.settings.slope),t.setRobots(e.walkers.map(({simulation:r})=>r),[null,Dw]),n.clear()}setPaused(e){this.paused=e,this.controls.showPaused(e)}setSlow(e){this.slow=e,this.controls.showSlow(e)}setLanguage(e){this.language=e,this.controls.translate()}set(e){Object.assign(this.walk.settings,e),this.walk.apply(),this.view.setSlope(this.walk.settings.slope)}setTerrain(e){this.walk.settings.terrain=e,this.walk.rebuild(),this.redraw()}setCompare(e){this.walk.compare=e,this.walk.rebuild(),this.redraw(),this.controls.show(),this.view.resize(),this.view.resetCamera(e?1.25:1)}learned(e,t){let{walk:n,controls:r}=this;r.limitTo(e&&[t.command[0],t.turns??0]),e!==n.learned&&(n.learned=e,n.rebuild(),this.redraw())}reset(){this.walk.reset(),this.redraw(),this.view.resetCamera()}push(e,t){for(let n of t)this.walk.walkers[n].simulation.push(e.map(r=>r*this.strength));this.view.showPush(t[0],e)}pushSomewhere(){let e=2*Math.PI*Math.random();this.push([Math.cos(e),Math.sin(e),0],[...this.walk.walkers.keys()])}step(e=1){for(let t=0;t<e;t++)this.walk.step(),this.view.record(),this.feet.record(this.walk.contacts()),this.learning.watch(this.walk.walkers[0],this.walk.content.control.timestep)}compare(e){this.checked||(this.checked=this.check(e),this.checked&&this.controls.showCheck())}frame(e){let{timestep:t}=this.walk.content.control;if(this.controls.pollGamepad(),!this.paused){this.due+=Math.min(e,Pw)*(this.slow?Rw:1);let n=Math.floor(this.due/t);this.step(n),this.due-=n*t}this.compare(Iw),this.view.draw(this.due/t,e),this.feet.draw(),this.controls.show()}run(){let e=performance.now(),t=n=>{this.frame(Math.max(0,n-e)/1e3),e=n,requestAnimationFrame(t)};requestAnimationFrame(t)}};async function kh(i){let e=Uint8Array.from(atob(Li(i).textContent.trim()),t=>t.charCodeAt(0));return new Uint8Array(await new Response(new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer())}function Gf(i,...e){document.body.classList.add("failed"),Li("message").replaceChildren(...Object.keys(lc).map(t=>Object.assign(document.createElement("p"),{lang:t,textContent:Pn(t,i,...e)}))),Li("message").hidden=!1}async function Fw(){Object.assign(Li("message"),{hidden:!1,textContent:Pn(hc(),"loading")});let i=JSON.parse(new TextDecoder().decode(await kh("document"))),e=await kh("wasm"),t=new TextDecoder().decode(await kh("worker")),n=new zh(await Lu(e),i,t,e);window.quadruped={page:n,walk:n.walk,Graph:Ui,Walk:ga},n.run()}document.createElement("canvas").getContext("webgl2")?Fw().catch(i=>{throw Gf("failed",i.message??i),i}):Gf("no_webgl");
