import type { AttachmentType } from './attachment';
import { claw } from './claw/claw';
import { forklift } from './forklift/forklift';
import { loader } from './loader/loader';
import { push } from './push/push';

/** All kinds of attachments. */
export const attachmentTypes: readonly AttachmentType[] = [claw, forklift, loader, push];

/** The kind with this id, or `null`: nothing hangs there. */
export function findAttachment(id: string | undefined): AttachmentType | null {
  return attachmentTypes.find((type) => type.id === id) ?? null;
}
