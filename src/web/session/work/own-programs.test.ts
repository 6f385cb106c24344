// @vitest-environment happy-dom
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';

import { ladderOf } from '#catalogue/missions';
import { projectOf } from '#catalogue/course';
import { courses } from '#catalogue/courses';
import { MAIN } from '#project/project';
import { soloRun } from '#simulation/run-setup';

import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import './catalogue/ready-courses';
import { boardPrograms } from './catalogue/board-programs';
import { useCourses } from './use-courses';
import { filesOfRun, keepBest, programsOf } from './programs/own-programs';

beforeAll(() => loadTexts('de'));
beforeEach(() => localStorage.clear());
afterEach(() => void vi.restoreAllMocks());

const ladder = ladderOf('maqueen-lite');
const mission = (number: number) => ladder[number - 1]!;
const text = (page: TestPage): string => page.work.find(MAIN)?.text ?? '';

/** A pupil who has written a program into each of the first missions. */
function afterMissions(count: number): TestPage {
  const page = createPage();
  for (let number = 1; number <= count; number += 1) {
    useCourses(page).openAgain(mission(number));
    page.work.setText(MAIN, `mine = ${String(number)}`, true);
  }
  return page;
}

describe('the pupil’s own programs of missions', () => {
  it('are all there again after twelve of them, in the mission itself and among the earlier works', () => {
    const page = afterMissions(12);
    expect(page.work.work.value.previous).toHaveLength(11);
    for (let number = 1; number <= 12; number += 1) {
      useCourses(page).openAgain(mission(number));
      expect([text(page), page.work.work.value.project.course]).toEqual([
        `mine = ${String(number)}`,
        mission(number).id,
      ]);
    }
  });

  it('leave the start program as the other choice', () => {
    const page = afterMissions(2);
    useCourses(page).openAgain(mission(1));
    expect(page.notices.current.value?.action?.values).toEqual({ text: 'Startprogramm' });
    page.notices.current.value?.action?.run();
    expect(text(page)).toBe(mission(1).program.de);
    useCourses(page).openAgain(mission(2)); // who only looks at the start program has not given theirs up
    useCourses(page).openAgain(mission(1));
    expect(text(page)).toBe('mine = 1');
  });

  it('are kept where they say the same as the shipped solution, too', () => {
    const page = createPage();
    useCourses(page).openAgain(mission(1));
    page.work.setText(MAIN, mission(1).solution.de, true);
    useCourses(page).openAgain(mission(2));
    expect(page.work.work.value.previous[0]?.project.files[0]?.text).toBe(mission(1).solution.de);
    useCourses(page).openAgain(mission(1));
    expect(text(page)).toBe(mission(1).solution.de);
  });

  it('are not the solution that somebody has only opened', () => {
    const page = createPage();
    const course = courses.find(({ program, solution }) => program.de !== solution.de)!;
    useCourses(page).openWhole({ ...course, program: course.solution });
    useCourses(page).openAgain(mission(1));
    expect([page.work.work.value.previous, programsOf(page.work, course.id)]).toEqual([[], {}]);
  });

  it('are never those of a teacher’s task on the same course', () => {
    const page = createPage();
    useCourses(page).openAgain(mission(1));
    page.work.setTask({ id: 'T' });
    page.work.setText(MAIN, 'task = 1', true);
    useCourses(page).openAgain(mission(2));
    expect(programsOf(page.work, mission(1).id)).toEqual({});
  });

  it('leave a task of the class as it is: it comes back from the message, also where nobody has written in it', () => {
    const page = createPage();
    const { openAgain, openBoardProgram, openScene } = useCourses(page);
    const task = { version: 1, id: 'T', handedOut: true };
    const leaveFor = (open: () => void): unknown => {
      page.work.openProject({ ...projectOf(mission(1), 'de'), task }, null);
      open();
      expect(page.work.work.value.project.task).toBeUndefined();
      page.notices.current.value?.action?.run();
      return page.work.work.value.project.task;
    };
    expect(leaveFor(() => openAgain(mission(2)))).toEqual(task);
    expect(leaveFor(() => openBoardProgram(boardPrograms[0]!))).toEqual(task);
    expect(leaveFor(() => openScene(mission(3)))).toEqual(task);
  });

  it('are given up by nobody when the browser has no room: what is open goes on', () => {
    const page = afterMissions(1);
    vi.spyOn(Storage.prototype, 'setItem').mockImplementation(() => {
      throw new DOMException('full', 'QuotaExceededError');
    });
    useCourses(page).openAgain(mission(2));
    expect(page.work.work.value.previous[0]?.project.files[0]?.text).toBe('mine = 1');
  });
});

describe('the best program of a course', () => {
  const won = (word: string, stars: number, timeMs: number) => {
    const files = filesOfRun(soloRun({ files: { 'a.py': '', 'main.py': word }, ...around }));
    return { atMs: 1, files, stars, timeMs };
  };
  const around = { scene: mission(1).scene, robot: 'auto', board: 'auto', seed: 1, reality: 0 } as const;
  const work = { programs: localStorage };
  const best = (): string | undefined => programsOf(work, 'x').best?.files[0]?.[0]?.text;

  it('is the one with more stars, then the one in less time', () => {
    keepBest(work, 'x', won('slow', 2, 9000));
    keepBest(work, 'x', won('one star', 1, 1000));
    expect(best()).toBe('slow');
    keepBest(work, 'x', won('fast', 2, 8000));
    keepBest(work, 'x', won('three', 3, 10_000));
    keepBest(work, 'x', won('later', 3, 10_000));
    expect([best(), programsOf(work, 'x').best?.files[0]?.map(({ name }) => name)]).toEqual(['three', [MAIN, 'a.py']]);
  });

  it('is none where what is stored cannot be read', () => {
    for (const stored of ['{', '[]', '{"best":{"atMs":1,"files":[]}}', '{"best":{"atMs":1,"files":[[{"name":1}]]}}']) {
      localStorage.setItem('parcours.program.x', stored);
      expect(programsOf(work, 'x'), stored).toEqual({});
    }
  });
});
