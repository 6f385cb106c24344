import { shallowRef, type Component, type ShallowRef } from 'vue';

import type { TextKey, TextValues } from './i18n/texts';

/** One answer to a question. */
export interface Choice {
  readonly key: TextKey;
  readonly values?: TextValues;
  readonly look?: 'run' | 'stop' | 'outline';
  readonly run: () => void;
}

/** A question in a dialog: with answers to choose from, a file name to type, or a form. */
export type Question =
  | {
      readonly kind: 'choose';
      readonly title: TextKey;
      readonly text: TextKey;
      readonly values: TextValues;
      readonly choices: readonly Choice[];
    }
  | {
      readonly kind: 'file-name';
      readonly title: TextKey;
      readonly values: TextValues;
      /** The name the file has now; absent for a new file. */
      readonly own?: string;
      readonly done: (name: string) => void;
    }
  /** A form of its own; it emits `close` when it is done. */
  | { readonly kind: 'form'; readonly title: () => string; readonly form: Component };

/** The current question; further ones wait for their turn. */
export interface DialogsModel {
  readonly current: Readonly<ShallowRef<Question | null>>;
  ask(question: Question): void;
  close(): void;
}

export function createDialogs(): DialogsModel {
  const current = shallowRef<Question | null>(null);
  const waiting: Question[] = [];
  return {
    current,
    ask: (question) => {
      if (current.value === null) current.value = question;
      else waiting.push(question);
    },
    close: () => {
      current.value = waiting.shift() ?? null;
    },
  };
}
