// Fields that filter a table: text and choices, each with its label.

import { harmlessName } from '../logic/harmless';

interface SearchProps {
  label: string;
  value: string;
  onChange: (value: string) => void;
}

export function Search({ label, value, onChange }: SearchProps) {
  return (
    <label class="field grows">
      <span>{label}</span>
      <input
        type="search"
        value={value}
        maxLength={200}
        spellcheck={false}
        onInput={(event) => onChange(event.currentTarget.value)}
      />
    </label>
  );
}

export interface Option {
  value: string;
  words: string;
}

interface ChoiceProps extends SearchProps {
  options: readonly Option[];
}

export function Choice({ label, value, options, onChange }: ChoiceProps) {
  return (
    <label class="field">
      <span>{label}</span>
      <select value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {harmlessName(option.words, 60)}
          </option>
        ))}
      </select>
    </label>
  );
}
