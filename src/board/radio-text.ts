/** Bytes that `radio.send` puts before the UTF-8 of its text: micropython-microbit-v2 modradio.c. */
const TEXT_PREFIX: readonly number[] = [1, 0, 1];

/** The packet that `radio.send` makes of a text. */
export function packetOfText(text: string): Uint8Array {
  return Uint8Array.from([...TEXT_PREFIX, ...new TextEncoder().encode(text)]);
}

/** The bytes of the text in a packet that `radio.send` made, or `null` for any other packet. */
export function textBytesOf(packet: readonly number[]): Uint8Array | null {
  const isText = TEXT_PREFIX.every((byte, place) => packet[place] === byte);
  return isText ? Uint8Array.from(packet.slice(TEXT_PREFIX.length)) : null;
}
