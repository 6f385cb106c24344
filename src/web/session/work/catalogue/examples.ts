import { MAIN, type Project, type SourceFile } from '#project/project';
import { robotTypes } from '#robots/index';
import type { RobotExample, RobotType } from '#robots/robot';
import { robotSheets } from '#robots/sheets';
import type { Scene } from '#scene/scene';

import type { Language } from '../../../kit/i18n/texts';
import type { Course } from '#catalogue/course';
import { readyCourses } from './ready-courses';
import { isSameArena } from './same-arena';

/** A sample program and the robot that it comes with. */
export interface ExampleOf {
  readonly robot: RobotType;
  readonly example: RobotExample;
}

/** The sample programs of a robot, for any arena. */
export function examplesOf(robot: RobotType): readonly ExampleOf[] {
  const sheet = robotSheets.find((one) => one.robot === robot.id);
  return (sheet?.examples ?? []).map((example) => ({ robot, example }));
}

/** The sample programs of all robots, in the order of the robots. */
export const examples: readonly ExampleOf[] = robotTypes.flatMap(examplesOf);

/** Programs that come with courses and examples. Solutions are left out: a pupil who wrote the same has written it. */
const brought: ReadonlySet<string> = new Set([
  ...readyCourses.flatMap((course) => [course, ...course.devices].flatMap(({ program }) => Object.values(program))),
  ...examples.flatMap(({ example }) => Object.values(example.source)),
]);

/**
 * A sample program as something to work on: in the arena it is made for and with what it needs on the robot. An arena
 * that the pupil built or changed stays as it is.
 */
export function withExample(before: Project, { example }: ExampleOf, language: Language): Project {
  const files = [{ name: MAIN, text: example.source[language] }];
  const open = readyCourses.find(({ scene }) => isSameArena(scene, before.scene));
  const course = readyCourses.find(({ id }) => id === example.course) ?? open;
  if (open === undefined || course === undefined) return { ...before, files };
  return { files, scene: withOptions(course, example), course: course.id };
}

/** The course's arena, its robot set up for an example. */
function withOptions({ scene }: Course, { options }: RobotExample): Scene {
  return { ...scene, robot: { ...scene.robot, options: { ...scene.robot.options, ...options } } };
}

/**
 * True if the arena is just as a ready course has it, but for the robot's options: nothing of the pupil's own is in it.
 */
export function isReadyArena(scene: Scene): boolean {
  return readyCourses.some(
    (course) => course.scene.objects.length === scene.objects.length && isSameArena(course.scene, scene),
  );
}

/** True if the files are just as some course or example brought them: nothing of the pupil's own is in them. */
export function isUntouched({ files, course, devices }: Project): boolean {
  if (devices === undefined) return isBrought(files);
  // A device that the pupil has added is their own, whatever it runs.
  const asBrought = readyCourses.find(({ id }) => id === course)?.devices.length;
  return asBrought === 1 + devices.others.length && [{ files }, ...devices.others].every((one) => isBrought(one.files));
}

function isBrought([main, ...others]: readonly SourceFile[]): boolean {
  if (others.length > 0 || main === undefined) return false;
  return main.text.trim() === '' || brought.has(main.text);
}
