import { onScopeDispose } from 'vue';

import type { Clipboard } from './state/clipboard';
import type { PasteParts } from './paste-given';
import type { SelectionActs } from './state/selection-acts';

/** How long a browser has to send the event of a key, in ms; then the clipboard of this page alone is used. Chosen. */
const EVENT_MS = 80;

/** Gives the system's clipboard what was copied, by asking; browsers may refuse. */
export async function writeSystem(clipboard: Clipboard): Promise<void> {
  if (clipboard.text === null) return;
  try {
    await navigator.clipboard.writeText(clipboard.text);
    clipboard.isWithSystem = true;
  } catch {
    // the page's own clipboard has it
  }
}

/** The models that the clipboard works with. */
export interface ClipboardPorts {
  readonly app: PasteParts;
  /** Does something at once if the acts are loaded, and else as soon as they are. */
  readonly withActs: (act: (acts: SelectionActs) => void) => void;
  /** True if Ctrl+V pastes into the arena now. */
  readonly pastes: (target: EventTarget | null) => boolean;
}

/** The keys of the clipboard, as they are pressed. */
export interface ClipboardKeys {
  copy(cuts: boolean): void;
  paste(): void;
}

/**
 * Copies to and pastes from the system's clipboard, so that things go from tab to tab. The browser's own events give and
 * take the text without asking for leave; where they do not come, the page's own clipboard is used.
 */
export function useClipboard({ app, withActs, pastes }: ClipboardPorts): ClipboardKeys {
  const { clipboard } = app.editor;
  /** Something was copied by a key; the browser's event is to come. */
  let isCopying = false;
  let pasting: ReturnType<typeof setTimeout> | null = null;

  function give(event: ClipboardEvent): void {
    if (!isCopying || clipboard.text === null || event.clipboardData === null) return;
    isCopying = false;
    event.clipboardData.setData('text/plain', clipboard.text);
    clipboard.isWithSystem = true;
    event.preventDefault();
  }

  function take(event: ClipboardEvent): void {
    if (pasting === null && !pastes(event.target)) return;
    stopWaiting();
    const picture = [...(event.clipboardData?.files ?? [])].find(({ type }) => type.startsWith('image/'));
    const text = event.clipboardData?.getData('text/plain') ?? '';
    event.preventDefault();
    if (picture !== undefined) app.panels.offer(picture);
    else withActs((acts) => void import('./paste-given').then(({ pasteGiven }) => pasteGiven(app, acts, text)));
  }

  function stopWaiting(): void {
    if (pasting !== null) clearTimeout(pasting);
    pasting = null;
  }

  const listeners = { copy: give, cut: give, paste: take } as const;
  for (const [name, listener] of Object.entries(listeners)) addEventListener(name, listener as EventListener);
  onScopeDispose(() => {
    stopWaiting();
    for (const [name, listener] of Object.entries(listeners)) removeEventListener(name, listener as EventListener);
  });
  return {
    copy(cuts) {
      withActs((acts) => {
        acts[cuts ? 'cut' : 'copy']();
        isCopying = true;
        setTimeout(() => {
          if (isCopying) void writeSystem(clipboard); // no event has come
          isCopying = false;
        }, EVENT_MS);
      });
    },
    paste() {
      stopWaiting();
      pasting = setTimeout(() => {
        pasting = null;
        withActs((acts) => acts.paste());
      }, EVENT_MS);
    },
  };
}
