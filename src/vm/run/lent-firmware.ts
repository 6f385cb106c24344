import { instantiateFirmware, type Instantiated } from './firmware';
import { applyChange, changeSince, type StateChange } from './vm-state';

/** The copies of a module that nobody runs, and the state of one that was just made. */
interface Spare {
  readonly asMade: StateChange;
  readonly gas: number;
  readonly copies: Instantiated[];
}

/** Most copies that wait, of 4 MiB each. Chosen: a run of several devices, or one run after the other. */
const MOST_SPARE = 4;

const spares = new WeakMap<WebAssembly.Module, Spare>();

/**
 * A copy of the firmware as it is made; one that was given back is brought into that state. So runs that follow each
 * other need no new memory, of which JavaScript's collector would have to get rid, and with it of the machine code that
 * knew the copy.
 */
export function lendFirmware(module: WebAssembly.Module): Instantiated {
  const spare = spares.get(module);
  const again = spare?.copies.pop();
  if (spare && again) {
    again.memory.bytes.fill(0);
    applyChange(spare.asMade, again.firmware, again.memory);
    again.firmware.gas.value = spare.gas;
    return again;
  }
  const made = instantiateFirmware(module);
  if (!spare) spares.set(module, { asMade: stateAsMade(made), gas: made.firmware.gas.value, copies: [] });
  return made;
}

/** Gives a copy back that its borrower no longer uses, and in which nothing runs. */
export function giveBack(module: WebAssembly.Module, copy: Instantiated): void {
  copy.release();
  const copies = spares.get(module)?.copies;
  // One that was in the midst of being suspended, by a fault, is not used again.
  const isWhole = copy.firmware.asyncify_get_state() === 0 && !copy.flow.isRewinding;
  if (copies && isWhole && copies.length < MOST_SPARE) copies.push(copy);
}

const stateAsMade = ({ firmware, memory }: Instantiated): StateChange =>
  changeSince({ bytes: new Uint8Array(memory.bytes.length), globals: new Map() }, firmware, memory);
