import { robotTypes } from '#robots/index';
import type { RobotExample, RobotType } from '#robots/robot';
import { robotSheets } from '#robots/sheets';

import { courses } from './courses';
import type { Project } from './project';

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

/** Those of all robots, in their order. */
export const examples: readonly ExampleOf[] = robotTypes.flatMap(examplesOf);

const brought: ReadonlySet<string> = new Set([
  ...courses.flatMap(({ program }) => Object.values(program)),
  ...examples.flatMap(({ example }) => [example.source.de, example.source.en]),
]);

/** The files are just as some course or example brought them: nothing of the pupil's own is in them. */
export function isUntouched(project: Project): boolean {
  const [main, ...others] = project.files;
  if (others.length > 0 || main === undefined) return false;
  return main.text.trim() === '' || brought.has(main.text);
}
