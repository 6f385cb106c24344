import { lockNames, type Locks } from './task';

/**
 * True if a pupil's page has left something unlocked that the task locks. Locked lines are looked for in the program
 * itself.
 */
export function isUnlocked(wanted: Locks, theirs: Locks): boolean {
  const { tools } = wanted;
  // Where the whole course is locked, tools say nothing more.
  const freesTools =
    tools !== null &&
    !wanted.course &&
    !theirs.course &&
    !(theirs.tools?.every((tool) => tools.includes(tool)) ?? false);
  return freesTools || lockNames.some((name) => isLock(wanted[name]) && wanted[name] !== theirs[name]);
}

const isLock = (lock: Locks[keyof Locks]): boolean => lock !== false && lock !== null;
