// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';

import { courses } from '#catalogue/courses';
import { defaultProjectSettings, type Project } from '#project/project';

import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import './catalogue/ready-courses';
import { runSetup } from './run-setup';
import { useCourses } from './use-courses';
import { useOpenings } from './use-openings';

beforeAll(() => loadTexts('de'));
beforeEach(() => {
  localStorage.clear();
  sessionStorage.clear();
});

const course = (id: string) => courses.find((one) => one.id === id)!;
const SENSES = { timeUs: 0, action: { type: 'arena-senses', on: true } };
const inputs = (page: TestPage) => runSetup(page, (place) => page.sensors.startInputs(place)).inputs;
const feels = (page: TestPage): boolean => JSON.stringify(inputs(page)).includes('arena-senses');

describe('the board on a robot', () => {
  it('feels the arena in the first work, and in every course that is opened', () => {
    const page = createPage();
    expect(feels(page)).toBe(true);
    page.settings.change({ arenaSenses: false });
    useCourses(page).openAgain(course('slalom'));
    expect(feels(page)).toBe(true);
    page.settings.change({ arenaSenses: false });
    useCourses(page).openScene(course('square'));
    expect(feels(page)).toBe(true);
  });

  it('feels it in the first work also where it was switched off in other work, unless a host wishes otherwise', () => {
    localStorage.setItem('parcours.settings', JSON.stringify({ arenaSenses: false }));
    expect(feels(createPage())).toBe(true);
    expect(feels(createPage({ settings: { arenaSenses: false } }))).toBe(false);
  });

  it('feels what it did in files and links of before: nothing, and again nothing when that work is brought back', () => {
    const page = createPage();
    const { files, scene } = page.work.work.value.project;
    const old: Project = { files, scene, course: null };
    useOpenings(page).open({ ...old, settings: defaultProjectSettings }, 'alt', false);
    expect(feels(page)).toBe(false);
    page.work.setText('main.py', 'mine = 1\n');
    useCourses(page).openAgain(course('slalom'));
    expect(feels(page)).toBe(true);
    useOpenings(page).restore(page.work.work.value.previous[0]!);
    expect(feels(page)).toBe(false);
  });

  it('feels nothing in a file without settings, as on the command line and in a check', () => {
    const page = createPage();
    const { files, scene } = page.work.work.value.project;
    useOpenings(page).open({ files, scene, course: null }, 'alt', false);
    expect(feels(page)).toBe(false);
  });

  it('begins with what the hand has set, which the arena does not change', () => {
    const page = createPage();
    page.sensors.set('lightLevel', 40);
    expect(inputs(page)).toEqual([SENSES, { timeUs: 0, action: { type: 'sensor', id: 'lightLevel', value: 40 } }]);
  });
});
