import { courseEditorOf } from '../../course/editor/state/parts';
import { useCommandKeys } from '../../kit/command-keys';
import type { SetUp } from '../../session/models/session';
import { commandsOf } from './use-commands';
import { useLinks } from './use-links';

/** Opens links; saves with Ctrl+S and opens with Ctrl+O. */
export const setUp: SetUp = (session) => {
  useLinks(session);
  const { save, load } = commandsOf({ ...session, ...courseEditorOf(session) });
  useCommandKeys({ s: save, o: load });
};
