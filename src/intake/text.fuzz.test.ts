import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { sceneLimits } from '#scene/scene';
import { mutatedText, mutatedTree } from '#scene/testing/mutate';

import { parseProject, projectToText } from '#project/file';
import { projectLimits, type Project } from '#project/project';
import { classProject, devicesProject, fullProject, handedInProject } from '#project/testing/projects';

import { documentOfText } from './text';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;

const level = { canvas: { width: 800, height: 600 }, walls: [{ x: 9, y: 9, w: 90, h: 10 }], marks: [{ x: 5, y: 5, radius: 3 }, { x: 9, y: 5, radius: 3 }] }; // prettier-ignore

function expectWithinLimits({ files, scene }: Project): void {
  expect(files.length).toBeLessThanOrEqual(projectLimits.files);
  expect(files[0]?.name).toBe('main.py');
  expect(scene.objects.length).toBeLessThanOrEqual(sceneLimits.objects);
}

describe('randomly changed project files and levels', () => {
  it(
    `open as something valid or give a message, never an exception (${String(fuzzRuns)} files)`,
    () => {
      const text = projectToText(fullProject());
      const several = JSON.parse(projectToText(devicesProject())) as unknown;
      const ofClass = { ...classProject(), ...handedInProject() };
      const values: readonly unknown[] = [JSON.parse(text), level, [...level.marks], several, JSON.parse(projectToText(ofClass))]; // prettier-ignore
      const counts = { project: 0, course: 0, unreadable: 0, series: 0, recording: 0, tournament: 0 };
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const value = values[seed % 3 === 0 ? 1 + (seed % 2) : seed % 3 === 1 ? (seed % 2) * 4 : 3];
        const file = rng.unit() < 0.3 ? mutatedText(text, rng) : (JSON.stringify(mutatedTree(value, rng, false)) ?? '');
        const opened = documentOfText(file, () => null);
        counts[opened.kind] += 1;
        if (opened.kind === 'unreadable') expect(opened.message, `seed ${String(seed)}`).not.toBe('');
        if (opened.kind !== 'project') continue;
        expectWithinLimits(opened.project);
        expect(parseProject(projectToText(opened.project)), `seed ${String(seed)}`).toEqual({
          project: opened.project,
        });
      }
      for (const count of [counts.project, counts.course, counts.unreadable])
        expect(count).toBeGreaterThan(fuzzRuns / 100);
      expect(({} as Record<string, unknown>)['polluted']).toBeUndefined();
    },
    TIME_LIMIT_MS,
  );
});
