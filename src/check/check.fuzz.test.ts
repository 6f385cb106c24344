import { describe, expect, it } from 'vitest';
import { isRecord } from '#core/record';
import { createRng, type Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import type { Carried, Project } from '#project/project';
import { mutatedTree } from '#scene/testing/mutate';
import { check } from './check';
import { handInOf } from './hand-in/read-hand-in';
import { htmlOf } from './report/html';
import { csvOf, jsonOf, junitOf } from './report/texts';
import { taskOf } from './task/read-task';
import { projectOfTask } from './task/write-task';
import { ahead, firmware, projectWith, sceneWith, targetAt } from './testing/tasks';

/** One in this many readable cases is run, too. */
const RUN_EVERY = 10;
/** Only against an endless loop. */
const TIME_LIMIT_MS = 120_000 + 20 * fuzzRuns;

/** A task with something of everything. */
const task: Carried = {
  version: 1,
  id: 'task-1',
  checks: [
    { type: 'goals', id: 'goals' },
    { type: 'stop', id: 'stop', seconds: 0.2, zone: 't', points: 2 },
    { type: 'touches', id: 'touches', most: 1, needed: false },
    { type: 'faster', id: 'faster', seconds: 5 },
    { type: 'display', id: 'display', image: '00000:09090:00000:90009:09990', needed: false },
    { type: 'console', id: 'console', text: 'ok', needed: false },
    { type: 'loop', id: 'loop', needed: false },
    { type: 'calls', id: 'calls', name: 'forward', needed: false },
    { type: 'lines', id: 'lines', most: 15 },
  ],
  worlds: [
    { id: 'visible', hidden: false },
    {
      id: 'other',
      start: { at: [300, 450], heading: 0 },
      seed: 3,
      reality: 0.5,
      edits: [{ type: 'remove', ids: ['x'] }],
      sensors: { lightLevel: 10 },
    },
  ],
  least: 1,
  seconds: 2,
  stars: [1, 3],
  solution: [{ name: 'main.py', text: ahead(1500) }],
  locks: { course: true, lines: [1] },
  levels: [
    { name: 'leer', text: '' },
    { name: 'Lücken', text: 'forward()\n', lines: [1] },
  ],
  level: 1,
  exam: { minutes: 45 },
  about: { level: 'Klasse 7', topic: 'Linien', minutes: 45, language: 'de', author: 'Ada', licence: 'CC-BY-SA-4.0' },
};

const handIn: Carried = {
  ...{ version: 1, task: 'task-1', alias: 'Anna', verdict: 'passed', tries: 3, hash: 'abc', remarks: ['hand'] },
};

/** The contents of a project file are an object. */
function changed(data: Carried, rng: Rng): Carried {
  const value = mutatedTree(data, rng, false);
  return isRecord(value) ? value : {};
}

describe('randomly changed tasks and hand-ins', () => {
  it(
    `are read as something that can be checked, or give a message, never an exception (${String(fuzzRuns)})`,
    async () => {
      const project: Project = projectWith(sceneWith([targetAt(600, 450)]), ahead(1000));
      const counts = { read: 0, refused: 0, run: 0 };
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const read = taskOf({ ...project, task: changed(task, rng) });
        const handed = handInOf({ ...project, handIn: changed(handIn, rng) });
        if ('problem' in handed) expect(handed.problem, `seed ${String(seed)}`).not.toBe('');
        if ('problem' in read) {
          expect(read.problem, `seed ${String(seed)}`).not.toBe('');
          counts.refused += 1;
          continue;
        }
        counts.read += 1;
        expect(taskOf(projectOfTask(read.task)), `seed ${String(seed)}`).toEqual({ task: read.task });
        if ('problem' in handed || counts.read % RUN_EVERY !== 0) continue;
        counts.run += 1;
        // A short time: a changed limit may be an hour.
        const short = { ...read.task, seconds: Math.min(read.task.seconds ?? 2, 2) };
        const result = await check(short, handed.handIn, { firmware: firmware() });
        expect(result.worlds, `seed ${String(seed)}`).toHaveLength(short.worlds.length);
        const found = { task: short.id, handIns: [{ name: 'Anna', result }] };
        for (const text of [
          jsonOf(found, short, 'de'),
          csvOf(found, 'fr'),
          junitOf(found, 'it'),
          htmlOf(found, short, 'en'),
        ])
          expect(text).not.toContain('undefined');
      }
      for (const count of [counts.read, counts.refused]) expect(count).toBeGreaterThan(fuzzRuns / 100);
      expect(counts.run).toBeGreaterThan(0);
    },
    TIME_LIMIT_MS,
  );
});
