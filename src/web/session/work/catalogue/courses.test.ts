import { readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { boardTypes, findBoard } from '#board/boards/index';
import { isSame } from '#core/same';
import { checkForDevice } from '#device-check/check-for-device';
import { importedModules } from '#python/imports';
import { chooseHardware } from '#simulation/hardware';
import { setLanguage } from '../../../kit/i18n';
import { LANGUAGES } from '../../../kit/i18n/texts';
import { courseKinds, projectOf } from '#catalogue/course';
import { coursesOf, withSolution } from '#catalogue/read-courses';
import { readyCourse } from './ready-courses';
import { courses } from '#catalogue/courses';
import { courseTask } from './course-words';
import { examples, isUntouched } from './examples';
import { courseName, firstCourse, isAsFound } from './first-course';
import { findProblems } from '#scene/rules';
import { defaultScene, type Scene } from '#scene/scene';

const guessed = (scene: Scene, text: string, robot = 'auto') =>
  chooseHardware({ scene, imports: new Set(importedModules(text)), robot, board: 'auto' });

describe('the programs that come with the app', () => {
  it('have nothing that the device check would mark on their board, so a first visit need not load it', () => {
    const ofCourses = courses.flatMap(({ scene, program, solution }) =>
      [...Object.values(program), ...Object.values(solution)].map((text) => ({ scene, text })),
    );
    const ofRobots = examples.flatMap(({ example, robot }) => LANGUAGES.map((language) => ({ robot, text: example.source[language] }))); // prettier-ignore
    expect(ofCourses.length + ofRobots.length).toBeGreaterThan(3);
    for (const { text, ...where } of [...ofCourses, ...ofRobots]) {
      const scene = 'scene' in where ? where.scene : defaultScene();
      const robot = 'robot' in where ? where.robot.id : 'auto';
      const hardware = guessed(scene, text, robot);
      const firmware = 'problem' in hardware ? boardTypes[0]!.firmwares[0] : hardware.firmware;
      expect(checkForDevice({ 'main.py': text }, firmware), text).toEqual([]);
    }
  });

  it('each choose a robot on its own board when everything is left to the program and the course', () => {
    for (const { id, scene, program, solution } of courses)
      for (const text of [...Object.values(program), ...Object.values(solution)]) {
        const hardware = guessed(scene, text);
        if ('problem' in hardware) throw new Error(`${id}: ${hardware.problem}`);
        expect(hardware.robot, id).not.toBeNull();
        expect(hardware.board, id).toBe(findBoard(hardware.robot!.board));
      }
  });

  it('count as untouched until a letter is changed; two files are the pupil’s own', () => {
    for (const course of courses)
      for (const language of LANGUAGES) {
        const project = projectOf(course, language);
        expect(isUntouched(project), course.id).toBe(true);
        const isStart = isSame(projectOf(withSolution(course), language), project);
        expect(isUntouched(projectOf(withSolution(course), language)), course.id).toBe(isStart); // it may be the pupil's own
        const [main] = project.files;
        expect(isUntouched({ ...project, files: [{ ...main!, text: `${main!.text}#` }] })).toBe(false);
        expect(isUntouched({ ...project, files: [main!, { name: 'a.py', text: '' }] })).toBe(false);
      }
    for (const { example } of examples)
      for (const language of LANGUAGES) {
        const files = [{ name: 'main.py', text: example.source[language] }];
        expect(isUntouched({ ...projectOf(courses[0]!, 'de'), files }), example.file).toBe(true);
      }
  });
});

describe('a ready course with several devices', () => {
  const course = courses.find(({ id }) => id === 'remote-control')!;

  it('opens with all of them, each with its beginning or its solution, named in the language', () => {
    const { devices, files } = projectOf(course, 'de');
    expect([devices?.first, devices?.others.map(({ name, robot }) => [name, robot])]).toEqual([
      'Roboter',
      [['Fernbedienung', 'none']],
    ]);
    expect(files[0]?.text).toContain('# Aufgabe');
    expect(devices?.others[0]?.files[0]?.text).toContain('radio.send("vor")');
    const solution = projectOf(withSolution(course), 'fr');
    expect(solution.devices?.others[0]?.files[0]?.text).toContain('order = "gauche"');
    expect(solution.files[0]?.text).toContain('order == "gauche"');
  });

  it('is the pupil’s own as soon as a further device is written on, added or taken away', () => {
    const project = projectOf(course, 'en');
    const [remote] = project.devices?.others ?? [];
    if (remote === undefined || project.devices === undefined) throw new Error('There should be a remote control.');
    const { devices, ...alone } = project;
    const written = { ...remote, files: [{ name: 'main.py', text: `${remote.files[0]?.text ?? ''}#` }] };
    expect(isUntouched({ ...project, devices: { ...devices, others: [written] } })).toBe(false);
    expect(isUntouched({ ...project, devices: { ...devices, others: [remote, { ...remote, name: 'B' }] } })).toBe(
      false,
    );
    expect(isUntouched(alone)).toBe(true); // nothing is lost: the course brings it back
  });
});

describe('the ready courses', () => {
  const folders = readdirSync('courses', { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && !['board', 'golden', 'missions'].includes(entry.name))
    .map(({ name }) => name);

  it('are all listed, each at a place of its own', () => {
    expect(courses.map(({ id }) => id).sort()).toEqual(folders.sort());
    const places = courses.map(({ place }) => place);
    expect(places).not.toContain(null);
    expect(new Set(places).size).toBe(places.length);
    expect([...places].sort((one, other) => one! - other!)).toEqual(places);
  });

  it('have a name, a sentence, a task and programs in German and English, in Swiss spelling', () => {
    for (const { id, texts, program, solution } of courses)
      for (const language of LANGUAGES) {
        const { name, text, task } = texts[language];
        expect(name, id).not.toBe('');
        expect(text, id).toMatch(/[.!?]$/);
        expect(task, id).toMatch(/[.!?]$/);
        expect(program[language], id).toMatch(/import/);
        expect(solution[language], id).toMatch(/import/);
        expect(Object.values(texts.de).join(' ') + program.de + solution.de, id).not.toContain('ß');
      }
  });

  it('are nineteen or more, of all kinds, of all levels and for four robots', () => {
    expect(courses.length).toBeGreaterThanOrEqual(19);
    expect(new Set(courses.map(({ kind }) => kind))).toEqual(new Set(courseKinds));
    expect(new Set(courses.map(({ level }) => level))).toEqual(new Set([1, 2, 3]));
    const lines = courses.filter(({ kind }) => kind === 'line');
    expect(new Set(lines.map(({ level }) => level))).toEqual(new Set([1, 2, 3])); // line tracks of three difficulties
    const robots = courses.map(({ scene, solution }) => {
      const hardware = guessed(scene, solution.en);
      return 'problem' in hardware ? '' : hardware.robot?.id;
    });
    expect(new Set(robots)).toEqual(new Set(['maqueen-lite', 'maqueen-plus-v2', 'maqueen-plus-v3', 'callibot']));
  });

  it('have nothing that the editor would find fault with', () => {
    for (const { id, scene, solution } of courses) {
      const hardware = guessed(scene, solution.en);
      if ('problem' in hardware) throw new Error(`${id}: ${hardware.problem}`);
      expect(findProblems(scene, hardware.robot?.body.outlineMm ?? []), id).toEqual([]);
    }
  });

  it('leave the task to the pupil: all but the empty arena and the closed line begin with a program to go on with', () => {
    const asSolved = courses.filter(({ program, solution }) => program.de === solution.de).map(({ id }) => id);
    expect(asSolved).toEqual(['empty', 'closed-line']);
    for (const { id, program, solution } of courses)
      for (const language of LANGUAGES)
        if (!asSolved.includes(id))
          expect(program[language].split('\n').length, id).toBeLessThan(solution[language].split('\n').length + 4);
  });

  it('begin with the first mission on a first visit, which comes with the page', () => {
    expect(firstCourse?.id).toBe('forward-maqueen-lite');
    expect(firstCourse).toEqual(readyCourse('forward-maqueen-lite'));
    const project = projectOf(firstCourse!, 'en');
    expect(isAsFound(project)).toBe(true);
    expect(isAsFound({ ...project, files: [{ name: 'main.py', text: 'print(1)' }] })).toBe(false);
  });

  it('are called in the chosen language, courses of others as their file says', async () => {
    Object.assign(globalThis, { document: { documentElement: {} } });
    await setLanguage('en');
    const maze = courses.find(({ id }) => id === 'small-maze')!;
    expect([courseName(maze.scene, maze.id), courseTask(maze)]).toEqual([maze.texts.en.name, maze.texts.en.task]);
    await setLanguage('de');
    expect(courseName(maze.scene, maze.id)).toBe('Kleines Labyrinth');
    expect(courseName({ ...maze.scene, name: 'Von Anna' }, null)).toBe('Von Anna');
    expect(courseName({ ...maze.scene, name: '' }, null)).toBe('Ohne Namen');
  });
});

describe('the files of a course', () => {
  const scene = { ...defaultScene(), name: 'A', description: 'B.' };

  const inAll = (text: string) => ({ de: `${text} de`, fr: `${text} fr`, it: `${text} it`, en: text });
  const scenes = { 'c/a/scene.json': scene };
  const main = { 'c/a/main.py': { source: inAll('main') } };

  it('hold the solution, which a pupil finds where there is no beginning', () => {
    const [course] = coursesOf({ scenes, data: {}, main, start: {} });
    expect(course!.solution).toEqual(inAll('main'));
    expect(course!.program).toEqual(inAll('main'));
  });

  it('may hold a beginning besides the solution: then that is what a pupil finds', () => {
    const [course] = coursesOf({ scenes, data: {}, main, start: { 'c/a/start.py': inAll('start') } });
    expect(course!.program).toEqual(inAll('start'));
    expect(course!.solution).toEqual(inAll('main'));
    expect(projectOf(withSolution(course!), 'en').files).toEqual([{ name: 'main.py', text: 'main' }]);
  });

  it('speak as the scene does where there are no texts, and stand at the end then', () => {
    const z = { source: inAll('main'), name: { ...inAll('A'), de: 'Z' }, text: inAll('Z.') };
    const all = coursesOf({
      scenes: { ...scenes, 'c/z/scene.json': scene },
      data: { 'c/z/course.json': '{"place":9}' },
      main: { ...main, 'c/z/main.py': z, 'c/without-scene/main.py': z },
      start: {},
    });
    expect(all.map(({ id, texts }) => [id, texts.de.name, texts.en.name, texts.en.task])).toEqual([
      ['z', 'Z', 'A', 'B.'],
      ['a', 'A', 'A', 'B.'],
    ]);
  });
});
