// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { projectOfRun } from '#intake/project-of-run';
import { nothingMeasured, type MyRobot } from '#my-robot/my-robot';
import type { Project, ProjectSettings } from '#project/project';
import { applyEdit } from '#scene/edit';
import { defaultScene } from '#scene/scene';
import type { RunSetup } from '#simulation/run-setup';

import { createPage } from '../../app/testing/page';

import { runSetup } from './run-setup';
import { useOpenings } from './use-openings';

const mine: MyRobot = {
  name: 'Robi',
  robot: 'maqueen-lite',
  used: true,
  measured: nothingMeasured,
  traits: {
    motors: { difference: 0.05, charge: 1, sag: 0, friction: 0.01 },
    ultrasonic: { offsetMm: 3, scale: 1 },
    line: {},
  },
};
const guessed: Project = {
  files: [
    { name: 'main.py', text: 'from mbrobot import *\nimport turn\n' },
    { name: 'turn.py', text: 'left = 1\n' },
  ],
  scene: { ...defaultScene(), name: 'Neuland' },
  course: null,
};
const settings: ProjectSettings = {
  ...{ device: 'calliope-mini-3', firmware: '', robot: 'maqueen-plus-v2', reality: 0.5, seed: 77 },
  ...{ robotOptions: {}, arenaSenses: true },
};

/** The set-up of a run of this project. */
function setupOf(project: Project): RunSetup {
  const page = createPage();
  useOpenings(page).open(project, '', true);
  const setup = runSetup(page, () => []);
  page.scope.stop();
  return setup;
}
/** The project of a run, or a failure of the test. */
function back(setup: RunSetup): Project {
  const read = projectOfRun(setup, 'Robot of the file');
  if ('problems' in read) throw new Error(read.problems[0]?.message);
  return read.project;
}

describe('the project of a recorded run', () => {
  it.each<[string, Project]>([
    ['alone, with two files, on a chosen robot and board', { ...guessed, settings }],
    ['with an own robot', { ...guessed, settings: { ...settings, robot: 'maqueen-lite', myRobot: mine } }],
    ['with what its program suggests', guessed],
    [
      'with several devices, one of them without a robot',
      {
        ...guessed,
        settings,
        devices: {
          first: 'Auto',
          others: [
            {
              ...{ name: 'Fern', device: 'microbit-v2', firmware: '', robot: 'none', robotOptions: {}, sameAs: '' },
              files: [{ name: 'main.py', text: 'import radio\n' }],
            },
          ],
        },
      },
    ],
  ])('has a run like that one: %s', (_what, project) => {
    const setup = setupOf(project);
    expect(setupOf(back(setup))).toEqual(setup);
  });

  it('has its course as it was at the end of the run', () => {
    const setup = setupOf(guessed);
    const edit = { type: 'course', changes: { size: [700, 500] } } as const;
    const edited = { ...setup, inputs: [{ timeUs: 4000, action: { type: 'edit', edit } as const }] };
    expect(back(edited).scene).toEqual(applyEdit(setup.scene, edit));
  });

  it('says what no project can have', () => {
    const setup = setupOf(guessed);
    const files = { 'main.py': '', 'no name': '' };
    const read = projectOfRun({ ...setup, devices: [{ ...setup.devices[0], files }] }, '');
    expect('problems' in read && read.problems[0]?.code).toBe('file-name');
  });
});
