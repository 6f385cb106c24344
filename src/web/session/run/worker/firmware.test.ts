import { afterEach, describe, expect, it, vi } from 'vitest';

import { compile } from './firmware';
import { troubleOf } from './firmware-trouble';

const WASM = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/** The trouble with the VM if the server gives this answer. */
async function troubleAt(answer: () => Response | Promise<Response>): Promise<string> {
  vi.stubGlobal('fetch', () => Promise.resolve().then(answer));
  return compile('https://school.example/vm.wasm').then(() => 'none', troubleOf);
}

const answer = (body: Uint8Array<ArrayBuffer> | string, type: string, status = 200): Response =>
  new Response(body, { status, headers: { 'Content-Type': type } });

describe('the VM on its way', () => {
  afterEach(() => vi.unstubAllGlobals());

  it('is compiled under its own type, and where the host names none', async () => {
    expect(await troubleAt(() => answer(WASM, 'application/wasm'))).toBe('none');
    expect(await troubleAt(() => answer(WASM, 'application/octet-stream'))).toBe('none');
  });

  it('is absent without a network, where the file is not there, and where it is cut', async () => {
    expect(await troubleAt(() => Promise.reject(new TypeError('Failed to fetch')))).toBe('absent');
    expect(await troubleAt(() => answer('Not found', 'text/html', 404))).toBe('absent');
    expect(await troubleAt(() => answer(WASM.slice(0, 5), 'application/wasm'))).toBe('absent');
  });

  it('is told apart from a web page in its place', async () => {
    expect(await troubleAt(() => answer('<!doctype html><title>Filter</title>', 'text/html'))).toBe('foreign');
  });

  it('is forbidden where nothing may be compiled', async () => {
    vi.stubGlobal('WebAssembly', {
      Module: class {
        constructor() {
          throw new EvalError('blocked by the content policy');
        }
      },
    });
    expect(await troubleAt(() => answer(WASM, 'application/wasm'))).toBe('forbidden');
  });
});
