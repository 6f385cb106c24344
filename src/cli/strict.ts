import type { Language } from '#core/languages';
import { checkForDevice } from '#device-check/check-for-device';
import { explain } from '#device-check/explain';
import type { Device } from '#device-check/finding';
import { loadRuleTexts } from '#device-check/rule-texts';
import words from './words';

/** The result of `--strict` for a program. */
export interface StrictReport {
  /** One line for each finding, `main.py:3:7: f-strings …`, each with its newline; empty without findings. */
  readonly text: string;
  /** Number of findings that would stop the device: more than 0 is an error. */
  readonly count: number;
  /** The first line of `text` that is an error; empty without errors. */
  readonly first: string;
  /** Findings that only change a result, such as numbers with more digits than on the device. Listed as hints. */
  readonly hints: number;
}

/**
 * Lists what runs in these files here but not on the device.
 *
 * @param files the program and the files given with it, by their names on the board
 * @param board name of the board in the sentences: `micro:bit V2`
 */
export async function strictReport(
  files: Readonly<Record<string, string>>,
  board: string,
  device: Device,
  language: Language,
): Promise<StrictReport> {
  const texts = await loadRuleTexts(language);
  const findings = checkForDevice(files, device);
  const lines = findings.map((finding) => {
    const kind = finding.severity === 'hint' ? words.hint[language] : '';
    return `${finding.file}:${finding.line}:${finding.column}: ${kind}${explain(finding, board, texts)}\n`;
  });
  const hints = findings.filter(({ severity }) => severity === 'hint').length;
  const first = lines[findings.findIndex(({ severity }) => severity === 'error')]?.trimEnd() ?? '';
  return { text: lines.join(''), count: findings.length - hints, first, hints };
}
