// @vitest-environment happy-dom
import { beforeAll, beforeEach, expect, it, vi } from 'vitest';

import { ladderOf } from '#catalogue/missions';
import { MAIN } from '#project/project';
import type { Verdict } from '#simulation/task/verdict';

import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { loadTexts } from '../../kit/i18n';
import '../work/catalogue/ready-courses';
import { programsOf } from '../work/programs/own-programs';
import { useCourses } from '../work/use-courses';

beforeAll(() => loadTexts('de'));
beforeEach(() => localStorage.clear());

const ladder = ladderOf('maqueen-lite');
/** The pupil's programs: a first try and one that passes; the first mission is solved just as the page would solve it. */
const own = (number: number): string => (number === 1 ? ladder[0]!.solution.en : `mine = ${String(number)}\n`);
const passed = { state: 'passed', atMs: 4000, stars: 3 } as Verdict;

it('the twelve missions are done one after the other, and each opens with its own program, with three stars', async () => {
  const page = createPage();
  for (const [at, mission] of ladder.entries()) {
    useCourses(page).openAgain(mission);
    expect(page.work.find(MAIN)?.text).toBe(mission.program.en);
    page.work.setText(MAIN, 'first try\n', true);
    page.work.setText(MAIN, own(at + 1), true);
    await startRun(page);
    await show(page, { verdict: passed, robot: { type: 'maqueen-lite' } as never });
    await vi.waitFor(() => expect(programsOf(page.work, mission.id).best).toBeDefined());
  }
  expect(ladder.map(({ id }) => page.task.stars.all.value[id])).toEqual(ladder.map(() => 3));
  for (const [at, mission] of ladder.entries()) {
    useCourses(page).openAgain(mission);
    expect([page.work.work.value.project.course, page.work.find(MAIN)?.text]).toEqual([mission.id, own(at + 1)]);
    expect(programsOf(page.work, mission.id).best?.files).toEqual([[{ name: MAIN, text: own(at + 1) }]]);
  }
});
