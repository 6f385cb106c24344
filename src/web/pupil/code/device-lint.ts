import { linter, type Diagnostic } from '@codemirror/lint';
import { StateEffect, type Extension } from '@codemirror/state';
import { ViewPlugin, type EditorView } from '@codemirror/view';

import { checkForDevice } from '#device-check/check-for-device';
import { explain } from '#device-check/explain';
import type { Finding } from '#device-check/finding';
import { loadRuleTexts } from '#device-check/rule-texts';
import { devicePanel } from './device-panel';
import { deviceLook } from './device-look';
import type { DeviceMarksOptions, DeviceQuestion } from './device-question';
import { slipMarks } from './slip-hints';
import { contextOf } from '../../session/work/hardware/written-for';

/** How long a pupil has stopped typing before the text is checked. Chosen: longer than between two keys. */
const PAUSE_MS = 700;

/** The question has changed: the text has to be checked again. */
const checkAgain = StateEffect.define();

/** Marks in the text and in the gutter, an explanation when pointed at, and a line below the text that explains. */
export function deviceLint({ question, onChange }: DeviceMarksOptions): Extension {
  return [
    linter((view) => diagnosticsOf(view, question()), {
      delay: PAUSE_MS,
      needsRefresh: ({ transactions }) => transactions.some(({ effects }) => effects.some((it) => it.is(checkAgain))),
    }),
    ViewPlugin.define((view) => ({ destroy: onChange(() => view.dispatch({ effects: checkAgain.of(null) })) })),
    devicePanel(() => question()?.board ?? ''),
    deviceLook,
  ];
}

async function diagnosticsOf(view: EditorView, question: DeviceQuestion | null): Promise<readonly Diagnostic[]> {
  if (question === null) return [];
  const { file, files, device, written } = question;
  const findings = checkForDevice({ ...files, [file]: view.state.doc.toString() }, device).filter(
    (finding) => finding.file === file,
  );
  const slips = await slipMarks(view, contextOf(written()));
  return [...slips, ...(findings.length === 0 ? [] : await explained(findings, question))];
}

/** Marks with their sentences. Without a connection to fetch these there are no marks; the next check tries again. */
async function explained(findings: readonly Finding[], { board, language }: DeviceQuestion): Promise<Diagnostic[]> {
  const texts = await loadRuleTexts(language).catch(() => null);
  if (texts === null) return [];
  return findings.map((finding) => ({
    from: finding.from,
    to: finding.to,
    severity: finding.severity === 'error' ? 'warning' : 'info',
    message: explain(finding, board, texts),
  }));
}
