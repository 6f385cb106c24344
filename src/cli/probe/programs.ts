/** The probes, and what each of their rows would change. */
import bitbotXl from '../../../docs/hardware/probe/bitbot_xl.py?raw';
import callibot from '../../../docs/hardware/probe/callibot.py?raw';
import errors from '../../../docs/hardware/probe/errors.py?raw';
import floats from '../../../docs/hardware/probe/floats.py?raw';
import maqueenLite from '../../../docs/hardware/probe/maqueen_lite.py?raw';
import maqueenPlusV2 from '../../../docs/hardware/probe/maqueen_plus_v2.py?raw';
import memory from '../../../docs/hardware/probe/memory.py?raw';
import motionkit2 from '../../../docs/hardware/probe/motionkit_2.py?raw';
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
  maqueen_lite: { source: maqueenLite, robot: 'maqueen-lite', tells: always('src/robots/maqueen-lite') },
  maqueen_plus_v2: { source: maqueenPlusV2, robot: 'maqueen-plus-v2', tells: always('src/robots/maqueen-plus-v2') },
  bitbot_xl: { source: bitbotXl, robot: 'bitbot-xl', tells: always('src/robots/bitbot-xl') },
  callibot: { source: callibot, robot: 'callibot', tells: always('src/robots/callibot') },
  motionkit_2: { source: motionkit2, robot: 'motionkit-2', tells: always('src/robots/motionkit-2') },
};

/** The source file with the project's value for a row. */
export const keptIn = (program: string, id: string): string =>
  probes[program]?.tells.find((tell) => tell.id.test(id))?.file ?? COSTS;
