import { existsSync, readFileSync } from 'node:fs';
import { feelingInputs } from '../feeling';
import { parseInputs } from '../input-file';
import { parseScene } from '#scene/parse';
import type { DeviceSetup, RunSetup } from '../run-setup';

const at = (path: string): URL => new URL(`../../../courses/${path}`, import.meta.url);
const read = (path: string): string => readFileSync(at(path), 'utf8');

/** The part of `course.json` on the devices of a course that has several. */
interface CourseData {
  readonly devices?: readonly { readonly name: string; readonly robot: string }[];
}

/**
 * The run of a ready course, whose boards feel the arena as in all new work: with its solution and whoever presses what
 * it needs, or as a pupil finds it, with nobody. Folders without a `course.json` have one device.
 */
export function courseRun(folder: string, seed: number, which: 'solution' | 'start' = 'solution'): RunSetup {
  const parsed = parseScene(read(`${folder}/scene.json`));
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  const { scene } = parsed;
  const data = existsSync(at(`${folder}/course.json`)) ? read(`${folder}/course.json`) : '{}';
  const [first, ...others] = (JSON.parse(data) as CourseData).devices ?? [{ name: '1', robot: 'auto' }];
  const further = others.map(({ name, robot }): DeviceSetup => {
    const begins = `${folder}/${name}-start.py`;
    const files = { 'main.py': read(which === 'start' && existsSync(at(begins)) ? begins : `${folder}/${name}.py`) };
    return { name, files, robot, board: 'auto' };
  });
  const files = { 'main.py': read(`${folder}/${which === 'start' ? 'start' : 'main'}.py`) };
  const own = { name: first?.name ?? '1', files, robot: first?.robot ?? 'auto', board: 'auto' };
  const devices = [own, ...further] as const;
  const pressed = which === 'start' ? [] : inputsOf(folder);
  return { scene, devices, seed, reality: 0, inputs: [...feelingInputs(devices), ...pressed] };
}

function inputsOf(folder: string): RunSetup['inputs'] & object {
  if (!existsSync(at(`${folder}/inputs.json`))) return [];
  const parsed = parseInputs(read(`${folder}/inputs.json`));
  if ('problem' in parsed) throw new Error(`${folder}/inputs.json ${parsed.problem}`);
  return parsed.inputs;
}
