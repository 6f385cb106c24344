/** The probes, and what each of their rows would change. */
import { robotTypes } from '#robots/index';
import errors from '../../../docs/hardware/probe/errors.py?raw';
import floats from '../../../docs/hardware/probe/floats.py?raw';
import memory from '../../../docs/hardware/probe/memory.py?raw';
import sound from '../../../docs/hardware/probe/sound.py?raw';
import timing from '../../../docs/hardware/probe/timing.py?raw';

/** A program that prints a table. */
export interface Probe {
  readonly source: string;
  /** Id of the robot that it asks, or `none`. */
  readonly robot: string;
  /** The source files with the project's values for its rows: by patterns of ids, the first that fits. */
  readonly tells: readonly { readonly id: RegExp; readonly file: string }[];
}

const COSTS = 'src/board/boards/nrf52833-costs.ts';
const IN_C = 'src/vm/firmware/work-in-c.mjs';
const always = (file: string): Probe['tells'] => [{ id: /./, file }];
const bare = { robot: 'none' };

const sources = import.meta.glob<string>('../../../docs/hardware/probe/*.py', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** The probes of robots, found by their names: `maqueen_lite.py` asks the robot `maqueen-lite`. */
function robotProbes(): Readonly<Record<string, Probe>> {
  const found: Record<string, Probe> = {};
  for (const { id } of robotTypes) {
    const name = id.replaceAll('-', '_');
    const source = sources[`../../../docs/hardware/probe/${name}.py`];
    if (source !== undefined) found[name] = { source, robot: id, tells: always(`src/robots/${id}`) };
  }
  return found;
}

/** By name; `radio` needs two boards, and is only read. */
export const probes: Readonly<Record<string, Probe | undefined>> = {
  timing: {
    ...bare,
    source: timing,
    tells: [
      { id: /^(sum|sorted|99 in|l\[|','\.join|s\.find|big|str\(big|l\.index|bytes)/, file: IN_C },
      { id: /./, file: COSTS },
    ],
  },
  floats: {
    ...bare,
    source: floats,
    tells: [
      { id: /^math\./, file: 'docs/decisions/0034-single-floats.md' },
      { id: /^seed/, file: 'src/vm/run/hal' },
      { id: /./, file: 'src/vm/run/single-float-text.ts' },
    ],
  },
  errors: { ...bare, source: errors, tells: always('src/vm/firmware/words.mjs') },
  memory: { ...bare, source: memory, tells: always('src/vm/run') },
  sound: {
    ...bare,
    source: sound,
    tells: [
      { id: /^speech/, file: 'docs/decisions/0010-a-voice-of-our-own.md' },
      { id: /^display/, file: 'src/board/display' },
      { id: /./, file: 'src/board/sound' },
    ],
  },
  ...robotProbes(),
};

/** The source file with the project's value for a row. */
export const keptIn = (program: string, id: string): string =>
  probes[program]?.tells.find((tell) => tell.id.test(id))?.file ?? COSTS;
