import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { parseScene } from './parse';
import { usualHeights } from './kinds/heights';
import { paintInfrared, strokeInfrared } from './paint/reflectance';
import { findProblems } from './rules';
import { paintColors } from './paint/paint';
import { sceneDefaults, sceneLimits, SCENE_VERSION } from './scene';

const page = readFileSync(new URL('./FORMAT.md', import.meta.url), 'utf8');

describe('the description of the course file', () => {
  const example = /```json\n([\s\S]*?)```/.exec(page)?.[1] ?? '';

  it('has an example of the newest version that is read and has nothing wrong with it', () => {
    const parsed = parseScene(example);
    if (!('scene' in parsed)) throw new Error(parsed.problem);
    expect(example).toContain(`"version": ${SCENE_VERSION},`);
    expect(findProblems(parsed.scene, [])).toEqual([]);
  });

  it('shows and explains every kind of object', () => {
    const parsed = parseScene('{"format":"parcours-scene","version":2,"objects":[{"id":"x","type":"?"}]}');
    const known = 'problems' in parsed ? String(parsed.problems[0]?.params['known']).split(', ') : [];
    expect(known).toHaveLength(16);
    for (const type of known) {
      expect(example).toContain(`"type": "${type}"`);
      expect(page).toMatch(new RegExp(`^\\| \`${type}\` +\\|`, 'm'));
    }
  });

  it('names the defaults and the colours that are in the code', () => {
    const rows = new Map(
      [...page.matchAll(/^\| `([\w.]+)`[^|]*\| ([^|]*) \|$/gm)].map(([, name, means]) => [name, means]),
    );
    expect(rows.get('size')?.trim()).toBe(sceneDefaults.size.join(' × '));
    expect(rows.get('thickness')?.trim()).toBe(String(sceneDefaults.thickness));
    expect(rows.get('width')?.trim()).toBe(`${sceneDefaults.width}, ${sceneDefaults.color}`);
    expect(rows.get('speed')?.trim()).toBe(`${sceneDefaults.speed} mm/s, ${sceneDefaults.spiked}`);
    expect(rows.get('height')?.trim()).toBe(String(sceneDefaults.labelHeight));
    const heights = [...page.matchAll(/^\| ((?:`[\w-]+`(?:, )?)+) +\| (\d+) +\|$/gm)].flatMap(([, types = '', mm]) =>
      [...types.matchAll(/`([\w-]+)`/g)].map(([, type]) => [type, Number(mm)]),
    );
    expect(Object.fromEntries(heights)).toMatchObject(usualHeights);
    expect(page).toContain(`, ${sceneLimits.heightMm.min} to ${sceneLimits.heightMm.max} mm.`);
    expect(page).toContain(`Colours: ${paintColors.join(', ')}.`);
    const shares = [...page.matchAll(/^\| (\w+) +\| ([\d.]+) +\| ([\d.]+) +\|$/gm)].map(([, color, stroke, other]) => [
      color,
      [Number(stroke), Number(other)],
    ]);
    expect(Object.fromEntries(shares)).toEqual(
      Object.fromEntries(paintColors.map((color) => [color, [strokeInfrared[color], paintInfrared[color]]])),
    );
  });
});
