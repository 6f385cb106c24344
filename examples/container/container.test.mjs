import { execFileSync, spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { chmod, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { root } from '../../scripts/progress.mjs';
import { PAGE_POLICY, WORKER_POLICY } from '../../scripts/serve.mjs';

const read = (path) => readFile(join(root, path), 'utf8');
const CONF = await read('examples/container/nginx.conf');
const FILES = {
  'index.html': '<!doctype html>',
  'parcours.single.html': '<!doctype html>',
  'manifest.webmanifest': '{}',
  'sw.js': '',
  'assets/worker-DEADbeef.js': '',
  'assets/index-DEADbeef.js': '',
  'assets/vm-DEADbeef.wasm': '',
};
const FOR_EVER = 'public, max-age=31536000, immutable';

describe('the recipe for a container', () => {
  it('sends the policies of our own server', () => {
    expect(CONF).toContain(`default "${PAGE_POLICY}";`);
    expect(CONF).toContain(`"${WORKER_POLICY}";`);
  });

  it('is the example that the documentation shows', async () => {
    expect(await read('docs/hosting.md')).toContain(`\`\`\`nginx\n${CONF}\`\`\``);
  });

  it('copies only what is there, and runs a script that there is', async () => {
    const steps = await read('examples/container/Dockerfile');
    for (const [, from] of steps.matchAll(/^COPY ([^-\s]\S*)/gm)) expect(existsSync(join(root, from)), from).toBe(true);
    const { scripts } = JSON.parse(await read('package.json'));
    for (const [, name] of steps.matchAll(/^RUN npm run (\S+)$/gm)) expect(Object.keys(scripts)).toContain(name);
  });
});

describe.skipIf(!hasNginx())('nginx with this configuration', () => {
  let folder;
  let server;
  let port;

  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'parcours-nginx-'));
    await chmod(folder, 0o755); // started by root, nginx reads as nobody
    await mkdir(join(folder, 'www/assets'), { recursive: true });
    for (const [name, text] of Object.entries(FILES)) await writeFile(join(folder, 'www', name), text);
    port = await freePort();
    const own = CONF.replace('listen 8080', `listen 127.0.0.1:${port}`).replace(
      '/usr/share/nginx/html',
      `${folder}/www`,
    );
    await writeFile(join(folder, 'nginx.conf'), wholeConf(folder, own));
    server = spawn('nginx', ['-p', folder, '-c', join(folder, 'nginx.conf'), '-e', join(folder, 'error.log')]);
    await answering(port);
  });

  afterAll(async () => {
    server.kill('SIGQUIT');
    await new Promise((resolve) => server.once('exit', resolve));
    await rm(folder, { recursive: true });
  });

  const headersOf = async (path) => {
    const { headers, status } = await fetch(`http://127.0.0.1:${port}/${path}`);
    expect(status, path).toBe(200);
    return headers;
  };

  it('sends each file as what it is', async () => {
    const types = {
      'index.html': 'text/html; charset=utf-8',
      'manifest.webmanifest': 'application/manifest+json',
      'sw.js': 'text/javascript; charset=utf-8',
      'assets/vm-DEADbeef.wasm': 'application/wasm',
    };
    for (const [path, type] of Object.entries(types)) expect((await headersOf(path)).get('content-type')).toBe(type);
  });

  it('holds the worker to a policy of its own, and the single file to none but its own', async () => {
    const policy = async (path) => (await headersOf(path)).get('content-security-policy');
    expect(await policy('index.html')).toBe(PAGE_POLICY);
    expect(await policy('assets/index-DEADbeef.js')).toBe(PAGE_POLICY);
    expect(await policy('assets/worker-DEADbeef.js')).toBe(WORKER_POLICY);
    expect(await policy('parcours.single.html')).toBeNull();
  });

  it('lets browsers keep only what changes its name with its content', async () => {
    const cache = async (path) => (await headersOf(path)).get('cache-control');
    expect(await cache('assets/worker-DEADbeef.js')).toBe(FOR_EVER);
    expect(await cache('index.html')).toBe('no-cache');
    expect(await cache('sw.js')).toBe('no-cache');
  });
});

function hasNginx() {
  try {
    execFileSync('nginx', ['-v'], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
}

/** The surroundings of the file in an installed nginx, in one folder that needs no rights. */
function wholeConf(folder, own) {
  const parts = ['client_body', 'proxy', 'fastcgi', 'uwsgi', 'scgi'].map(
    (name) => `${name}_temp_path ${folder}/${name};`,
  );
  return `daemon off; pid ${folder}/pid; events {} http { access_log off; ${parts.join(' ')}\n${own}\n}\n`;
}

function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

async function answering(port) {
  for (let tries = 0; tries < 200; tries++) {
    const there = await fetch(`http://127.0.0.1:${port}/`).then(
      () => true,
      () => false,
    );
    if (there) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  throw new Error('nginx did not start.');
}
