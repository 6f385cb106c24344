import { build, loadConfigFromFile } from 'vite';
import { gzipSync } from 'node:zlib';
import { writeFileSync } from 'node:fs';
process.chdir(process.argv[2]);
const report = { name:'report', enforce:'post', generateBundle(_, bundle){ console.log('GB', Object.keys(bundle).length);
  if (globalThis.done) return;
  const chunks = Object.values(bundle).filter(c=>c.type==='chunk');
  const all={}; for (const c of chunks){ all[c.fileName]={gz:gzipSync(c.code,{level:9}).length, entry:c.isEntry, imports:c.imports, dyn:c.dynamicImports, modules:Object.fromEntries(Object.entries(c.modules).map(([m,i])=>[m.replace(process.cwd(),''),[i.renderedLength, i.code?gzipSync(i.code).length:0]]))}; }
  if (chunks.length<20) return; writeFileSync(process.argv[3], JSON.stringify(all));
}};
await build({ configFile:'vite.config.ts', logLevel:'silent', build:{outDir:'/tmp/sizes-out',emptyOutDir:true}, plugins:[report]});
