import type { EmbeddedSimulator, SimulatorEvent } from './simulator';

/** Listens for a dialect that knows of one microcomputer: what comes from further ones is not for it. */
export const listenToFirst = (
  simulator: Pick<EmbeddedSimulator, 'listen'>,
  listener: (event: SimulatorEvent) => void,
): (() => void) =>
  simulator.listen((event) => {
    if (!('device' in event)) listener(event);
  });
