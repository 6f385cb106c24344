import type { Extension } from '@codemirror/state';
import { shallowRef } from 'vue';

import { lateModel } from '../../kit/state/late-models';

/** Makes the extension that protects a file's locked lines in the editor; `null`: no task with locks is open. */
export const lockedText = lateModel(() => shallowRef<((file: string) => Extension) | null>(null));
