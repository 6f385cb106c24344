/** The probes as used with a real board: run, saved, compared. */
import { existsSync, readdirSync, statSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { parcours, useFolder } from '../testing/parcours';
import { keptIn, probes } from './programs';
import { parseProbe } from './table';

const { file } = useFolder();
const FOLDER = 'docs/hardware/probe';
const programs = readdirSync(FOLDER).filter((name) => name.endsWith('.py'));
const nameOf = (path: string): string => path.replace('.py', '');

describe('the programs of the probe', { timeout: 60_000 }, () => {
  it('are all known to the comparison, but for the one that needs two boards', () => {
    expect([...Object.keys(probes), 'radio'].sort()).toEqual(programs.map(nameOf).sort());
  });

  it.each(programs)('%s is short enough for a board: at most 8 kB', (name) => {
    expect(statSync(`${FOLDER}/${name}`).size).toBeLessThanOrEqual(8000);
  });

  it.each(Object.keys(probes))(
    '%s prints a whole table here, which is like itself, and every row has its place',
    (name) => {
      const { out } = parcours('run', `${FOLDER}/${name}.py`, '--robot', probes[name]?.robot ?? 'none');
      const read = parseProbe(out);
      if ('problem' in read) throw new Error(read.problem);
      expect(read.tables.map(({ program }) => program)).toEqual([name]);
      for (const id of read.tables[0]?.rows.keys() ?? []) expect(existsSync(keptIn(name, id)), id).toBe(true);
      const again = parcours('probe', 'compare', file(`${name}.csv`, out));
      expect(again.out).toMatch(new RegExp(`^${name}: (\\d+) of \\1 rows are alike\\n$`));
      expect(again.code).toBe(0);
    },
  );

  it('run on a Calliope mini, too, and are compared with it', () => {
    const { out } = parcours('run', `${FOLDER}/errors.py`, '--robot', 'none', '--board', 'calliope-mini-3');
    expect(parcours('probe', 'compare', file('calliope.csv', out)).code).toBe(0);
  });
});

describe('parcours probe compare', { timeout: 60_000 }, () => {
  const { out: floats } = parcours('run', `${FOLDER}/floats.py`, '--robot', 'none');
  const changed = floats.replace(';69.8', ';69.80000000000001');

  it('names what differs, by how much, and where the project keeps it', () => {
    const { out, code } = parcours('probe', 'compare', file('board.csv', changed));
    expect(out).toContain('floats: 63 of 64 rows are alike\n');
    expect(out).toContain(
      '  21 * 1.8 + 32   board: 69.80000000000001   here: 69.8   → src/vm/run/single-float-text.ts\n',
    );
    expect(code).toBe(1);
  });

  it('compares two boards with each other', () => {
    const two = [file('one.csv', floats), file('other.csv', changed)];
    expect(parcours('probe', 'compare', ...two).code).toBe(1);
    expect(parcours('probe', 'compare', two[0] ?? '', two[0] ?? '').code).toBe(0);
  });

  it('refuses what is no table, in a sentence that names the file', () => {
    expect(parcours('probe', 'compare', file('photo.csv', Uint8Array.of(255, 216, 255, 0))).err).toContain(
      'photo.csv: is not text in UTF-8.',
    );
    expect(parcours('probe', 'compare', file('empty.csv', '')).err).toContain(
      'empty.csv: there is no table of a probe in it.',
    );
    expect(parcours('probe', 'compare', file('huge.csv', 'x'.repeat(5_000_000))).err).toContain('the limit is 4000000');
    expect(parcours('probe', 'compare', file('odd.csv', 'probe;begin;cows;1;x\nprobe;end;cows;0\n')).err).toContain(
      '"cows" is no probe. Known: timing,',
    );
    expect(parcours('probe', 'compare', 'nowhere.csv').code).toBe(2);
  });
});
