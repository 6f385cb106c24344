// A small static server for dist/app: right types, compression and the headers that every host should send (docs/hosting.md).
import { readFile, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { networkInterfaces } from 'node:os';
import { extname, join, normalize, resolve, sep } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';
import { isNamedByContent } from './named-by-content.mjs';
import { Failure, main, root } from './progress.mjs';

const FIRST_PORT = 8080;
const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.py': 'text/plain; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
};
const COMPRESSIBLE = new Set(['.css', '.html', '.js', '.json', '.mjs', '.py', '.svg', '.txt', '.wasm', '.webmanifest']);

/**
 * The page may load its own files and compile WebAssembly, nothing else. Browsers older than Chrome 97 and Safari 16 know no
 * word for the latter but 'unsafe-eval'; in newer ones the policy that the page carries itself takes that back.
 */
export const PAGE_POLICY = [
  "default-src 'self'",
  // The one script inside the page, src/web/app/frame-check/frame-check.js, by its hash.
  "script-src 'self' 'sha256-gNC8psfq1R3r7qOfNVqv6uGWsceal7EvA4laI93TTFg=' 'wasm-unsafe-eval' 'unsafe-eval'",
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "connect-src 'self'",
  "worker-src 'self'",
  "object-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** The worker runs the pupil's program: it gets its code and the compiled VM from the page and reaches nothing itself. */
export const WORKER_POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval' 'unsafe-eval'; connect-src 'none'";

/** These carry a policy in themselves that is stricter and knows their script. */
const IS_SINGLE = /\.single\.html$/;
const IS_WORKER = /(^|\/)worker[^/]*\.m?js$/;

/**
 * Serves a folder.
 *
 * @param {{ folder?: string, port?: number, host?: string, lacks?: (request: import('node:http').IncomingMessage) => boolean }} [options]
 * port: the first one to try; a busy port moves on to the next; lacks: what is answered as if it were not there
 * @returns {Promise<{ url: string, others: readonly string[], close: () => Promise<void> }>} others: further addresses, which other
 * computers can open
 */
export async function serve({
  folder = 'dist/app',
  port = wantedPort(),
  host = process.env.HOST ?? '127.0.0.1',
  lacks = () => false,
} = {}) {
  const cache = new Map();
  const server = createServer((request, response) => {
    const done = lacks(request) ? notFound(response) : answer(resolve(root, folder), cache, request, response);
    done.catch((error) => {
      if (!response.headersSent) response.writeHead(500, { 'Content-Type': 'text/plain' });
      response.end(String(error));
    });
  });
  const chosen = await listen(server, port, host);
  const [url, ...others] = addressesOf(host).map((address) => `http://${address}:${chosen}/`);
  return {
    url,
    others,
    close: () =>
      new Promise((done) => {
        server.close(() => done());
        server.closeAllConnections();
      }),
  };
}

/**
 * The addresses that a browser can open: if the server listens everywhere, this computer's and its network addresses.
 */
function addressesOf(host) {
  if (host === '127.0.0.1') return ['localhost'];
  if (!['0.0.0.0', '::', ''].includes(host)) return [host.includes(':') ? `[${host}]` : host];
  const own = Object.values(networkInterfaces()).flat();
  // Addresses of IPv6 that are no use without their network card are left out.
  const outside = own.filter(
    ({ internal, family, scopeid }) => !internal && (family === 'IPv4' || (host !== '0.0.0.0' && !scopeid)),
  );
  return ['localhost', ...outside.map(({ address, family }) => (family === 'IPv4' ? address : `[${address}]`))];
}

/** The app's address, for people. */
export const atWords = ({ url, others }) =>
  [url, ...others.map((other) => `\n  for other computers: ${other}`)].join('');

function wantedPort() {
  const text = process.env.PORT;
  if (text === undefined || text === '') return FIRST_PORT;
  const port = Number(text);
  if (Number.isInteger(port) && port >= 0 && port <= 65_535) return port;
  throw new Failure(`PORT must be a whole number from 0 to 65535, not "${text}".`);
}

/** Listens on the port or, when it is taken, on one of the next hundred. */
function listen(server, port, host) {
  return new Promise((done, reject) => {
    let next = port;
    server.on('error', (error) => {
      if (error.code === 'EADDRINUSE' && next < Math.min(port + 100, 65_535)) server.listen(++next, host);
      else if (['ENOTFOUND', 'EADDRNOTAVAIL', 'EAI_AGAIN'].includes(error.code))
        reject(new Failure(`HOST must be an address or a name of this computer, or 0.0.0.0 for all, not "${host}".`));
      else reject(error);
    });
    server.on('listening', () => done(server.address().port));
    server.listen(next, host);
  });
}

async function notFound(response) {
  response.writeHead(404, { 'Content-Type': 'text/plain' }).end('Not found\n');
}

async function answer(folder, cache, request, response) {
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.writeHead(405, { Allow: 'GET, HEAD' }).end();
    return;
  }
  const path = pathOf(request.url ?? '/');
  const file = path === null ? null : await load(folder, path, cache);
  if (!file) return notFound(response);
  const [encoding, body] = await encoded(file, request.headers['accept-encoding'] ?? '');
  response.writeHead(200, {
    ...headersFor(path),
    'Content-Length': body.length,
    Vary: 'Accept-Encoding',
    ...(encoding && { 'Content-Encoding': encoding }),
  });
  response.end(request.method === 'HEAD' ? undefined : body);
}

