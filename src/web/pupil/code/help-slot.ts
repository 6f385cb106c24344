import { Compartment, type Extension } from '@codemirror/state';
import { ViewPlugin, type EditorView } from '@codemirror/view';

import { arrival } from '../../kit/state/arrival';
import { LANGUAGES, type Language } from '../../kit/i18n';
import { memo } from '#core/memo';
import type { HelpMaker, HelpOptions } from './help/help-options';

/** The loaded help, by language. */
const loaded = memo((_: Language) => arrival<HelpMaker>());

/** Completion, cards and hints cost more than the rest of the editor: they come when the editor is used, not before. */
const USES = ['focusin', 'pointermove', 'keydown'] as const;

/** A place for the help on the API, filled when the editor is first used. */
export function helpSlot(options: HelpOptions): Extension {
  const slot = new Compartment();
  const help = loaded(options.language).value;
  if (help !== null) return help.make(options);
  return [slot.of([]), ViewPlugin.define((view) => waitForUse(view, () => fill(view, slot, options)))];
}

function waitForUse(view: EditorView, use: () => Promise<void>): { destroy(): void } {
  const stop = (): void => {
    for (const name of USES) view.dom.removeEventListener(name, first);
  };
  const first = (): void => {
    stop();
    // Without a connection the editor works on without help; the next time it gets the focus it tries again.
    use().catch(() => view.dom.addEventListener('focusin', first, { passive: true }));
  };
  for (const name of USES) view.dom.addEventListener(name, first, { passive: true });
  // It was made again while in use, for instance when the language changed.
  if (LANGUAGES.some((language) => loaded(language).value !== null) || view.hasFocus) queueMicrotask(first);
  return { destroy: stop };
}

async function fill(view: EditorView, slot: Compartment, options: HelpOptions): Promise<void> {
  const { language } = options;
  const before = view.state.doc;
  const help = loaded(language).value ?? (await (await import('./help/help')).loadHelp(language));
  loaded(language).set(help);
  // The editor may show another file by now, or another language; their slots are their own.
  const now = slot.get(view.state);
  if (!Array.isArray(now) || now.length > 0) return;
  view.dispatch({ effects: slot.reconfigure(help.make(options)) });
  if (view.hasFocus && view.state.doc !== before) help.suggestLate(view);
}
