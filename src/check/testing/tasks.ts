/** Tasks and hand-ins for tests. */
import { readFileSync } from 'node:fs';
import { parseScene } from '#scene/parse';
import { defaultScene, type Scene, type SceneObject, type Zone } from '#scene/scene';
import type { Carried, Project } from '#project/project';
import { check, type Checker } from '../check';
import { handInOfFiles, handInOf } from '../hand-in/read-hand-in';
import type { CheckResult } from '../result';
import { taskOf } from '../task/read-task';
import type { ClassTask } from '../task/task';

let compiled: WebAssembly.Module | null = null;

/** The VM, compiled once for all tests. */
export const firmware = (): WebAssembly.Module =>
  (compiled ??= new WebAssembly.Module(readFileSync(new URL('../../../.cache/vm/vm.wasm', import.meta.url))));

/** A ready course. */
export function readyScene(id: string): Scene {
  const parsed = parseScene(readFileSync(new URL(`../../../courses/${id}/scene.json`, import.meta.url), 'utf8'));
  if ('scene' in parsed) return parsed.scene;
  throw new Error(parsed.problem);
}

/** The solution of a ready course. */
export const readySolution = (id: string): string =>
  readFileSync(new URL(`../../../courses/${id}/main.py`, import.meta.url), 'utf8');

/** The default arena with these things, and the robot at its left, heading right. */
export const sceneWith = (objects: readonly SceneObject[], change: Partial<Scene> = {}): Scene => ({
  ...defaultScene(),
  objects,
  ...change,
  robot: { ...defaultScene().robot, at: [200, 450], ...change.robot },
});

/** A target, round, 200 mm wide. */
export const targetAt = (x: number, y: number, id = 't'): Zone => ({
  ...{ type: 'target', id, at: [x, y], size: [200, 200], angle: 0, round: true, number: 0, blocks: 0 },
});

/** A checkpoint of the same size. */
export const checkpointAt = (x: number, y: number, number: number): SceneObject => ({
  ...{
    type: 'checkpoint',
    id: `c${String(number)}`,
    at: [x, y],
    size: [200, 200],
    angle: 0,
    round: true,
    number,
    blocks: 0,
  },
});

/** A project of a course with an empty program. */
export const projectWith = (scene: Scene, text = ''): Project => ({
  ...{ files: [{ name: 'main.py', text }], scene, course: null },
});

/** A task as its project says it; throws what is wrong with it. */
export function taskWith(scene: Scene, data: Carried = {}): ClassTask {
  const read = taskOf({ ...projectWith(scene), task: { version: 1, ...data } });
  if ('task' in read) return read.task;
  throw new Error(read.problem);
}

/** The result of a program. */
export const checked = (task: ClassTask, program: string, checker: Partial<Checker> = {}): Promise<CheckResult> =>
  check(task, handInOfFiles([{ name: 'main.py', text: program }]), { firmware: firmware(), ...checker });

/** The result of a project. */
export function checkedProject(task: ClassTask, project: Project): Promise<CheckResult> {
  const read = handInOf(project);
  if ('problem' in read) throw new Error(read.problem);
  return check(task, read.handIn, { firmware: firmware() });
}

/** Drives ahead for this many ms. */
export const ahead = (ms: number): string =>
  `from mbrobot import *\nsetSpeed(50)\nforward()\ndelay(${String(ms)})\nstop()\n`;