/** The path inside the folder, or `null` for one that leads out of it or cannot be read. */
function pathOf(url) {
  try {
    const path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
    const inside = normalize(path).split(sep).join('/');
    if (inside.includes('\0') || inside.split('/').includes('..')) return null;
    return inside.endsWith('/') ? `${inside}index.html` : inside;
  } catch {
    return null;
  }
}

export function headersFor(path) {
  return {
    'Content-Type': TYPES[extname(path)] ?? 'application/octet-stream',
    ...(!IS_SINGLE.test(path) && { 'Content-Security-Policy': IS_WORKER.test(path) ? WORKER_POLICY : PAGE_POLICY }),
    'Cache-Control': isNamedByContent(path.slice(1)) ? 'public, max-age=31536000, immutable' : 'no-cache',
    'Referrer-Policy': 'no-referrer',
    'X-Content-Type-Options': 'nosniff',
  };
}

/** Reads a file once per version of it. */
async function load(folder, path, cache) {
  const place = join(folder, path);
  const found = await stat(place).catch(() => null);
  if (!found?.isFile()) return null;
  const known = cache.get(place);
  if (known?.changed === found.mtimeMs) return known;
  const encodings = COMPRESSIBLE.has(extname(place)) ? COMPRESSED : {};
  const file = { changed: found.mtimeMs, plain: await readFile(place), encodings, made: new Map() };
  cache.set(place, file);
  return file;
}

/** Ways to compress, the best first. */
const COMPRESSED = {
  // A higher quality takes seconds for the VM and saves 5 %.
  br: (plain) => promisify(brotliCompress)(plain, { params: { [constants.BROTLI_PARAM_QUALITY]: 6 } }),
  gzip: (plain) => promisify(gzip)(plain, { level: 6 }),
};

/** The best encoding that the browser accepts, and the file in it, which is compressed once. */
async function encoded({ plain, encodings, made }, accepted) {
  const encoding = Object.keys(encodings).find((one) => new RegExp(`\\b${one}\\b`).test(accepted));
  if (encoding === undefined) return [null, plain];
  if (!made.has(encoding)) made.set(encoding, encodings[encoding](plain));
  return [encoding, await made.get(encoding)];
}

await main(import.meta.url, async () => {
  process.stdout.write(`Serving dist/app at ${atWords(await serve())}\n`);
});
