/** A state's symbol: a rate has a dot over its letter, drawn, for few fonts have one that sits well. */
import { MathSymbol } from '../symbol.tsx';
import type { StateName } from './names.ts';

export function StateSymbol({ state, name }: { state: StateName | undefined; name: string }) {
  return <span class={state?.rate ? 'dotted' : undefined}><MathSymbol of={state?.symbol ?? name} /></span>;
}
