import { courseEditorOf } from '../../course/editor/state/parts';
import { useCommandKeys } from '../../kit/command-keys';
import type { SetUp } from '../../session/models/session';
import { commandsOf } from './use-commands';
import { useLinks } from './use-links';

/** Opens links, and saves with Ctrl+S. */
export const setUp: SetUp = (session) => {
  useLinks(session);
  useCommandKeys({ s: commandsOf({ ...session, ...courseEditorOf(session) }).save });
};
