import { nothingMeasured, type MyRobot } from '#my-robot/my-robot';
import { parseProject, projectToText } from '#project/file';
import {
  defaultProjectSettings,
  MAIN,
  projectLimits,
  type FurtherDevice,
  type HardwareWish,
  type Project,
  type SourceFile,
} from '#project/project';
import type { ProjectProblem } from '#project/problem';
import { applyEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { DeviceSetup, RunSetup } from '#simulation/run-setup';

/**
 * The project that a recorded run was made from, as far as a run knows it: the way back from `runSetup`. Its course is
 * that at the end of the run.
 *
 * @param called name of a measured robot, which a run does not know
 * @returns what is wrong, if a project cannot have what this run has
 */
export function projectOfRun(
  setup: RunSetup,
  called: string,
): { readonly project: Project } | { readonly problems: readonly ProjectProblem[] } {
  const [first, ...others] = setup.devices;
  const { seed, reality } = setup;
  const { min, max } = projectLimits.seed;
  const mine = robotOf(first, called);
  const project: Project = {
    files: filesOf(first),
    scene: lastCourse(setup),
    course: null,
    settings: {
      ...hardwareOf(first),
      reality,
      seed: Number.isInteger(seed) && seed >= min && seed <= max ? seed : defaultProjectSettings.seed,
      arenaSenses: sensesFromStart(setup),
      ...(mine && { myRobot: mine }),
    },
    ...(others.length > 0 && { devices: { first: first.name, others: others.map(furtherOf) } }),
  };
  // The limits of a project are those of its file.
  return parseProject(projectToText(project));
}

/** The program first, as tabs have it. */
const filesOf = ({ files }: DeviceSetup): readonly SourceFile[] =>
  Object.entries({ [MAIN]: '', ...files }).map(([name, text]) => ({ name, text }));

const hardwareOf = ({ board, firmware, robot, robotOptions }: DeviceSetup): HardwareWish => ({
  device: board,
  firmware: firmware ?? '',
  robot,
  robotOptions: robotOptions && Object.keys(robotOptions).length > 0 ? { [robot]: robotOptions } : {},
});

const furtherOf = (device: DeviceSetup): FurtherDevice => ({
  name: device.name,
  ...hardwareOf(device),
  files: filesOf(device),
  sameAs: '',
});

const robotOf = ({ robot, traits }: DeviceSetup, name: string): MyRobot | null =>
  traits ? { name, robot, used: true, measured: nothingMeasured, traits } : null;

/** The course with all that was changed while the run went on. */
const lastCourse = ({ scene, inputs = [] }: RunSetup): Scene =>
  inputs.reduce((course, { action }) => (action.type === 'edit' ? applyEdit(course, action.edit) : course), scene);

const sensesFromStart = ({ inputs = [] }: RunSetup): boolean =>
  inputs.some(({ timeUs, action }) => timeUs === 0 && action.type === 'arena-senses' && action.on);
