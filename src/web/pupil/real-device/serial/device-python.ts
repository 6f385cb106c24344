/** A text as a Python literal, in pure ASCII. */
export function pythonText(text: string): string {
  const signs = Array.from(text, (sign) => {
    const code = sign.codePointAt(0) ?? 0;
    if (code >= 0x20 && code < 0x7f && sign !== "'" && sign !== '\\') return sign;
    if (code < 0x80) return `\\x${hex(code, 2)}`;
    return code > 0xffff ? `\\U${hex(code, 8)}` : `\\u${hex(code, 4)}`;
  });
  return `'${signs.join('')}'`;
}

/** Bytes as a Python literal, in pure ASCII: readable where possible, so that programs hardly grow. */
export function pythonBytes(bytes: Uint8Array): string {
  const signs = Array.from(bytes, (byte) => {
    if (byte === 0x0a) return '\\n';
    if (byte === 0x27 || byte === 0x5c) return `\\${String.fromCharCode(byte)}`;
    return byte >= 0x20 && byte < 0x7f ? String.fromCharCode(byte) : `\\x${hex(byte, 2)}`;
  });
  return `b'${signs.join('')}'`;
}

const hex = (code: number, digits: number): string => code.toString(16).padStart(digits, '0');

/** A file's fingerprint: its length and the two sums of Adler-32, in the form that the device prints. */
export function fingerprint(bytes: Uint8Array): string {
  let [a, b] = [1, 0];
  for (const byte of bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return `${bytes.length} ${a} ${b}`;
}

/**
 * The pieces of Python that the device runs. Names are short and pieces small, because a micro:bit has 64 kB of memory.
 * Its modules can neither compute hashes nor append to a file, so the sum is our own and the file stays open between
 * pieces.
 */
export const devicePython = {
  /** Prints the device's name for itself. */
  about: 'import os\ntry:\n print(os.uname().machine)\nexcept Exception:\n print("?")',
  /** Prints 1 if one of the modules exists, else 0. */
  hasModule: (names: readonly string[]): string =>
    `r=0\nfor n in ${names.map(pythonText).join(',')},:\n try:\n  __import__(n)\n  r=1\n except ImportError:\n  pass\nprint(r)`,
  /** Makes the function that prints a file's fingerprint, `-` if the file does not exist. */
  prepare: [
    'def _p(n):',
    ' try:',
    '  f=open(n,"rb")',
    ' except OSError:',
    '  print("-")',
    '  return',
    ' s=0',
    ' a=1',
    ' b=0',
    ' while True:',
    '  d=f.read(64)',
    '  if not d:',
    '   break',
    '  s+=len(d)',
    '  for c in d:',
    '   a=(a+c)%65521',
    '   b=(b+a)%65521',
    ' f.close()',
    ' print(s,a,b)',
  ].join('\n'),
  fingerprint: (name: string): string => `_p(${pythonText(name)})`,
  remove: (name: string): string => `os.remove(${pythonText(name)})`,
  open: (name: string): string => `f=open(${pythonText(name)},"wb")`,
  write: (piece: Uint8Array): string => `f.write(${pythonBytes(piece)})`,
  close: 'f.close()',
  openToRead: (name: string): string => `f=open(${pythonText(name)},"rb")`,
  /** Prints the next bytes of the open file as hexadecimal digits; nothing at its end. */
  read: 'print("".join(["%02x"%c for c in f.read(128)]))',
  /** Prints the names of all files, one per line. */
  list: 'for n in os.listdir():\n print(n)',
} as const;
