import { shallowRef, type Component, type ShallowRef } from 'vue';

import type { Texts } from '#core/languages';
import type { TextKey, TextValues } from './i18n/texts';

/** One answer to a question. */
export interface Choice {
  readonly key: TextKey | Texts;
  readonly values?: TextValues;
  readonly look?: 'run' | 'stop' | 'outline';
  readonly run: () => void;
}

/** The field of a question for a name, see `NameForm`. */
export interface NameField {
  /** Id of the field on the page. */
  readonly id: string;
  /** Above the field. */
  readonly label: string;
  /** The present name; empty for a new thing. */
  readonly own: string;
  /** Completes typed text to a name. */
  readonly complete: (typed: string) => string;
  /** The fault of a name, in words, or `null`. */
  readonly problem: (name: string) => string | null;
  /** Shown while nothing is typed. */
  readonly placeholder?: string;
  /** True for text that is read letter by letter, as in a program. */
  readonly mono?: boolean;
  readonly submit: string;
}

/** A question in a dialog: with answers to choose from, a name to type, or a form. */
export type Question =
  | {
      readonly kind: 'choose';
      readonly title: TextKey | Texts;
      readonly text: TextKey | Texts;
      readonly values: TextValues;
      readonly choices: readonly Choice[];
    }
  | {
      readonly kind: 'name';
      readonly title: TextKey;
      readonly values: TextValues;
      readonly field: () => NameField;
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
