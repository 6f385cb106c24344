import { chromium } from 'playwright-core';
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import { headersFor } from './scripts/serve.mjs';
const dir=process.argv[2];
const got=new Map();
const server=createServer(async(q,r)=>{const name=q.url.replace(/\?.*/,'').replace(/\/$/,'/index.html');try{const b=await readFile(dir+name);const comp=/\.(css|html|js|json|mjs|svg|txt|wasm|webmanifest)$/.test(name);const out=comp?gzipSync(b):b;got.set(name,out.length);r.writeHead(200,{...headersFor(name),...(comp&&{'Content-Encoding':'gzip'})});r.end(out);}catch{r.writeHead(404).end();}});
await new Promise(d=>server.listen(0,'127.0.0.1',d));
const browser=await chromium.launch({executablePath:'/usr/bin/chromium'});
const page=await browser.newPage({viewport:{width:1280,height:800}});
await page.goto(`http://127.0.0.1:${server.address().port}/`);
await page.waitForSelector('.cm-content',{timeout:60000});
await page.waitForTimeout(3000);
let sum=0;for(const [n,b] of [...got].sort((a,b)=>b[1]-a[1]))if(!/\.wasm$|\/worker[^/]*\.js$/.test(n)){sum+=b;console.log(b,n);}
console.log('SUM',sum);
await browser.close();server.closeAllConnections();server.close();
