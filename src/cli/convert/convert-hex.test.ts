import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { readHex } from '#hex/read';
import { appended, firmwareRegions, firmwareText, hexText, makeCodeText } from '#hex/testing/firmware';
import { useFolder } from '../testing/parcours';
import { converted } from './testing/converted';

const { file, folder } = useFolder();

const v1 = file('v1.hex', firmwareText('microbit-v1'));
const v2 = file('v2.hex', firmwareText('microbit-v2'));
const mini = file('mini.hex', firmwareText('calliope-mini-3'));
const main = file('main.py', 'import way\nfrom mbrobot import *\nforward()\n');
const way = file('way.py', 'x = 1\n');
const made = (name: string) => readHex(readFileSync(join(folder, name), 'utf8'));

describe('parcours convert --as hex', () => {
  it('writes a hex with the program, its files and just the module of ours that it imports', async () => {
    const { code, err } = await converted(main, '--firmware', v2, '--file', way, '--out', join(folder, 'main.hex'));
    expect([code, err]).toMatchObject([0, expect.stringContaining('Brought along, since the program imports it: mbrobot.py.')]); // prettier-ignore
    const hex = made('main.hex');
    expect(hex).toMatchObject({ made: 'micropython', boards: ['microbit-v2'], program: 'import way\nfrom mbrobot import *\nforward()\n' }); // prettier-ignore
    expect(hex.kind === 'hex' && hex.files.map(({ name }) => name)).toEqual(['main.py', 'mbrobot.py', 'way.py']);
  });

  it('writes a universal hex for both boards: from two firmwares, or from a universal one', async () => {
    const both = join(folder, 'both.hex');
    expect((await converted(way, '--firmware', v2, '--firmware', v1, '--out', both)).code).toBe(0);
    expect(made('both.hex')).toMatchObject({ made: 'universal', boards: ['microbit-v1', 'microbit-v2'] });
    expect((await converted(way, '--firmware', both, '--out', join(folder, 'again.hex'))).code).toBe(0);
    expect(made('again.hex')).toEqual(made('both.hex'));
    expect((await converted(way, '--firmware', both, '--board', 'microbit-v1', '--out', join(folder, 'one.hex'))).code).toBe(0); // prettier-ignore
    expect(made('one.hex')).toMatchObject({ made: 'micropython', boards: ['microbit-v1'] });
  });

  it('says by how many bytes it does not fit, and what is large', async () => {
    const large = file('large.py', '#'.repeat(21_000));
    const { code, err } = await converted(large, '--firmware', v2, '--as', 'hex');
    expect(code).toBe(2);
    expect(err).toMatch(/large\.py: does not fit: 896 bytes are missing, the board has room for 20480\. Large: main\.py \(21376\)\./); // prettier-ignore
  });

  it('leaves comments and spaces out of our modules where they would not fit', async () => {
    const long = file('long.py', `from mbrobot import *\n#${'x'.repeat(12_500)}\n`);
    const { code, err } = await converted(long, '--firmware', v2, '--out', join(folder, 'long.hex'));
    expect([code, err]).toMatchObject([0, expect.stringContaining('Without comments and spaces, so that it fits: mbrobot.py.')]); // prettier-ignore
  });

  it.each<[string, readonly string[], string]>([
    ['no firmware', [main, '--as', 'hex'], 'A hex needs MicroPython.'],
    ['a firmware that is none', [main, '--as', 'hex', '--firmware', file('x.hex', makeCodeText())], 'x.hex: this is a program from MakeCode'],
    ['a damaged firmware', [main, '--as', 'hex', '--firmware', file('y.hex', ':00\n')], 'y.hex: the hex file is damaged in line 1.'],
    ['a board that the firmware is not for', [main, '--as', 'hex', '--firmware', v2, '--board', 'microbit-v1'], '--board: the firmware is for microbit-v2.'],
    ['an unknown board', [main, '--as', 'hex', '--firmware', v2, '--board', 'uno'], '--board: "uno" is not known. Known: microbit-v1,'],
    ['boards of two families', [main, '--as', 'hex', '--firmware', v2, '--firmware', mini], 'Choose one: --board microbit-v2'],
    ['a file twice', [main, '--as', 'hex', '--firmware', v2, '--file', main], 'there is already a file "main.py"'],
    ['a firmware for another form', [main, '--as', 'project', '--firmware', v2], '--firmware is for a hex only'],
    ['a folder that is not said', [main, '--as', 'files'], 'say which folder takes them'],
  ])('refuses %s in a sentence', async (_, words, sentence) => {
    const { code, out, err } = await converted(...words);
    expect([code, out]).toEqual([2, '']);
    expect(err).toContain(sentence);
  }); // prettier-ignore
});

describe('parcours convert of a hex', () => {
  it('writes its files into a folder, without the modules that are here anyway', async () => {
    const hex = join(folder, 'pupil.hex');
    await converted(main, '--firmware', v2, '--file', way, '--out', hex);
    const { code, err } = await converted(hex, '--out', `${join(folder, 'pupil')}/`);
    expect([code, err]).toEqual([0, 'parcours: mbrobot.py: left out, since Parcours brings it along.\n']);
    expect(readdirSync(join(folder, 'pupil'))).toEqual(['main.py', 'way.py']);
    expect((await converted(hex, '--as', 'program')).out).toBe('import way\nfrom mbrobot import *\nforward()\n');
  });

  it('tells what it is in one line', async () => {
    const line = async (name: string, text: string) =>
      JSON.parse((await converted(file(name, text), '--json')).out) as unknown;
    const old = hexText([...firmwareRegions('microbit-v1').slice(0, 1), appended('x = 1\n'), ...firmwareRegions('microbit-v1').slice(1)]); // prettier-ignore
    expect(await line('old.hex', old)).toMatchObject({ kind: 'hex', made: 'micropython-appended', boards: ['microbit-v1'], program: { 'main.py': 'x = 1\n' }, notes: [] }); // prettier-ignore
    expect(await line('blocks.hex', makeCodeText())).toMatchObject({ kind: 'hex', made: 'makecode', boards: [], program: {}, notes: [expect.stringContaining('program from MakeCode')] }); // prettier-ignore
    expect(await line('bare.hex', firmwareText('calliope-mini-3'))).toMatchObject({ made: 'micropython', boards: ['calliope-mini-3'], program: {}, notes: [expect.stringContaining('only MicroPython')] }); // prettier-ignore
  });

  it('sums up for people what it is', async () => {
    expect((await converted(v2)).out).toContain('This is a hex (micropython) for microbit-v2.\n');
  });

  it('has no program where it is MakeCode’s, or damaged', async () => {
    const blocks = await converted(file('blocks.hex', makeCodeText()), '--as', 'program');
    expect([blocks.code, blocks.err]).toEqual([2, expect.stringContaining('this is a program from MakeCode')]);
    const broken = await converted(file('broken.hex', firmwareText('microbit-v2').slice(0, 1000)), '--json');
    expect([broken.code, broken.err]).toEqual([2, expect.stringContaining('the hex file is damaged')]);
  });
});
