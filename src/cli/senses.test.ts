import { describe, expect, it } from 'vitest';
import { projectToText } from '#project/file';
import { defaultProjectSettings, type Project, type ProjectSettings } from '#project/project';
import { defaultScene } from '#scene/scene';
import { readyProject } from './ready-courses';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { file } = useFolder();

/** Light as it is without the arena, in the middle of the range, and on the bare floor. */
const [BY_HAND, ON_THE_FLOOR] = ['127', '255'];
const LIGHT = 'from microbit import *\nimport mbrobot\nprint(display.read_light_level())\n';
const program = file('light.py', LIGHT);
const projectWith = (name: string, settings?: Partial<ProjectSettings>): string => {
  const project: Project = { files: [{ name: 'main.py', text: LIGHT }], scene: defaultScene(), course: null };
  return file(
    `${name}.json`,
    projectToText(settings ? { ...project, settings: { ...defaultProjectSettings, ...settings } } : project),
  );
};
const measured = (...args: string[]): string => lastLine(parcours('run', ...args, '--json').out).console.trim();

describe('a board on a robot, on the command line', { timeout: 60_000 }, () => {
  it('feels the arena where a program alone runs, unless --senses switches it off', () => {
    expect(measured(program)).toBe(ON_THE_FLOOR);
    expect(measured(program, '--scene', 'slalom')).toBe(ON_THE_FLOOR);
    expect(measured(program, '--senses', 'off')).toBe(BY_HAND);
  });

  it('feels what the project says, and nothing in one of before that says nothing', () => {
    expect(measured(projectWith('old'))).toBe(BY_HAND);
    expect(measured(projectWith('off', {}))).toBe(BY_HAND);
    expect(measured(projectWith('on', { arenaSenses: true }))).toBe(ON_THE_FLOOR);
    expect(measured(projectWith('switched'), '--senses', 'on')).toBe(ON_THE_FLOOR);
  });

  it.each(['closed-line', 'forward-maqueen-lite'])('feels it in a check of the ready %s', (id) => {
    expect(readyProject(id)?.settings?.arenaSenses).toBe(true);
  });

  it('keeps what the input file sets', () => {
    const inputs = file('hand.json', '[{ "at": "0s", "sensor": "lightLevel", "value": 12 }]');
    expect(measured(program, '--input', inputs)).toBe('12');
  });

  it('refuses another word for --senses', () => {
    expect(parcours('run', program, '--senses', 'maybe').err).toContain(
      'parcours: --senses: "maybe" is neither on nor off.',
    );
  });
});
