import type { RuleId } from '../rule-table';

/**
 * What is said of each rule: what is missing, then the way out. `{board}` is the board's name, `{name}` what is
 * written in the program, `{instead}` code that does it on the device.
 */
export type RuleTexts = Readonly<Record<RuleId, string>>;
