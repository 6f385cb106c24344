import { readdirSync, readFileSync } from 'node:fs';
import { isDeepStrictEqual } from 'node:util';
import { describe, expect, it } from 'vitest';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { unpackLevels } from './background';
import { editProblem, parseEdit } from './check-edit';
import { applyEdit } from './edit';
import { asKept } from './groups';
import { parseScene, parseSceneValue, type ParsedScene } from './parse';
import type { SceneProblem } from './problem';
import { findProblems } from './rules';
import { countPoints, sceneLimits, type Scene } from './scene';
import { serializeScene } from './serialize';
import { forManySeeds, inPercent, oneOf } from './testing/fuzz';
import { mutatedText, mutatedTree } from './testing/mutate';
import { randomEdit } from './testing/random-scene';

const root = new URL('../../', import.meta.url);
const read = (path: string): string => readFileSync(new URL(path, root), 'utf8');

/** The kept files of every version and the ready courses. */
const files: readonly string[] = [
  ...readdirSync(new URL('src/scene/kept/', root)).map((name) => read(`src/scene/kept/${name}`)),
  ...readdirSync(new URL('courses/', root), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.replaceAll('\\', '/').endsWith('/scene.json'))
    .sort()
    .map((name) => read(`courses/${name}`)),
];
const trees: readonly unknown[] = files.map((text) => JSON.parse(text) as unknown);
const scenes: readonly Scene[] = files.map((text) => {
  const parsed = parseScene(text);
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  return parsed.scene;
});

function expectBounded(problems: readonly SceneProblem[]): void {
  if (problems.length < 1 || problems.length > 20) throw new Error(`${problems.length} problems`);
  for (const { path, value, message } of problems)
    if (path.length > 300 || value.length > 100 || message.length > 1000) throw new Error(`too long: ${message}`);
}

/** A valid scene is within every limit and stays the same through its file, but for groups of one. */
function expectSound(scene: Scene): void {
  const points = scene.objects.reduce((sum, object) => sum + countPoints(object), 0);
  const text = serializeScene(scene);
  const { objects, points: mostPoints, textCharacters } = sceneLimits;
  if (scene.objects.length > objects || points > mostPoints || text.length > textCharacters)
    throw new Error(`${scene.objects.length} objects, ${points} points, ${text.length} characters`);
  if (!isDeepStrictEqual(parseScene(text), { scene: asKept(scene) }))
    throw new Error(`is another scene after saving: ${text}`);
}

function judge(parsed: ParsedScene): 'scene' | 'problem' {
  if ('scene' in parsed) {
    expectSound(parsed.scene);
    return 'scene';
  }
  expectBounded(parsed.problems);
  return 'problem';
}

/** Both outcomes must really occur, else the mutations prove nothing. */
function expectBoth(counts: { readonly scene: number; readonly problem: number }): void {
  expect(counts.scene).toBeGreaterThan(fuzzRuns / 100);
  expect(counts.problem).toBeGreaterThan(fuzzRuns / 10);
}

describe('a course file that was changed at random', () => {
  it(`as text, as JSON or as a message gives a sound scene or a problem, never an exception: ${fuzzRuns} files`, () => {
    const counts = { scene: 0, problem: 0 };
    forManySeeds(fuzzRuns, (rng) => {
      const way = rng.u32() % 3;
      const index = rng.u32() % files.length;
      const parsed =
        way === 0
          ? parseScene(mutatedText(files[index] ?? '', rng))
          : way === 1
            ? parseScene(JSON.stringify(mutatedTree(trees[index], rng, false)) ?? '')
            : parseSceneValue(mutatedTree(trees[index], rng, true));
      counts[judge(parsed)]++;
      if ('scene' in parsed && inPercent(rng, 10))
        findProblems(parsed.scene, [
          [
            { x: 0, y: 0 },
            { x: 50, y: 0 },
            { x: 0, y: 50 },
          ],
        ]);
    });
    expectBoth(counts);
    expect(Object.prototype).not.toHaveProperty('x');
  });
});

describe('an edit that was changed at random', () => {
  it(`gives an edit that leads to a sound scene, or a problem, never an exception: ${fuzzRuns} edits`, () => {
    const counts = { scene: 0, problem: 0 };
    forManySeeds(fuzzRuns, (rng) => {
      const scene = oneOf(rng, scenes);
      const parsed = parseEdit(mutatedTree(randomEdit(rng, scene), rng, inPercent(rng, 50)));
      if ('problems' in parsed) {
        expectBounded(parsed.problems);
        counts.problem++;
        return;
      }
      const problem = editProblem(scene, parsed.edit);
      if (problem) expectBounded([problem]);
      else expectSound(applyEdit(scene, parsed.edit));
      counts[problem ? 'problem' : 'scene']++;
    });
    expectBoth(counts);
  });
});

describe('the levels of a background that were changed at random', () => {
  it(`are as many as its cells or none: ${fuzzRuns} texts`, () => {
    const background = scenes.find((scene) => scene.background)?.background;
    if (!background) throw new Error('no kept file has a background');
    const counts = { scene: 0, problem: 0 };
    forManySeeds(fuzzRuns, (rng) => {
      const levels = unpackLevels({ cells: background.cells, levels: mutatedText(background.levels, rng) });
      if (levels && (levels.length !== 12 || levels.some((level) => level > 15))) throw new Error(String(levels));
      counts[levels ? 'scene' : 'problem']++;
    });
    expect(counts.problem).toBeGreaterThan(fuzzRuns / 10);
    expect(counts.scene).toBeGreaterThan(0);
  });
});
