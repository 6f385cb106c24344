import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { LANGUAGES } from '#core/languages';
import { robotTypes } from '#robots/index';
import { findProblems } from '#scene/rules';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { firstCourse } from './first-course';
import type { MissionCourse } from '#catalogue/mission';
import { missionRobots } from '#catalogue/mission-place';
import { ladderOf, missionAfter, missions } from '#catalogue/missions';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** Simulated seconds that a program may go on after its task is done: an error would come within a turn of its loop. */
const SECONDS_AFTER = 3;

/** The outcome of a mission's program after a number of simulated seconds, or as soon as its task is done and some more. */
async function drive({ scene, mission }: MissionCourse, program: string, seconds: number): Promise<Simulation> {
  const files = { 'main.py': program };
  const setup = { scene, files, robot: mission.robot, board: 'auto', seed: 1, reality: 0, keepTrace: false };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  let last = seconds;
  for (let second = 1; second <= last; second++) {
    simulation.advanceTo(second * 1_000_000);
    if (simulation.verdict?.state !== 'open')
      last = simulation.ended === null ? Math.min(last, second + SECONDS_AFTER) : 0;
  }
  return simulation;
}

describe('the ladder of missions', () => {
  it.each(missionRobots)('has twelve for %s, numbered from 1 on, each with one new thing', (robot) => {
    const ladder = ladderOf(robot);
    expect(ladder.map(({ mission }) => mission.number)).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
    const news = ladder.slice(0, -1).map(({ mission }) => mission.news);
    expect(news).not.toContain('');
    expect(new Set(news).size).toBe(news.length);
    expect(ladder.at(-1)?.mission.news).toBe(''); // all together
  });

  it('leads from each mission to the next one for the same robot, and ends', () => {
    const [first] = ladderOf('callibot');
    expect(missionAfter(first!.mission)?.mission).toMatchObject({ number: 2, robot: 'callibot' });
    expect(missionAfter(ladderOf('callibot').at(-1)!.mission)).toBeNull();
  });

  it('begins on a first visit, with three commands below the import', () => {
    expect(firstCourse).toEqual(missions[0]);
    const lines = firstCourse!.program.en.split('\n').filter((line) => line.trim() !== '');
    expect(lines).toEqual(['from mbrobot import *', 'forward()', 'delay(1000)', 'stop()']);
  });

  it('has names, tasks and hints in every language, in Swiss spelling, and leaves no place for a value open', () => {
    for (const { id, texts, program, solution } of missions)
      for (const language of LANGUAGES) {
        const { name, text, task, hints = [] } = texts[language];
        expect(name, id).not.toBe('');
        for (const sentence of [text, task, ...hints]) expect(sentence, id).toMatch(/[.!?]$/);
        expect(hints.length, id).toBeGreaterThanOrEqual(2);
        expect(program[language] + solution[language], id).not.toContain('$');
        expect(JSON.stringify(texts.de), id).not.toContain('ß');
      }
  });

  it('has nothing that the editor would find fault with', () => {
    for (const { id, scene, mission } of missions) {
      const robot = robotTypes.find((type) => type.id === mission.robot)!;
      expect(findProblems(scene, robot.body.outlineMm), id).toEqual([]);
    }
  });
});

describe.each(missions.map((mission) => [mission.id, mission] as const))(
  'the mission %s',
  { timeout: 60_000 },
  (_, mission) => {
    it('is passed by its solution with three stars', async () => {
      const { verdict, ended } = await drive(mission, mission.solution.en, 40);
      expect(ended?.exception ?? null).toBeNull();
      expect(verdict).toMatchObject({ state: 'passed', stars: 3 });
    });

    it('begins with a program that moves the robot, makes no error and leaves the task to the pupil', async () => {
      const simulation = await drive(mission, mission.program.en, 10);
      expect(simulation.ended?.exception ?? null).toBeNull();
      expect(simulation.snapshot().robot!.pathMm).toBeGreaterThan(20);
      expect(simulation.verdict?.state).toBe('open');
    });
  },
);
