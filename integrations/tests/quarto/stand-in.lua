-- A stand-in for Quarto, which is not in Debian: gives the shortcode what Quarto gives it, in Pandoc, which Quarto is built on. A paragraph
-- `SHORTCODE 1` stands for the first of the calls in calls.lua.

quarto = {
  project = { directory = ".", offset = "." },
  doc = { is_format = function(name) return FORMAT:match("^" .. name) ~= nil end },
}

local shortcodes = dofile("_extensions/river-seed/river-seed.lua")
local calls = dofile("calls.lua")

function Para(paragraph)
  local number = pandoc.utils.stringify(paragraph):match("^SHORTCODE (%d+)$")
  if not number then return end
  local map, alt = table.unpack(calls[tonumber(number)])
  -- Quarto gives an empty list for what is not named.
  local kwargs = setmetatable({ alt = alt and pandoc.Inlines({ pandoc.Str(alt) }) }, { __index = function() return pandoc.Inlines({}) end })
  paragraph.content = { shortcodes["river-seed"](map and { pandoc.Inlines({ pandoc.Str(map) }) } or {}, kwargs, {}) }
  return paragraph
end
