-- A stand-in for Quarto, which is not in Debian: gives the shortcode what Quarto gives it, in Pandoc, which Quarto is built on. A paragraph
-- `SHORTCODE 1` stands for the first of the calls in calls.lua.

local function json_string(text)
  local plain = { b = "\b", f = "\f", n = "\n", r = "\r", t = "\t" }
  return (text:gsub("\\(.)(%x?%x?%x?%x?)", function(sign, code)
    if sign == "u" then return utf8.char(tonumber(code, 16)) end
    return (plain[sign] or sign) .. code
  end))
end

-- Decodes an object of strings, numbers and lists of strings, a member a line, as the command prints it.
local function json_object(text)
  local object, list = {}, nil
  for line in text:gmatch("[^\n]+") do
    local key, value = line:match('^  "([%w_]+)": (.-),?$')
    local said = (value or line):match('^%s*"(.*)",?$')
    if list and said then table.insert(list, json_string(said)) end
    if key then
      list = value:match("^%[") and {} or nil
      object[key] = list or (said and json_string(said)) or tonumber(value)
    end
  end
  return object
end

quarto = {
  json = { decode = json_object },
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
