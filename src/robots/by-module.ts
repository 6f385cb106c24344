import { robotTypes } from './index';
import type { RobotType } from './robot';

/** The spelling that stands for all others: in lower case, without underscores. */
export const plainName = (name: string): string => name.toLowerCase().replaceAll('_', '');

/** True if one of these is a module that the robot brings along. */
export const bringsOneOf = ({ modules }: RobotType, imported: ReadonlySet<string>): boolean =>
  modules.some((name) => imported.has(name));

/** The robot one of whose drivers by others is among these, under its usual name; `null`: none. */
export function robotOfDrivers(imported: ReadonlySet<string>): RobotType | null {
  const goesBy = (named: (driver: string) => boolean) => robotTypes.find((type) => type.driverNames?.some(named));
  const plain = new Set(Array.from(imported, plainName));
  return goesBy((driver) => imported.has(driver)) ?? goesBy((driver) => plain.has(driver)) ?? null;
}

/** The robot to which a word belongs that is no module here: a driver by others, a module in another spelling. */
export function robotNamed(word: string): RobotType | null {
  const isPlainly = (module: string): boolean => plainName(module) === plainName(word);
  return robotOfDrivers(new Set([word])) ?? robotTypes.find(({ modules }) => modules.some(isPlainly)) ?? null;
}
