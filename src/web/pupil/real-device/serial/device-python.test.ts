import { describe, expect, it } from 'vitest';
import { strToU8, unzipSync } from 'fflate';
import { fingerprint, pythonBytes, pythonText } from './device-python';
import { zipOf } from '../../../session/work/zip';

const named = (main: string, more: Readonly<Record<string, string>> = {}) =>
  [['main.py', main] as const, ...Object.entries(more)].map(([name, text]) => ({ name, text }));

describe('a project as one file', () => {
  it('is a zip that others can open, the same for the same files', () => {
    const zip = zipOf(named('print("ä")', { 'a.py': '' }));
    expect(unzipSync(zip)).toEqual({ 'main.py': strToU8('print("ä")'), 'a.py': new Uint8Array(0) });
    expect(zipOf(named('print("ä")', { 'a.py': '' }))).toEqual(zip);
  });
});

describe('texts on their way into Python', () => {
  it('are ASCII whatever they hold', () => {
    expect(pythonText("ü'\\\n😀")).toBe("'\\u00fc\\x27\\x5c\\x0a\\U0001f600'");
    expect(pythonBytes(Uint8Array.of(0, 10, 39, 92, 65, 255))).toBe("b'\\x00\\n\\'\\\\A\\xff'");
  });

  it('have the sums of Adler-32', () => {
    expect(fingerprint(strToU8('Wikipedia'))).toBe('9 920 4582'); // 0x11E60398
  });
});
