import { Readable } from 'node:stream';

import { describe, expect, it } from 'vitest';
import { build } from 'vite';

import { firmwareAwaited, toldSo } from './firmware-awaited.ts';

/** Builds a page that takes in the VM and something else, and lists the modules in the order in which the build reads them. */
async function building(made: () => Promise<void>): Promise<readonly string[]> {
  const read: string[] = [];
  const modules: Readonly<Record<string, string>> = {
    entry: "import url from 'firmware'; import { other } from 'other'; console.log(url, other);",
    firmware: "export { default } from '../.cache/vm/vm.wasm?url';",
    other: "export { deeper as other } from 'deeper';",
    deeper: 'export const deeper = 1;',
    wasm: 'export default "address";',
  };
  const reads = {
    name: 'reads',
    resolveId: (id: string) => (id.includes('vm.wasm') ? '\0wasm' : `\0${id}`),
    load(id: string) {
      read.push(id.slice(1));
      return modules[id.slice(1)] ?? null;
    },
  };
  await build({
    configFile: false,
    logLevel: 'silent',
    plugins: [firmwareAwaited(made), reads],
    build: { write: false, rolldownOptions: { input: 'entry' } },
  });
  return read;
}

describe('a build that begins before the VM is made', () => {
  it('reads everything else, and the VM once it is there', async () => {
    let isMade: () => void = () => undefined;
    const made = new Promise<void>((resolve) => (isMade = resolve));
    const read = building(() => {
      setTimeout(isMade, 200);
      return made;
    });
    const inOrder = await read;
    expect(inOrder.at(-1)).toBe('wasm');
    expect([...inOrder].sort()).toEqual(['deeper', 'entry', 'firmware', 'other', 'wasm']);
  });

  it('fails where the VM fails', async () => {
    await expect(building(() => Promise.reject(new Error('The VM was not made.')))).rejects.toThrow('not made');
  });

  it('is told so by one word, and takes an end without it for a failure', async () => {
    await expect(toldSo(Readable.from(['ma', 'de']))).resolves.toBeUndefined();
    await expect(toldSo(Readable.from([]))).rejects.toThrow('The VM was not made.');
  });
});
