/** Most texts that are held: more than the widest file has names, each of which is looked at several times. */
const MOST = 150_000;

/** A function of a text that remembers its answers: a header's few names are looked at for every system again. */
export function remembered<T>(of: (text: string) => T): (text: string) => T {
  const answers = new Map<string, T>();
  return (text) => {
    const known = answers.get(text);
    if (known !== undefined) return known;
    const answer = of(text);
    if (answers.size >= MOST) answers.clear();
    answers.set(text, answer);
    return answer;
  };
}
