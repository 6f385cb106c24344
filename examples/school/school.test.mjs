import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { unzipSync } from 'fflate';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { schoolFiles, schoolZip } from '../../scripts/school-zip.mjs';
import { headersFor, PAGE_POLICY, WORKER_POLICY } from '../../scripts/serve.mjs';
import { askForAll, findingsIn } from './judge.js';
import { texts } from './texts.js';

const APP = {
  'index.html': '<!doctype html>',
  'parcours.single.html': '<!doctype html>',
  'logo.svg': '<svg/>',
  'manifest.webmanifest': '{}',
  'sw.js': '// worker',
  'LICENSES.txt': 'MIT',
  'assets/index-DEADbeef.js': `// ${'long '.repeat(8000)}`,
  'assets/worker-DEADbeef.js': '// worker',
  'assets/vm-DEADbeef.wasm': 'wasm',
  'firmware/firmware.json': '{}',
};
let folder = '';
let files = new Map();
beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'school-'));
  for (const [name, text] of Object.entries(APP)) {
    await mkdir(dirname(join(folder, name)), { recursive: true });
    await writeFile(join(folder, name), text);
  }
  files = await schoolFiles(folder);
});
afterAll(() => rm(folder, { recursive: true }));

/** The faults that are found on a server whose answers are changed. @param change (name, answer) → another answer */
async function found(change = (_, answer) => answer) {
  const server = createServer((request, response) => {
    const name = request.url.slice(1).replace(/\?.*/, '');
    const bytes = files.get(`parcours/${name}`);
    const right = {
      status: bytes ? 200 : 404,
      headers: headersFor(`/${name}`),
      bytes: bytes ?? Buffer.from('no'),
      packs: true,
    };
    const { status, headers, bytes: sent, packs } = change(name, right);
    response.writeHead(status, { ...headers, ...(packs && { 'Content-Encoding': 'gzip' }) });
    response.end(packs ? gzipSync(sent) : sent);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const ask = (file) => fetch(`http://127.0.0.1:${server.address().port}/${file}?check=1`);
  const list = await (await ask('files.json')).json();
  const counted = [];
  const findings = findingsIn(await askForAll(list, ask, (done) => counted.push(done)), list.policies);
  server.closeAllConnections();
  await new Promise((done) => server.close(done));
  expect(counted.at(-1)).toBe(list.files.length);
  return Object.fromEntries(
    findings.filter(({ state }) => state !== 'ok').map((one) => [one.id, [one.state, ...one.files]]),
  );
}
const withHeaders = (headers) => (_, answer) => ({ ...answer, headers: { ...answer.headers, ...headers } });
const onlyOn = (wanted, change) => (name, answer) => (name === wanted ? { ...answer, ...change(answer) } : answer);

describe('the zip for a school', () => {
  it('has the app, its list, the check, the headers for Apache and nginx, and a readme in four languages', () => {
    const names = Object.keys(unzipSync(schoolZip(files)));
    expect(names.filter((name) => !name.includes('/'))).toEqual(['LIES-MICH.txt', 'LISEZ-MOI.txt', 'LEGGIMI.txt', 'README.txt', 'nginx.conf']); // prettier-ignore
    for (const name of ['index.html', 'check.html', 'judge.js', 'files.json', '.htaccess', 'assets/vm-DEADbeef.wasm'])
      expect(names).toContain(`parcours/${name}`);
    expect(names.some((name) => name.includes('firmware'))).toBe(false);
    const htaccess = new TextDecoder().decode(files.get('parcours/.htaccess'));
    expect(htaccess).toContain(`"${PAGE_POLICY}"`);
    expect(htaccess).toContain(`"${WORKER_POLICY}"`);
  });

  it('is the same for the same app', () => expect(schoolZip(files)).toEqual(schoolZip(files)));

  it('says each finding in four languages', () => {
    const shape = (value) => (typeof value === 'string' ? '' : Object.fromEntries(Object.entries(value).map(([key, one]) => [key, shape(one)]))); // prettier-ignore
    for (const language of ['de', 'fr', 'it']) expect(shape(texts[language])).toEqual(shape(texts.en));
    const told = Object.keys(texts.en.findings);
    for (const { id } of findingsIn([], { page: '', worker: '' })) expect(told).toContain(id);
  });
});

describe('the check of a server', () => {
  it('finds nothing on one that is set up as the documentation says', async () => expect(await found()).toEqual({}));

  it.each([
    ['a file is missing', onlyOn('logo.svg', () => ({ status: 404 })), { missing: ['bad', 'logo.svg'] }],
    [
      'a file was uploaded as text',
      onlyOn('assets/vm-DEADbeef.wasm', ({ bytes }) => ({ bytes: bytes.slice(1) })),
      { length: ['bad', 'assets/vm-DEADbeef.wasm'] },
    ],
    [
      'it does not know WebAssembly',
      onlyOn('assets/vm-DEADbeef.wasm', ({ headers }) => ({
        headers: { ...headers, 'Content-Type': 'application/octet-stream' },
      })),
      { types: ['bad', 'assets/vm-DEADbeef.wasm'] },
    ],
    [
      'it packs nothing',
      (_, answer) => ({ ...answer, packs: false }),
      { compression: ['warn', 'assets/index-DEADbeef.js'] },
    ],
    [
      'it keeps all for a day',
      withHeaders({ 'Cache-Control': 'max-age=86400' }),
      { stale: ['bad', 'LICENSES.txt', 'index.html', 'logo.svg', 'manifest.webmanifest', 'parcours.single.html'] },
    ],
    [
      'it says nothing on what is kept',
      (_, { headers: { 'Cache-Control': _gone, ...headers }, ...answer }) => ({ ...answer, headers }),
      {
        fresh: ['warn', 'index.html', 'logo.svg', 'manifest.webmanifest', 'parcours.single.html', 'sw.js'],
        kept: ['warn', 'assets/index-DEADbeef.js', 'assets/vm-DEADbeef.wasm', 'assets/worker-DEADbeef.js'],
      },
    ],
    [
      'it has a policy for all its pages',
      withHeaders({ 'Content-Security-Policy': "default-src 'self'" }),
      {
        blocked: ['bad', 'assets/worker-DEADbeef.js', 'index.html', 'parcours.single.html', 'check.html'],
        policy: ['warn', 'assets/worker-DEADbeef.js'],
      },
    ],
    [
      'it sends no policy',
      (_, { headers: { 'Content-Security-Policy': _gone, ...headers }, ...answer }) => ({ ...answer, headers }),
      { policy: ['warn', 'assets/worker-DEADbeef.js', 'index.html', 'check.html'] },
    ],
    [
      'it forbids USB',
      onlyOn('index.html', ({ headers }) => ({ headers: { ...headers, 'Permissions-Policy': 'usb=(), camera=()' } })),
      { boards: ['bad', 'index.html'] },
    ],
  ])('says so where %s', async (_, change, wrong) => expect(await found(change)).toEqual(wrong));
});
