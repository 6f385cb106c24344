import { it } from 'vitest';
import { readFileSync } from 'node:fs';
import { Simulation } from '#simulation/simulation';
import { parseScene } from '#scene/parse';
it('runs',async()=>{
 const fw=new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
 const [scene,main,secs]=process.env.PROBE!.split(' ');
 const p=parseScene(readFileSync(scene!,'utf8')) as any; if(p.problem) throw new Error(JSON.stringify(p));
 const t0=process.hrtime.bigint();
 const sim=await Simulation.create({scene:p.scene,files:{'main.py':readFileSync(main!,'utf8')},robot:'maqueen-lite',board:'auto',seed:1,reality:0},fw);
 const rows=[];
 for(let t=1;t<=+secs!;t++){ sim.advanceTo(t*1e6); const r=sim.snapshot().robot!; rows.push(`${t}s (${r.pose.xMm.toFixed(0)},${r.pose.yMm.toFixed(0)}) ${(r.pose.headingRad*180/Math.PI).toFixed(0)}° path ${r.pathMm.toFixed(0)} col ${r.collisions} [${r.state.lineSensors.map(l=>+l.bright)}]`); if(sim.ended) break; }
 console.log(rows.join('\n')); console.log('OUT',sim.takeConsole(), JSON.stringify(sim.ended), Number(process.hrtime.bigint()-t0)/1e9+'s');
}, 120000);
