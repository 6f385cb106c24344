import type { OptionValues } from '#core/option';
import { DEVICE_NAME_CHARACTERS, deviceNameProblem } from '#project/devices';
import { IN_HAND } from '#robots/in-hand';

/** A further device from the command line: `NAME=PROGRAM.py[,robot=ID|none][,board=ID][,option=CHOICE][,file=DRIVER.py]`. */
export interface DeviceOption {
  readonly name: string;
  readonly program: string;
  /** Further files on its board. */
  readonly files: readonly string[];
  /** Id of a robot type, `none`, or `auto`: the one whose module the program imports, else none. */
  readonly robot: string;
  /** Id of a board type, or `auto`: the one whose own module the program imports, else the robot's. */
  readonly board: string;
  /** Options of its robot, or of the bare board. */
  readonly robotOptions: OptionValues;
}

const EXAMPLE = 'remote=remote.py,robot=none';

/** Reads one `--device`; or what is wrong with it, in words. */
export function parseDevice(text: string): DeviceOption | string {
  const [first = '', ...parts] = text.split(',');
  const [, name = '', program = ''] = /^([^=]*)=(.*)$/.exec(first) ?? [];
  if (name === '' || program === '') return `--device: "${text}" is not like ${EXAMPLE}.`;
  if (name.length > DEVICE_NAME_CHARACTERS)
    return `--device: the name "${name}" has ${name.length} characters; the limit is ${DEVICE_NAME_CHARACTERS}.`;
  if (deviceNameProblem(name, []) !== null)
    return `--device: "${name}" cannot be the name of a device. Take one without quotes and without spaces around it.`;
  const files: string[] = [];
  const chosen = new Map<string, string>();
  const options = new Map<string, string>();
  for (const part of parts) {
    const [, key = '', value = ''] = /^(\w+)=(.+)$/.exec(part) ?? [];
    if (key === 'file') files.push(value);
    else if (key === 'option') options.set(...optionIn(value));
    else if (key !== 'robot' && key !== 'board')
      return `--device ${name}: "${part}" is unknown here. Known: robot=ID, board=ID, option=CHOICE, file=DRIVER.py.`;
    else if (chosen.has(key)) return `--device ${name}: ${key} is given twice.`;
    else chosen.set(key, value);
  }
  return {
    ...{ name, program, files, robot: chosen.get('robot') ?? 'auto', board: chosen.get('board') ?? 'auto' },
    robotOptions: Object.fromEntries(options),
  };
}

/** `S1=claw`; a choice alone, such as `gamepad`, is what is in the hand. */
function optionIn(text: string): [id: string, choice: string] {
  const [, id, choice] = /^([^=]+)=(.+)$/.exec(text) ?? [];
  return id === undefined || choice === undefined ? [IN_HAND, text] : [id, choice];
}
