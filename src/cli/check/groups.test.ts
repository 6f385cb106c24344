import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { parcours, useFolder } from '../testing/parcours';

const { folder } = useFolder();

const RIGHT = readFileSync('courses/push/main.py', 'utf8');
const STANDS = 'from mbrobot import *\nstop()\n';

interface Found {
  readonly groups: readonly { readonly key: string; readonly title: string; readonly count: number }[];
  readonly handIns: readonly { readonly name: string; readonly group: string }[];
}

describe('parcours check --groups', () => {
  it('says what groups of runs did, and names nobody in the report', () => {
    const class8 = join(folder, 'class');
    mkdirSync(class8);
    const programs = { anna: RIGHT, ben: STANDS, carla: `# mine\n${STANDS}`, dario: RIGHT.replace('(1000)', '(0)') };
    for (const [name, text] of Object.entries(programs)) writeFileSync(join(class8, `${name}.py`), text);
    const report = join(folder, 'groups.html');
    const asked = ['check', 'push', class8, '--groups', '--report', report, '--lang', 'en'];
    const { groups, handIns } = JSON.parse(parcours(...asked, '--json').out) as Found;
    expect(groups.map(({ title, count }) => [title, count])).toEqual([
      ['2 pass', 2],
      ['2 never start', 2],
    ]);
    const keys = groups.map(({ key }) => key);
    expect(handIns.map(({ name, group }) => [name, keys.indexOf(group)])).toEqual([
      ...[['anna', 0], ['ben', 1], ['carla', 1], ['dario', 0]],
    ]); // prettier-ignore
    const html = readFileSync(report, 'utf8');
    expect(html).toContain('2 never start');
    expect(html).not.toMatch(/anna|ben|carla|dario/);
  });
});
