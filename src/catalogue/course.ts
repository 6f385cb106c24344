import type { Language, Texts } from '#core/languages';
import { anyHardware, MAIN, type Project } from '#project/project';
import type { Scene } from '#scene/scene';

import type { Mission } from './mission-place';

/** A ready course: an arena with a task, and programs that drive in it. How its folder looks: see `courses.ts`. */
export interface Course {
  /** Name of its folder. */
  readonly id: string;
  /** Place in the list, lowest first; `null`: at the end. */
  readonly place: number | null;
  readonly level: CourseLevel;
  readonly kind: CourseKind;
  readonly scene: Scene;
  /** The initial program of a course: a beginning, or without one the solution. By the language of its words. */
  readonly program: Readonly<Record<Language, string>>;
  /** The program that does what the course asks for. */
  readonly solution: Readonly<Record<Language, string>>;
  readonly texts: Readonly<Record<Language, CourseTexts>>;
  /** Its devices, the first one with the course's robot and programs; empty: there is one. */
  readonly devices: readonly CourseDevice[];
  /** Made from a number, without a folder: the user works on a course of their own. */
  readonly isRandom: boolean;
  /** Its place on the ladder of missions, where it belongs to it. */
  readonly mission?: Mission;
}

/** A device of a course that has several. */
export interface CourseDevice {
  readonly name: Texts;
  /** Id of its robot, `none` for a board in the hand, or `auto`. */
  readonly robot: string;
  readonly program: Texts;
  readonly solution: Texts;
}

/** Difficulty of a course: 1 easy, 2 medium, 3 hard. */
export type CourseLevel = 1 | 2 | 3;

/** Topics of courses, in the order of the gallery. */
export const courseKinds = ['free', 'line', 'drive', 'obstacles', 'maze', 'blocks'] as const;
export type CourseKind = (typeof courseKinds)[number];

/** Texts of a course: its name, its description and its task. */
export interface CourseTexts {
  readonly name: string;
  /** One or two sentences on what it is about. */
  readonly text: string;
  /** The pupil's task. */
  readonly task: string;
  /** Opened one by one, the gentlest first. */
  readonly hints?: readonly string[];
}

/** A course as something to work on. */
export function projectOf(course: Course, language: Language): Project {
  const files = [{ name: MAIN, text: course.program[language] }];
  const [first, ...others] = course.devices.map(({ name, robot, program }) => ({
    ...{ ...anyHardware, robot, name: name[language], sameAs: '' },
    files: [{ name: MAIN, text: program[language] }],
  }));
  const devices = first && { first: first.name, others };
  return { files, scene: course.scene, course: course.isRandom ? null : course.id, ...(devices && { devices }) };
}
