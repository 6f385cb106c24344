import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { frameCheckParts, scriptHash } from './frame-check.mjs';
import { PAGE_POLICY, serve } from './serve.mjs';

let folder;
let server;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'parcours-served-'));
  await mkdir(join(folder, 'assets'));
  await writeFile(join(folder, 'index.html'), '<!doctype html>'.repeat(100));
  await writeFile(join(folder, 'assets/worker-DEADbeef.js'), 'export {};');
  await writeFile(join(folder, 'assets/vm-DEADbeef.wasm'), new Uint8Array(64));
  await writeFile(join(folder, 'secret.txt'), 'inside');
  for (const name of ['parcours.single.html', 'sw.js', 'manifest.webmanifest'])
    await writeFile(join(folder, name), '{}');
  server = await serve({ folder, port: 0 });
});

afterAll(async () => {
  await server.close();
  await rm(folder, { recursive: true });
});

const get = (path, headers = {}) => fetch(new URL(path, server.url), { headers });

/** `fetch` tidies paths up before it sends them; this sends them as they are. */
const statusOfRaw = (path) =>
  new Promise((resolve, reject) => {
    const { port } = new URL(server.url);
    request({ host: '127.0.0.1', port, path }, (response) => resolve(response.resume().statusCode))
      .on('error', reject)
      .end();
  });

describe('the server', () => {
  it('lets the page load its own files and compile WebAssembly, nothing else', async () => {
    const policy = (await get('/')).headers.get('content-security-policy');
    expect(policy).toContain("default-src 'self'; script-src 'self'");
  });

  it('knows the one script that stands in the page itself', async () => {
    const { script } = await frameCheckParts();
    expect(PAGE_POLICY).toContain(`script-src 'self' ${scriptHash(script)} 'wasm-unsafe-eval' 'unsafe-eval'`);
  });

  it('leaves the single file its own policy', async () => {
    const { headers } = await get('/parcours.single.html');
    expect(headers.get('content-security-policy')).toBeNull();
    expect(headers.get('cache-control')).toBe('no-cache');
  });

  it('has the service worker and the manifest asked for again, under their right types', async () => {
    const worker = (await get('/sw.js')).headers;
    expect(worker.get('content-type')).toContain('text/javascript');
    expect(worker.get('cache-control')).toBe('no-cache');
    expect((await get('/manifest.webmanifest')).headers.get('content-type')).toBe('application/manifest+json');
  });

  it('gives the worker no connection at all', async () => {
    const { headers } = await get('/assets/worker-DEADbeef.js');
    expect(headers.get('content-security-policy')).toContain("connect-src 'none'");
    expect(headers.get('content-type')).toContain('text/javascript');
  });

  it('names the type that WebAssembly needs to be compiled while it streams in', async () => {
    expect((await get('/assets/vm-DEADbeef.wasm')).headers.get('content-type')).toBe('application/wasm');
  });

  it('compresses text and says so', async () => {
    const answer = await get('/', { 'Accept-Encoding': 'gzip' });
    expect(answer.headers.get('content-encoding')).toBe('gzip');
    expect(await answer.text()).toContain('<!doctype html>');
  });

  it('lets hashed files be kept for a year and the page be asked for again', async () => {
    expect((await get('/assets/vm-DEADbeef.wasm')).headers.get('cache-control')).toContain('immutable');
    expect((await get('/index.html')).headers.get('cache-control')).toBe('no-cache');
  });

  it('gives nothing outside its folder', async () => {
    for (const path of [
      '/../package.json',
      '/%2e%2e/package.json',
      '/..%2fpackage.json',
      '/assets/../../x',
      '/%00',
      '/%zz',
    ]) {
      expect([path, await statusOfRaw(path)]).toEqual([path, 404]);
    }
  });

  it.each(['0.0.0.0', '::'])('names addresses that other computers can open where it listens on %s', async (host) => {
    const everywhere = await serve({ folder, port: 0, host });
    expect(everywhere.url).toMatch(/^http:\/\/localhost:\d+\/$/);
    for (const address of [everywhere.url, ...everywhere.others]) {
      expect(new URL(address).hostname).not.toMatch(/^(0\.0\.0\.0|\[::\])$/);
      expect((await fetch(address)).status).toBe(200);
    }
    await everywhere.close();
  });

  it('says what HOST may be when there is no such address', async () => {
    await expect(serve({ folder, port: 0, host: '192.0.2.1' })).rejects.toThrow(
      'HOST must be an address or a name of this computer, or 0.0.0.0 for all, not "192.0.2.1".',
    );
  });

  it('moves on to the next port when one is taken', async () => {
    const taken = Number(new URL(server.url).port);
    const second = await serve({ folder, port: taken });
    expect(Number(new URL(second.url).port)).toBeGreaterThan(taken);
    await second.close();
  });
});
