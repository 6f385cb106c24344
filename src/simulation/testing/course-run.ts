import { existsSync, readFileSync } from 'node:fs';
import { parseInputs } from '#cli/input-file';
import { parseScene } from '#scene/parse';
import type { DeviceSetup, RunSetup } from '../run-setup';

const read = (path: string): string => readFileSync(new URL(`../../../courses/${path}`, import.meta.url), 'utf8');

/** What `course.json` says of the devices of a course that has several. */
interface CourseData {
  readonly devices?: readonly { readonly name: string; readonly robot: string }[];
}

/**
 * The run of a ready course: with its solution and whoever presses what it needs, or as a pupil finds it, with nobody.
 * Folders without a `course.json` have one device.
 */
export function courseRun(folder: string, seed: number, which: 'solution' | 'start' = 'solution'): RunSetup {
  const parsed = parseScene(read(`${folder}/scene.json`));
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  const { scene } = parsed;
  const data = existsSync(new URL(`../../../courses/${folder}/course.json`, import.meta.url)) ? read(`${folder}/course.json`) : '{}'; // prettier-ignore
  const [first, ...others] = (JSON.parse(data) as CourseData).devices ?? [{ name: '1', robot: 'auto' }];
  const further = others.map(({ name, robot }): DeviceSetup => {
    const files = { 'main.py': read(`${folder}/${name}${which === 'start' ? '-start' : ''}.py`) };
    return { name, files, robot, board: 'auto' };
  });
  const files = { 'main.py': read(`${folder}/${which === 'start' ? 'start' : 'main'}.py`) };
  const own = { name: first?.name ?? '1', files, robot: first?.robot ?? 'auto', board: 'auto' };
  return { scene, devices: [own, ...further], seed, reality: 0, inputs: which === 'start' ? [] : inputsOf(folder) };
}

function inputsOf(folder: string): RunSetup['inputs'] & object {
  if (!existsSync(new URL(`../../../courses/${folder}/inputs.json`, import.meta.url))) return [];
  const parsed = parseInputs(read(`${folder}/inputs.json`));
  if ('problem' in parsed) throw new Error(`${folder}/inputs.json ${parsed.problem}`);
  return parsed.inputs;
}
