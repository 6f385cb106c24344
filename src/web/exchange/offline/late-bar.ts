import type * as Messages from '../../kit/bar/messages';

/** Lets the bar say something; what that needs comes with the first message. Without a connection nothing is said. */
export async function lateBar(say: (messages: typeof Messages) => void): Promise<void> {
  const messages = await import('../../kit/bar/messages').catch(() => null);
  if (messages !== null) say(messages);
}
