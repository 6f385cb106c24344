import type { InputAction } from '#simulation/input';

/** Least simulated time between two changes of a button, in µs. Chosen: the board needs up to 44 ms to notice one. */
export const LEAST_PRESS_US = 60_000;

/** The button or pad that an action presses or lets go; `null`: it does something else. */
export function pressOf(action: InputAction): { readonly id: string; readonly down: boolean } | null {
  if (action.type === 'button') return { id: action.button === 'a' ? 'buttonA' : 'buttonB', down: action.down };
  if (action.type === 'touch') return { id: action.pad, down: action.down };
  if (action.type !== 'sensor' || typeof action.value !== 'number' || !/^(button|pin)/.test(action.id)) return null;
  return { id: action.id, down: action.value >= 0.5 };
}

/** Tells when an action takes effect, in µs of simulated time. @param nowUs simulated time now */
export type TimeOfInput = (action: InputAction, nowUs: number) => number;

/**
 * Everything that is done before a program begins takes effect at its first moment, where a button that was pressed and
 * let go would never have been down. So a second change of a button follows the first one as a finger would.
 */
export function createFirstPresses(): TimeOfInput {
  const changedUs = new Map<string, number>();
  return (action, nowUs) => {
    const id = pressOf(action)?.id;
    if (id === undefined) return nowUs;
    const lastUs = changedUs.get(id);
    const timeUs = lastUs === undefined ? nowUs : Math.max(nowUs, lastUs + LEAST_PRESS_US);
    if (nowUs === 0 || timeUs > nowUs) changedUs.set(id, timeUs);
    else changedUs.delete(id);
    return timeUs;
  };
}
