// @vitest-environment happy-dom
import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex } from '@noble/hashes/utils.js';
import { beforeEach, describe, expect, it, vi } from 'vitest';

import { hexBoards } from '#hex/firmware';
import { makeHex } from '#hex/make';
import { firmwareText } from '#hex/testing/firmware';

import { stubDatabase } from '../../../session/work/storage/testing/memory-database';
import { FirmwareModel } from './firmware-model';
import { serverFolder } from './server-folder';

const V2 = firmwareText('microbit-v2');
const sumOf = (text: string): string => bytesToHex(sha256(new TextEncoder().encode(text)));

/** A web server with these files in its folder, and the names of those that were asked for. */
function server(files: Readonly<Record<string, string>>) {
  const asked: string[] = [];
  const get = (address: string) => {
    const name = address.split('/').pop() ?? '';
    asked.push(name);
    const text = files[name];
    return Promise.resolve({
      ok: text !== undefined,
      arrayBuffer: () => Promise.resolve(new TextEncoder().encode(text).buffer),
    });
  };
  return { get, asked };
}
const listOf = (entry: object): string => JSON.stringify({ firmwares: [entry] });
const offer = { board: 'microbit-v2', file: 'v2.hex', sha256: sumOf(V2) };

beforeEach(() => void stubDatabase());

describe('the MicroPython of a board', () => {
  it('is taken out of a hex that somebody gives, and kept in this browser', async () => {
    const model = new FirmwareModel(null);
    await model.look('microbit-v2');
    expect([model.of('microbit-v2'), model.isLooking.value]).toEqual([null, false]);
    expect(await model.take(new Blob([V2]))).toEqual({ kind: 'taken', boards: ['microbit-v2'], isKept: true });
    const later = new FirmwareModel(null);
    await later.look('microbit-v2');
    expect(later.of('microbit-v2')).toEqual(model.of('microbit-v2'));
    expect(later.of('microbit-v2')?.board).toBe('microbit-v2');
  });

  it('is refused where the file is none', async () => {
    const model = new FirmwareModel(null);
    expect(await model.take(new Blob(['print(1)']))).toEqual({ kind: 'refused', problem: { code: 'no-hex' } });
    const huge = new Blob([V2, new Uint8Array(9_000_000)]);
    expect(await model.take(huge)).toEqual({ kind: 'refused', problem: { code: 'size' } });
    expect(model.of('microbit-v2')).toBeNull();
  });

  it('can be removed, so that another one can be given', async () => {
    const model = new FirmwareModel(null);
    await model.take(new Blob([V2]));
    await model.remove('microbit-v2');
    const later = new FirmwareModel(null);
    await later.look('microbit-v2');
    expect([model.of('microbit-v2'), later.of('microbit-v2')]).toEqual([null, null]);
  });

  it('lasts until the page is closed where the browser has no database', async () => {
    vi.stubGlobal('indexedDB', undefined);
    const model = new FirmwareModel(null);
    await model.look('microbit-v2');
    expect(await model.take(new Blob([V2]))).toMatchObject({ kind: 'taken', isKept: false });
    await model.look('microbit-v2');
    expect(model.of('microbit-v2')).not.toBeNull();
  });
});

describe('the firmware folder of a web server', () => {
  it('is asked once for a board without firmware, and gives it', async () => {
    const { get, asked } = server({ 'firmware.json': listOf(offer), 'v2.hex': V2 });
    const model = new FirmwareModel(get);
    await model.look('calliope-mini-3');
    expect(asked).toEqual(['firmware.json']);
    await model.look('microbit-v2');
    expect(model.of('microbit-v2')?.board).toBe('microbit-v2');
    await new FirmwareModel(get).look('microbit-v2');
    expect(asked).toEqual(['firmware.json', 'v2.hex', 'firmware.json']); // kept: the large file came once
  });

  it('is what a browser saves of its own: each board gets from there what was given, without the files in it', async () => {
    const given = new FirmwareModel(null);
    for (const board of hexBoards) await given.take(new Blob([firmwareText(board)]));
    const firmwares = Array.from(given.all.value.values(), ({ firmware }) => firmware);
    const folder = await serverFolder(firmwares, (...asked) => Promise.resolve(makeHex(...asked)));
    const names = folder.map(({ name }) => name.replace('firmware/', ''));
    expect(names).toEqual(['firmware.json', 'NOTICE.txt', ...hexBoards.map((board) => `micropython-${board}.hex`)]);
    const { get } = server(Object.fromEntries(folder.map(({ text }, place) => [names[place], text])));
    for (const board of hexBoards) {
      stubDatabase();
      const model = new FirmwareModel(get);
      await model.look(board);
      expect(model.of(board)).toEqual(given.of(board));
    }
    expect(folder[1]?.text).toContain('Copyright (c) 2007 - 2019, Nordic Semiconductor ASA');
  });

  it('gives a newer one when the list changes', async () => {
    await new FirmwareModel(server({ 'firmware.json': listOf(offer), 'v2.hex': V2 }).get).look('microbit-v2');
    const newer = `${V2}\n`;
    const { get, asked } = server({ 'firmware.json': listOf({ ...offer, sha256: sumOf(newer) }), 'v2.hex': newer });
    await new FirmwareModel(get).look('microbit-v2');
    expect(asked).toContain('v2.hex');
  });

  it('never replaces what somebody has given', async () => {
    const { get, asked } = server({ 'firmware.json': listOf(offer), 'v2.hex': V2 });
    const model = new FirmwareModel(get);
    await model.take(new Blob([V2]));
    await model.look('microbit-v2');
    expect(asked).toEqual([]);
  });

  it.each([
    ['there is none', {}],
    ['its list is the page itself, as from servers that answer everything', { 'firmware.json': '<!doctype html>' }],
    ['its list is of another form', { 'firmware.json': '[null]' }],
    ['a board is unknown', { 'firmware.json': listOf({ ...offer, board: 'arduino' }), 'v2.hex': V2 }],
    ['the hash is another', { 'firmware.json': listOf(offer), 'v2.hex': `${V2} ` }],
    ['the file is no hex', { 'firmware.json': listOf({ ...offer, sha256: sumOf('x') }), 'v2.hex': 'x' }],
  ])('gives nothing, and no error, when %s', async (_, files) => {
    const model = new FirmwareModel(server(files).get);
    await model.look('microbit-v2');
    expect([model.of('microbit-v2'), model.isLooking.value]).toEqual([null, false]);
  });
});
